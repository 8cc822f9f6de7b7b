// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the thread that no picture of circles and cells alone needs.
import type { Regions } from '../../lib/wasm/regions.ts'
import { isAnythingFound, isMethodShown, type Layers } from '../layers.ts'

/** What some layers need; `undefined`: it is not needed yet, or could not be loaded. */
export interface LayerParts {
  readonly found?: typeof import('./found.ts').found
  readonly methodResult?: typeof import('./method-layers.ts').methodResult
}

/** What regions and areas need. */
export type RegionParts = Regions & Pick<typeof import('./fitted-edits.ts'), 'fitted' | 'fittedEdits'>

/** What layers need. A layer whose part cannot be loaded is not drawn; it may be there the next time. */
export async function layerParts(layers: Layers): Promise<LayerParts> {
  const finding = isAnythingFound(layers) ? import('./found.ts').catch(() => undefined) : undefined
  const method = isMethodShown(layers) ? import('./method-layers.ts').catch(() => undefined) : undefined
  return { ...(await finding), ...(await method) }
}

/** The answers to most questions; `undefined`: they cannot be loaded. */
export async function laterAnswers(): Promise<typeof import('./answers.ts').answers | undefined> {
  return (await import('./answers.ts').catch(() => undefined))?.answers
}
