// SPDX-License-Identifier: GPL-3.0-or-later
import type { DiagramData, Float64s } from '../base/types.ts'
import { Diagram } from './diagram.ts'

/**
 * A diagram that `compute` made in this thread, which can be computed again.
 *
 * @category Diagrams
 */
export class ComputedDiagram extends Diagram {
  readonly #compute: (circles: Float64s) => DiagramData

  /** @internal `compute` makes it. */
  constructor(circles: Float64s, compute: (circles: Float64s) => DiagramData) {
    super(compute(circles))
    this.#compute = compute
  }

  /**
   * Computes the diagram again after `circles` was changed in place, with the original options. If that fails, the
   * diagram stays unchanged.
   *
   * @throws CircleVoronoiError as `compute`
   *
   * @example
   * const moving = library.compute([[0, 0, 1], [6, 0, 1], [0, 8, 1]])
   * moving.circles[0] = -2
   * moving.update().find(2.4, 0) // 1
   */
  update(): this {
    this.renew(this.#compute(this.circles))
    return this
  }
}
