// SPDX-License-Identifier: GPL-3.0-or-later
import { readFileSync } from 'node:fs'
import { expect, it } from 'vitest'
import { borderOfCities, textOf } from '../../scripts/border.mjs'
import { citiesCsv } from '../../scripts/cities.mjs'
import { worldCitiesCsv } from '../../scripts/world-cities.mjs'

const FILE = readFileSync(new URL('../../public/data/cities.csv', import.meta.url), 'utf8')

it('makes the file of cities that is there', () => expect(citiesCsv()).toBe(FILE))

it('makes the file of cities of the world that is there', () => {
  const file = readFileSync(new URL('../../public/data/world-cities.csv', import.meta.url), 'utf8')
  expect(worldCitiesCsv()).toBe(file)
})

it('makes the outline of their land that is there', () => {
  const region = readFileSync(new URL('../../public/data/cities.region.json', import.meta.url), 'utf8')
  expect(textOf(borderOfCities())).toBe(region)
})

it('has as many of them as the chapter says, London first, 932 km from Berlin', () => {
  const cities = FILE.trim()
    .split('\n')
    .slice(1)
    .map((line) => line.split(',').slice(0, 3).map(Number))
  expect(cities).toHaveLength(580)
  const [[x, y], [u, v]] = cities
  // Distances on an equal-area map are right to some thousandths here.
  expect(Math.hypot(x - u, y - v) / 932).toBeCloseTo(1, 2)
})
