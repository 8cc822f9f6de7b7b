#!/usr/bin/env node
// SPDX-License-Identifier: GPL-3.0-or-later
// The program circle-voronoi in WebAssembly. It runs in a thread of its own, so that here signals are heard, and the line
// that says how far the work is goes on, while it computes or waits for its input.
import { rmSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { Worker } from 'node:worker_threads'
import { ProgressLine } from './progress-line.ts'
import type { Start, Told } from './thread-messages.ts'

const [command, ...rest] = process.argv.slice(2)
// The only command that is not the core's: it draws as the page does.
if (command === 'picture') {
  const { picture } = await import(new URL('../picture/command.js', import.meta.url).href)
  process.exitCode = await picture(rest, fileURLToPath(import.meta.url))
} else {
  run()
}

/** Runs a command of the core. */
function run(): void {
  const line = new ProgressLine()
  /** A file that is not yet whole. */
  let made: string | undefined

  for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP'] as const) {
    process.once(signal, () => {
      if (made !== undefined) rmSync(made, { force: true })
      // Now that nobody listens, it does what it does to any program.
      process.kill(process.pid, signal)
    })
  }
  // Node ignores this one, of which other programs die without a word. A listener that goes leaves the system's own behind.
  const ignore = () => {}
  process.on('SIGPIPE', ignore).off('SIGPIPE', ignore)

  const ended = new Int32Array(new SharedArrayBuffer(4))
  const workerData: Start = { args: process.argv.slice(2), ended }
  const worker = new Worker(new URL('./program-thread.js', import.meta.url), { workerData })
  worker.on('message', (told: Told) => {
    if ('made' in told) made = told.made
    else if ('line' in told) line.begin(told.line)
    else if ('stage' in told) line.show(told.stage, told.percent)
    else {
      line.end()
      Atomics.store(ended, 0, 1)
      Atomics.notify(ended, 0)
    }
  })
  worker.on('error', ({ message }) => {
    line.end()
    console.error(`circle-voronoi: ${message}`)
  })
  worker.on('exit', (status) => {
    process.exitCode = status
  })
}
