// SPDX-License-Identifier: GPL-3.0-or-later
import { Diagram } from './diagram.ts'
import { dataFrom } from './diagram-file.ts'

/**
 * Reads a diagram from the text of a JSON file or from the object that `JSON.parse` makes of it, as
 * `JSON.stringify(diagram)` and the command line write it. Numbers round-trip exactly. The diagram is not checked; use
 * `certify` of the library for that.
 *
 * @throws CircleVoronoiError `badInput`, if it is no such file or an index is none of its circles or vertices;
 *   `negativeRadius`, `coordinateTooLarge`
 *
 * @category Diagrams
 * @example
 * fromJSON(JSON.stringify(diagram)).find(5, 1) // 1
 */
export function fromJSON(json: string | object): Diagram {
  return new Diagram(dataFrom(json))
}
