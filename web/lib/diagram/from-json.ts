// SPDX-License-Identifier: GPL-3.0-or-later
import { Diagram } from './diagram.ts'
import { dataFrom } from './diagram-file.ts'

/**
 * Reads a diagram from JSON that `JSON.stringify(diagram)` or the command line wrote, as text or as the object that
 * `JSON.parse` returns. Numbers round-trip exactly. The diagram is not checked; use `certify` of the library for that.
 *
 * @throws CircleVoronoiError `badInput`, if the text is not such a diagram or an index is out of range;
 *   `negativeRadius`, `coordinateTooLarge`, `coordinateTooSmall`
 *
 * @category Diagrams
 * @example
 * fromJSON(JSON.stringify(diagram)).find(5, 1) // 1
 */
export function fromJSON(json: string | object): Diagram {
  return new Diagram(dataFrom(json))
}
