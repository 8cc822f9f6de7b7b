// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * `<circle-voronoi>` in one file with the WebAssembly inside, for a `<script type="module">` that takes it from anywhere. It is
 * not for bundlers, whose output its thread would not find.
 */
import { answerViews } from '../view/painter/painter-thread.ts'
import { PAINTER_NAME } from '../view/painter-file.ts'

export * from './index.ts'

// The same file is what its thread runs.
const name: unknown = Object(globalThis).name
if (globalThis.document === undefined && name === PAINTER_NAME) answerViews()
