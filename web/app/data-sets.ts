// SPDX-License-Identifier: GPL-3.0-or-later
import type { Float64s } from '../lib/index.ts'
import { parseCircles } from './csv.ts'
import { randomCircles, randomNumbers } from './random-circles.ts'

/** What the menu offers. */
export interface DataSet {
  readonly id: string
  readonly label: string
  /** So many random circles, other ones each time. */
  readonly count?: number
}

/** The first one is shown at the start. */
export const DATA_SETS: readonly DataSet[] = [
  { id: 'bronzefilter', label: 'Bronze filter' },
  { id: 'spruces', label: 'Spruces' },
  { id: 'waka', label: 'Waka trees' },
  { id: 'introduction', label: 'Introduction' },
  { id: 'random', label: 'Random', count: 300 },
  { id: 'random-large', label: 'Random, 10,000', count: 10_000 },
]

/** That of the menu with the circles of this name; `undefined`: there is none. */
export function dataSetOf(name: string): DataSet | undefined {
  const [id, seed] = name.split(':') as [string, string | undefined]
  const dataSet = DATA_SETS.find((dataSet) => dataSet.id === id)
  const isRight = dataSet?.count === undefined ? seed === undefined : /^\d{1,9}$/.test(seed ?? '')
  return isRight ? dataSet : undefined
}

/** A name of a data set's circles, which are always the same; of random ones another name each time. */
export function nameOf({ id, count }: DataSet): string {
  return count === undefined ? id : `${id}:${Math.floor(1e9 * Math.random())}`
}

/** @throws Error, if there are no circles of this name or they cannot be fetched */
export async function loadDataSet(name: string): Promise<Float64s> {
  const dataSet = dataSetOf(name)
  if (dataSet === undefined) throw new Error('There is no data set of this name.')
  if (dataSet.count !== undefined) return randomCircles(dataSet.count, randomNumbers(Number(name.split(':')[1])))
  const url = new URL(`data/${name}.csv`, document.baseURI)
  const response = await fetch(url)
  if (!response.ok) throw new Error(`The data set ${dataSet.label} could not be loaded (${response.status}).`)
  return parseCircles(await response.text())
}
