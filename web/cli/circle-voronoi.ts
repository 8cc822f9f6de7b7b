#!/usr/bin/env node
// SPDX-License-Identifier: GPL-3.0-or-later
// The program circle-voronoi in WebAssembly. The program runs in a thread of its own. The main thread handles signals
// and redraws the progress line while the program computes or waits for input.
import { rmSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { Worker } from 'node:worker_threads'
import { ProgressLine } from './progress-line.ts'
import type { Start, Told } from './thread-messages.ts'

const [command, ...rest] = process.argv.slice(2)
// The only command outside the core, because it uses the page's drawing code.
if (command === 'picture') {
  const { picture } = await import(new URL('../picture/command.js', import.meta.url).href)
  process.exitCode = await picture(rest, fileURLToPath(import.meta.url))
} else {
  run()
}

/** Runs a command of the core. */
function run(): void {
  const line = new ProgressLine()
  /** An output file that is still incomplete. */
  let made: string | undefined

  for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP'] as const) {
    process.once(signal, () => {
      if (made !== undefined) rmSync(made, { force: true })
      // With the listener removed, the signal has its default effect.
      process.kill(process.pid, signal)
    })
  }
  // Node ignores SIGPIPE by default, while other programs end silently. Adding and removing a listener restores the
  // default of the system.
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
