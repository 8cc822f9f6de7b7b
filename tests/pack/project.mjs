// SPDX-License-Identifier: GPL-3.0-or-later
import { spawnSync } from 'node:child_process'
import { cpSync, mkdirSync, mkdtempSync, readdirSync, rmSync, symlinkSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'

export const ROOT = fileURLToPath(new URL('../../', import.meta.url))
/** The folder of this repository's tools. */
export const BIN = join(ROOT, 'node_modules/.bin')

const PACKED = join(ROOT, 'build/tarball')
/** The node_modules of a project in which the package is installed. The build has installed it. */
export const INSTALLED = join(ROOT, 'build/installed')

/** The package as `npm publish` would upload it. The build has packed it. */
export function tarball() {
  return join(PACKED, readdirSync(PACKED)[0])
}

/** A project outside the repository in which the packed package is installed. */
export class Project {
  #parent

  constructor() {
    this.#parent = mkdtempSync(join(tmpdir(), 'circle-voronoi-'))
    // The documentation installs the package from a clone beside the project.
    symlinkSync(PACKED, join(this.#parent, 'circle-voronoi'))
    this.folder = join(this.#parent, 'project')
    mkdirSync(this.folder)
    writeFileSync(join(this.folder, 'package.json'), JSON.stringify({ private: true, type: 'module' }))
    cpSync(INSTALLED, join(this.folder, 'node_modules'), { recursive: true, verbatimSymlinks: true })
    cpSync(new URL('consumer', import.meta.url), this.folder, { recursive: true })
  }

  path(name) {
    return join(this.folder, name)
  }

  write(name, text) {
    writeFileSync(this.path(name), text)
  }

  /** Runs a program like `run`, in the project's folder. */
  run(program, ...args) {
    return run(this.folder, program, ...args)
  }

  remove() {
    rmSync(this.#parent, { recursive: true, force: true })
  }
}

/** Returns a program's output; throws the output if the program fails. */
export function run(folder, program, ...args) {
  // Playwright sets colors, which would disturb comparisons, and Node's test runner sets a variable that makes its
  // children report to it.
  const env = { ...process.env, FORCE_COLOR: '0', NODE_TEST_CONTEXT: undefined }
  const { status, error, stdout, stderr } = spawnSync(program, args, { cwd: folder, env, encoding: 'utf8' })
  if (status === 0) return stdout
  throw new Error(`${program} ${args.join(' ')} failed: ${error?.message ?? status}\n${stdout}${stderr}`)
}
