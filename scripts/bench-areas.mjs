// SPDX-License-Identifier: GPL-3.0-or-later
import { voronoiMapSimulation } from 'd3-voronoi-map'
import { ROOT } from './run.mjs'

/** d3-voronoi-map takes hours for more sites. */
const MOST_OF_D3 = 3000
/** More sites take minutes in WebAssembly. */
const MOST_OF_WASM = 10_000

/**
 * Returns a row for each line of the native table about fits of areas: seconds natively and in WebAssembly on the same sites,
 * and, from a cold start, seconds of d3-voronoi-map with its defaults and the relative error of its worst cell. Needs dist/lib.
 */
export async function benchAreas(table) {
  const { loadRegions } = await import(`${ROOT}dist/lib/regions.js`)
  const { region, fitAreas } = await loadRegions()
  const square = region([
    [
      [0, 0],
      [1, 0],
      [1, 1],
      [0, 1],
    ],
  ])
  const lines = [...table.matchAll(/^ *(\d+) +(equal|two decades) +(cold|warm) +(\d+) +([\d.]+) +(\S+) +\d+$/gm)]
  return lines.map(([, count, areas, start, steps, seconds, error]) => {
    const { sites, shares } = problemOf(Number(count), areas === 'equal' ? 0 : 2)
    const row = {
      sites: Number(count),
      areas,
      start,
      steps: Number(steps),
      native: Number(seconds),
      error: Number(error),
    }
    if (sites.length > MOST_OF_WASM) return row
    let weights
    if (start === 'warm') {
      weights = fitAreas(sites, shares, { region: square, shares: true }).weights
      sites[sites.length >> 1][0] += 0.1 / Math.sqrt(sites.length)
    }
    const wasm = secondsOf(() => fitAreas(sites, shares, { region: square, shares: true, weights }))
    if (start === 'warm' || sites.length > MOST_OF_D3) return { ...row, wasm }
    let map
    const d3 = secondsOf(() => {
      map = mapOf(sites, shares)
    })
    return { ...row, wasm, d3, 'times wasm': Number((d3 / wasm).toFixed(1)), 'error of d3': worstError(map, shares) }
  })
}

/** The same problem as in cpp/bench/areas.cpp, except for the last bits of shares. */
function problemOf(count, decades) {
  const unit = randomUnits(count)
  const sites = []
  const shares = []
  for (let i = 0; i < count; i++) {
    sites.push([unit(), unit()])
    shares.push(10 ** (decades * unit()))
  }
  return { sites, shares }
}

/** splitmix64 by Sebastiano Vigna (public domain), as in cpp/src/families/random.h. */
function randomUnits(seed) {
  let state = BigInt(seed)
  return () => {
    state = BigInt.asUintN(64, state + 0x9e3779b97f4a7c15n)
    let z = state
    z = BigInt.asUintN(64, (z ^ (z >> 30n)) * 0xbf58476d1ce4e5b9n)
    z = BigInt.asUintN(64, (z ^ (z >> 27n)) * 0x94d049bb133111ebn)
    return Number((z ^ (z >> 31n)) >> 11n) * 2 ** -53
  }
}

/** The polygons of d3-voronoi-map, with its default of iterations and convergence. */
function mapOf(sites, shares) {
  const data = shares.map((weight, i) => ({ weight, i }))
  const simulation = voronoiMapSimulation(data)
    .clip([
      [0, 0],
      [0, 1],
      [1, 1],
      [1, 0],
    ])
    .initialPosition(({ i }) => sites[i])
    .stop()
  let state = simulation.state()
  while (!state.ended) {
    simulation.tick()
    state = simulation.state()
  }
  return state.polygons
}

function worstError(polygons, shares) {
  const sum = shares.reduce((one, other) => one + other)
  const errors = polygons.map((polygon) => {
    const twice = polygon.reduce((total, [x, y], k) => {
      const [u, v] = polygon[(k + 1) % polygon.length]
      return total + x * v - u * y
    }, 0)
    const target = shares[polygon.site.originalObject.data.originalData.i] / sum
    return Math.abs(Math.abs(twice) / 2 - target) / target
  })
  return Number(Math.max(...errors).toPrecision(2))
}

export function secondsOf(run) {
  const start = performance.now()
  run()
  return Number(((performance.now() - start) / 1000).toPrecision(3))
}
