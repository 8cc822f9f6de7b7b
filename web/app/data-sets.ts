// SPDX-License-Identifier: GPL-3.0-or-later
import { parseCircles } from './csv.ts'
import { randomCircles } from './random-circles.ts'

export interface DataSet {
  readonly id: string
  readonly label: string
  /** A new sample each time it is loaded. */
  readonly isRandom?: boolean
  load(): Promise<Float64Array>
}

/** The first one is shown at the start. */
export const DATA_SETS: readonly DataSet[] = [
  { id: 'bronzefilter', label: 'Bronze filter', load: () => fetchCircles('bronzefilter') },
  { id: 'spruces', label: 'Spruces', load: () => fetchCircles('spruces') },
  { id: 'waka', label: 'Waka trees', load: () => fetchCircles('waka') },
  { id: 'introduction', label: 'Introduction', load: () => fetchCircles('introduction') },
  { id: 'random', label: 'Random', isRandom: true, load: async () => randomCircles(300) },
  { id: 'random-large', label: 'Random, 10,000', isRandom: true, load: async () => randomCircles(10_000) },
]

async function fetchCircles(name: string): Promise<Float64Array> {
  const url = new URL(`data/${name}.csv`, document.baseURI)
  const response = await fetch(url)
  if (!response.ok) throw new Error(`The data set ${name} could not be loaded (${response.status}).`)
  return parseCircles(await response.text())
}
