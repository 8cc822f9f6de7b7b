// SPDX-License-Identifier: GPL-3.0-or-later
import type { Counted, MethodFound } from '../../view/protocol.ts'
import { wholeNumber } from '../../view/whole-number.ts'

/** Describes the parts of the diagram that the method finds and misses. */
export function saidOf({ vertices, edges, samples }: MethodFound): string {
  const found = ({ all, found }: Counted, name: string) => `${wholeNumber(found)} of ${wholeNumber(all)} ${name}`
  const wrong = [
    ...(vertices.wrong > 0
      ? [`${wholeNumber(vertices.wrong)} wrong ${vertices.wrong === 1 ? 'vertex' : 'vertices'}`]
      : []),
    ...(edges.wrong > 0 ? [`${wholeNumber(edges.wrong)} wrong ${edges.wrong === 1 ? 'edge' : 'edges'}`] : []),
  ]
  const by = samples === 0 ? 'From all pairs' : `From ${wholeNumber(samples)} samples`
  const rest = wrong.length === 0 ? 'nothing that is wrong' : wrong.join(' and ')
  return `${by} the method finds ${found(vertices, 'vertices')} and ${found(edges, 'edges')}, and ${rest}. What is shown stays certified.`
}
