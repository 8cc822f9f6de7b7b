// SPDX-License-Identifier: GPL-3.0-or-later

/** The numbers of circles, hidden circles, vertices and edges of a diagram. */
export interface DiagramCounts {
  readonly circles: number
  readonly hidden: number
  readonly vertices: number
  readonly edges: number
}
