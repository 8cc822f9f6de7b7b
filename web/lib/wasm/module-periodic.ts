// SPDX-License-Identifier: GPL-3.0-or-later
import type { Metric } from '../base/types.ts'
import { PeriodicDiagram } from '../diagram/periodic-diagram.ts'

/** Converts the result of the module to a periodic diagram of `circleCount` given circles. */
export function periodicOf(
  { circles, diagram, lattice, ...images }: WasmPeriodicDiagram,
  circleCount: number,
  metric: Metric = 'circles',
) {
  const [ax, ay, bx, by] = lattice as unknown as [number, number, number, number]
  return new PeriodicDiagram({
    diagram: { metric, circles, ...diagram },
    circleCount,
    lattice: { a: [ax, ay], b: [bx, by] },
    ...images,
  })
}
