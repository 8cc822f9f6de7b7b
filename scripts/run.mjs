// SPDX-License-Identifier: GPL-3.0-or-later
import { spawn } from 'node:child_process'
import { fileURLToPath } from 'node:url'

/** The root of the repository, with a slash at the end. */
export const ROOT = fileURLToPath(new URL('..', import.meta.url))

/**
 * Runs a program in the root of the repository with its output shown and without standard input.
 * Resolves with its exit status.
 */
export function statusOf(program, args, env = {}) {
  return ended(start(program, args, env, 'inherit'))
}

/** Runs a program like `statusOf`, and resolves with its output, too. */
export async function outcomeOf(program, args) {
  const child = start(program, args, {}, 'pipe')
  let output = ''
  for (const stream of [child.stdout, child.stderr]) {
    stream.setEncoding('utf8').on('data', (text) => {
      output += text
      process.stdout.write(text)
    })
  }
  return { status: await ended(child), output }
}

function start(program, args, env, output) {
  return spawn(program, args, { cwd: ROOT, stdio: ['ignore', output, output], env: { ...process.env, ...env } })
}

/** Resolves after the last output. */
function ended(child) {
  return new Promise((resolve, reject) => {
    child.once('error', reject)
    child.once('close', (code) => resolve(code ?? 1))
  })
}

/** Like `statusOf`, but throws unless the program succeeds. */
export async function run(program, args, env) {
  const status = await statusOf(program, args, env)
  if (status !== 0) throw new Error(`${program} ${args.join(' ')}\nended with status ${status}.`)
}

/**
 * The environment of scripts of package.json that know their inputs. They run one at a time, because each compiler uses
 * all cores. A cache of former outputs would only grow.
 */
export const WIREIT = { WIREIT_PARALLEL: '1', WIREIT_CACHE: 'none', WIREIT_LOGGER: 'simple' }

/** Runs scripts of package.json that rebuild outdated files. */
export async function build(...scripts) {
  for (const script of scripts) await run('npm', ['run', '--silent', script], WIREIT)
}

/** Runs a script's main function; a failure is one message and exit status 1. */
export async function main(body) {
  try {
    await body()
  } catch (error) {
    console.error(`\n${error.message}`)
    process.exitCode = 1
  }
}

/** Whether the file at `url` is the script that node was started with. */
export function isMain(url) {
  return process.argv[1] !== undefined && fileURLToPath(url) === process.argv[1]
}
