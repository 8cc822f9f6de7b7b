// SPDX-License-Identifier: GPL-3.0-or-later
import { bezierArc } from './bezier.ts'
import { directedEdges } from './directed.ts'
import { finalCells } from './final.ts'
import { globePlane } from './globe-plane.ts'
import { globeRadii } from './globe-radii.ts'
import { growing } from './growing.ts'
import { hyperbola } from './hyperbola.ts'
import { marketAreas } from './market.ts'
import { nearestCircle } from './nearest.ts'
import { newton } from './newton.ts'
import { HEIGHT, type Kind } from './scene.ts'
import { springs } from './springs.ts'
import { twoWeights } from './two-weights.ts'
import { walk } from './walk.ts'
import { weightPlane } from './weight-plane.ts'

/** The figures that the tutorial draws itself, by the names that chapters use. */
export const KINDS: Readonly<Record<KindName, Kind>> = {
  nearest: nearestCircle,
  hyperbola,
  bezier: bezierArc,
  directed: directedEdges,
  growing,
  walk,
  market: marketAreas,
  final: finalCells,
  'weight-plane': weightPlane,
  'two-weights': twoWeights,
  springs,
  newton,
  'globe-radii': globeRadii,
  'globe-plane': globePlane,
}
export type KindName =
  | 'nearest'
  | 'hyperbola'
  | 'bezier'
  | 'directed'
  | 'growing'
  | 'walk'
  | 'market'
  | 'final'
  | 'weight-plane'
  | 'two-weights'
  | 'springs'
  | 'newton'
  | 'globe-radii'
  | 'globe-plane'

export function heightOf(kind: KindName): number {
  return KINDS[kind].height ?? HEIGHT
}

export type { Scene } from './scene.ts'
export { HEIGHT, WIDTH } from './scene.ts'
