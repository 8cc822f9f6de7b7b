// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The library and its worker in one file that contains the WebAssembly, for a `<script type="module">` in any page. Do
 * not use it with bundlers: its worker would not find their output.
 */
// Emscripten's scripts come first: next to one another, they compress to a third of their size.
import './generated/circle-voronoi.js'
import './generated/circle-voronoi-metrics.js'
import './generated/circle-voronoi-regions.js'
import './generated/circle-voronoi-sphere.js'
import { nodeModule } from './base/node.ts'
import { THREAD_NAME } from './threads/thread-file.ts'
import { answerWorker } from './threads/worker-answers.ts'

export * from './index.ts'
export * from './link.ts'
export * from './metrics.ts'
export * from './regions.ts'
export * from './sphere.ts'
export * from './worker.ts'

// The workers run the same file.
const nodeThread = nodeModule('node:worker_threads')
const name: unknown = nodeThread === undefined ? Object(globalThis).name : nodeThread.workerData
if (name === THREAD_NAME) answerWorker()
