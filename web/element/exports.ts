// SPDX-License-Identifier: GPL-3.0-or-later
// The common exports of the element's modules.

export type { CellCheck, Check, DiagramCheck, NumberCondition } from '../lib/check-types.ts'
export type {
  Certificate,
  Circles,
  ErrorCode,
  Float64s,
  Options,
  Stats,
} from '../lib/index.ts'
export type { LayerValue, LinkAttributes, LinkFrame, LinkInput, LinkView } from '../lib/link.ts'
export type { RegionShape, RingShape } from '../lib/regions/region-shape.ts'
export type { DiagramCounts } from '../view/diagram-counts.ts'
export type { Areas } from '../view/domain.ts'
export type { CellColors, CellValues, DataLayer, Layers } from '../view/layers.ts'
export type { FigureLoadOptions } from '../view/load.ts'
export {
  CircleVoronoiElement,
  type CircleVoronoiEventMap,
  type Computation,
  type FigureState,
} from './circle-voronoi-element.ts'
export type { FrameMessage, FrameRequest } from './frame-types.ts'
export type { CircleVoronoiProps } from './frameworks.ts'
export type { CellGoalName, DiagramGoalName, Goal } from './goal-types.ts'
