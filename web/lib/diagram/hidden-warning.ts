// SPDX-License-Identifier: GPL-3.0-or-later
import { checkData } from '../base/check.ts'
import type { DiagramData } from '../base/types.ts'

let isTold = false

/**
 * Returns a sentence for the user if more than a quarter of the circles of a diagram are hidden, because radii in
 * another unit than the coordinates hide most circles; otherwise an empty text. `compute` prints the first such sentence
 * as a console warning.
 *
 * @category Diagrams
 * @example
 * hiddenWarning(library.compute([[0, 0, 500], [3, 4, 120], [9, 1, 80]])) // '2 of 3 circles are hidden inside others and have no cell. Perhaps their radii have another unit than their coordinates, as meters and degrees do, or are diameters or another column.'
 */
export function hiddenWarning(diagram: DiagramData): string {
  checkData(diagram, 'hiddenWarning')
  const { metric, hidden, circles } = diagram
  const [few, all] = [hidden.length / 2, circles.length / 3]
  // By other metrics, circles without a cell need not be hidden inside others.
  if (metric !== 'circles' || 4 * few <= all) return ''
  return `${few} of ${all} circles are hidden inside others and have no cell. Perhaps their radii have another unit than their coordinates, as meters and degrees do, or are diameters or another column.`
}

/** Prints the warning of a diagram on the console, once. Returns the diagram. */
export function withWarning<Given extends DiagramData>(diagram: Given): Given {
  const sentence = isTold ? '' : hiddenWarning(diagram)
  if (sentence !== '') console.warn(`circle-voronoi: ${sentence}`)
  isTold ||= sentence !== ''
  return diagram
}
