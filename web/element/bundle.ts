// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * `<circle-voronoi>` in one file that contains the WebAssembly, for a `<script type="module">` in any page. Do not use
 * it with bundlers: its thread would not find their output.
 */
// Imported first, because it contains Emscripten's scripts. Next to one another, they compress to a third of their
// size.
import '../view/painter/other-modules.ts'
import { answerViews } from '../view/painter/painter-thread.ts'
import { THREAD_NAME } from '../view/painter-file.ts'

export * from './index.ts'

// The thread runs the same file.
const name: unknown = Object(globalThis).name
if (globalThis.document === undefined && name === THREAD_NAME) answerViews()
