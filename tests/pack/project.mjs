// SPDX-License-Identifier: GPL-3.0-or-later
import { execFileSync, spawnSync } from 'node:child_process'
import { cpSync, mkdirSync, mkdtempSync, readdirSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'

export const ROOT = fileURLToPath(new URL('../../', import.meta.url))
/** Where the programs of this repository's tools are. */
export const BIN = join(ROOT, 'node_modules/.bin')

/** An empty project outside the repository into which the packed package is installed, without a network. */
export class Project {
  #parent

  constructor() {
    this.#parent = mkdtempSync(join(tmpdir(), 'circle-voronoi-'))
    this.folder = join(this.#parent, 'project')
    const packed = join(this.#parent, 'circle-voronoi')
    for (const folder of [this.folder, packed]) mkdirSync(folder)
    // What `npm pack` would build first is built: the tests' builds are up to date by then.
    execFileSync('npm', ['pack', '--silent', '--ignore-scripts', '--pack-destination', packed], { cwd: ROOT })
    this.tarball = join(packed, readdirSync(packed)[0])
    writeFileSync(join(this.folder, 'package.json'), JSON.stringify({ private: true, type: 'module' }))
    const install = ['install', '--silent', '--offline', '--no-audit', '--no-fund']
    execFileSync('npm', [...install, this.tarball], { cwd: this.folder })
    cpSync(new URL('consumer', import.meta.url), this.folder, { recursive: true })
  }

  path(name) {
    return join(this.folder, name)
  }

  write(name, text) {
    writeFileSync(this.path(name), text)
  }

  /** As `run`, in its folder. */
  run(program, ...args) {
    return run(this.folder, program, ...args)
  }

  remove() {
    rmSync(this.#parent, { recursive: true, force: true })
  }
}

/** What a program prints; throws with that if the program fails. */
export function run(folder, program, ...args) {
  // Playwright asks for colors, which are not for comparing; and Node's runner tells its children to report to it.
  const env = { ...process.env, FORCE_COLOR: '0', NODE_TEST_CONTEXT: undefined }
  const { status, error, stdout, stderr } = spawnSync(program, args, { cwd: folder, env, encoding: 'utf8' })
  if (status === 0) return stdout
  throw new Error(`${program} ${args.join(' ')} failed: ${error?.message ?? status}\n${stdout}${stderr}`)
}
