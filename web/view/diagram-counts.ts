// SPDX-License-Identifier: GPL-3.0-or-later

/** How many circles, hidden circles, vertices and edges a diagram has. */
export interface DiagramCounts {
  readonly circles: number
  readonly hidden: number
  readonly vertices: number
  readonly edges: number
}
