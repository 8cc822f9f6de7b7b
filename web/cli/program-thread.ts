// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the program in a worker thread.
import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { isatty } from 'node:tty'
import { parentPort, workerData } from 'node:worker_threads'
import type { Start, Told } from './thread-messages.ts'

/** The module that Emscripten builds. cpp/wasm/node_files.js names the functions that it calls. */
interface Program {
  callMain(args: readonly string[]): void
}
type CreateProgram = (options: {
  readonly thisProgram: string
  readonly wasmBinary: Uint8Array
  quit(status: number): void
  madeFile(path: string | undefined): void
  showLine(when: string): boolean
  showStage(stage: string, done: number): void
  endLine(): void
}) => Promise<Program>

/** Milliseconds before an automatic progress line is shown. */
const DELAY = 1000
const STANDARD_ERROR = 2

const { args, ended } = workerData as Start
const tell = (told: Told) => parentPort?.postMessage(told)
const last: { stage: string; percent: number | undefined } = { stage: '', percent: undefined }

const createProgram: CreateProgram = createRequire(import.meta.url)('./generated/program.cjs')
const program = await createProgram({
  thisProgram: 'circle-voronoi',
  wasmBinary: readFileSync(new URL('./generated/program.wasm', import.meta.url)),
  quit: (status) => process.exit(status),
  madeFile: (made) => tell({ made }),
  showLine(when) {
    const isShown = when === 'always' || (when === 'auto' && isatty(STANDARD_ERROR))
    if (isShown) tell({ line: when === 'auto' ? DELAY : 0 })
    return isShown
  },
  showStage(stage, done) {
    const percent = done > 0 ? Math.round(100 * done) : undefined
    if (stage === last.stage && percent === last.percent) return
    Object.assign(last, { stage, percent })
    tell({ stage, percent })
  },
  endLine() {
    tell({ ends: true })
    Atomics.wait(ended, 0, 0)
  },
})
program.callMain(args)
