// SPDX-License-Identifier: GPL-3.0-or-later
// What no picture of circles and cells alone needs is loaded later.
import type { Regions } from '../../lib/wasm/regions.ts'
import { isAnythingFound, isMethodShown, type Layers } from '../layers.ts'

export type LaterParts = typeof import('./later-parts.ts')

/** What regions and areas need. */
export type RegionParts = Regions & Pick<LaterParts, 'fitted' | 'fittedEdits'>

/** `undefined`: it cannot be loaded. It may be there the next time. */
export function laterParts(): Promise<LaterParts | undefined> {
  return import('./later-parts.ts').catch(() => undefined)
}

/** What layers need. If it cannot be loaded, they are not drawn. */
export async function partsOf(layers: Layers): Promise<LaterParts | undefined> {
  return isAnythingFound(layers) || isMethodShown(layers) ? laterParts() : undefined
}
