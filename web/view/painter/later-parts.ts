// SPDX-License-Identifier: GPL-3.0-or-later
// One file, as all of it together is small.
export { loadComparison } from '../../lib/wasm/comparison.ts'
export { loadRegions } from '../../lib/wasm/load-regions.ts'
export { answers } from './answers.ts'
export { fitted, fittedEdits } from './fitted-edits.ts'
export { found } from './found.ts'
export { methodResult } from './method-layers.ts'
