// SPDX-License-Identifier: GPL-3.0-or-later
import { directedEdges } from './directed.ts'
import { finalCells } from './final.ts'
import { growing } from './growing.ts'
import { nearestCircle } from './nearest.ts'
import { HEIGHT, type Kind } from './scene.ts'
import { WALK_HEIGHT, walk } from './walk.ts'

/** The figures that the tutorial draws itself, by their names in chapters. */
export const KINDS = {
  nearest: nearestCircle,
  directed: directedEdges,
  growing,
  walk,
  final: finalCells,
} satisfies Record<string, Kind>
export type KindName = keyof typeof KINDS

export function heightOf(kind: KindName): number {
  return kind === 'walk' ? WALK_HEIGHT : HEIGHT
}

export type { Scene } from './scene.ts'
export { HEIGHT, WIDTH } from './scene.ts'
