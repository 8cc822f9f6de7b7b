// SPDX-License-Identifier: GPL-3.0-or-later
// Starts the interactive parts of a chapter: figures, questions, search, and the record of solved chapters.
import { workOffline } from '../app/offline.ts'
import '../element/index.ts'
import { offerSearch } from '../reading/search.ts'
import { linkFigures } from './figure-links.ts'
import { markSolved } from './progress.ts'
import { askQuestions } from './questions.ts'
import { stepRules } from './rules.ts'
import { slideFigures } from './sliders.ts'
import { followTrials } from './trials.ts'

askQuestions(document)
followTrials(document)
stepRules(document)
slideFigures(document)
linkFigures(document)
markSolved(document)
offerSearch(document)
if (document.querySelector('[data-corrupt]') !== null) {
  const { letCorrupt } = await import('./corrupt.ts')
  letCorrupt(document)
}
if (document.querySelector('output.counts') !== null) {
  const { sayCounts } = await import('./counts.ts')
  // Prepares the counts early, because distant figures become ready late.
  void sayCounts(document)
}
if (document.querySelector('.legend') !== null) {
  const { showLegends } = await import('./legends.ts')
  showLegends(document)
}
if (document.querySelector('figure.printed') !== null) {
  const { followPrinted } = await import('./printed.ts')
  followPrinted(document)
}
if (document.querySelector('[data-rims], [data-steps]') !== null) {
  const { showExtras } = await import('./extras.ts')
  void showExtras(document)
}
if (document.querySelector('[data-drawn]') !== null) {
  const { bringToLife } = await import('./drawn.ts')
  // These figures need the WebAssembly too.
  void bringToLife(document)
}
if (document.querySelector('[data-cones]') !== null) {
  const { turnCones } = await import('./cones.ts')
  turnCones(document)
}
if (document.readyState !== 'complete') await new Promise((resolve) => addEventListener('load', resolve))
await workOffline('../')
