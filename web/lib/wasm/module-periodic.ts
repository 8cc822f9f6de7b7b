// SPDX-License-Identifier: GPL-3.0-or-later
import { PeriodicDiagram } from '../diagram/periodic-diagram.ts'

/** The periodic diagram of `count` circles from a module. */
export function periodicOf({ circles, diagram, lattice, ...images }: WasmPeriodicDiagram, circleCount: number) {
  const [ax, ay, bx, by] = lattice as unknown as [number, number, number, number]
  return new PeriodicDiagram({
    diagram: { metric: 'circles', circles, ...diagram },
    circleCount,
    lattice: { a: [ax, ay], b: [bx, by] },
    ...images,
  })
}
