// SPDX-License-Identifier: GPL-3.0-or-later
// Districts of equal population `fitAreas` sets areas, not populations. So this code repeats: fit, count the people,
// make crowded districts smaller.

const ROUNDS = 60
/** The steps become smaller toward the end, when borders pass single cities. */
const BOLDNESS = { first: 0.5, last: 0.05 }
const MOVES = 30

/**
 * Divides cities `{ x, y, people }` among `count` districts of nearly equal population. Returns the diagram whose cells
 * are the districts, and the population of each district. `shape` is the region to divide.
 */
export function districtsOf({ fitAreas }, cities, count, shape) {
  const sites = centersOf(cities, count)
  const goal = cities.reduce((sum, { people }) => sum + people, 0) / count
  let shares = sites.map(() => 1)
  let weights
  let best
  for (let round = 0; round < ROUNDS; round++) {
    const fit = fitAreas(sites, shares, { region: shape, shares: true, tolerance: 1e-3, weights })
    weights = fit.weights
    const people = peopleOf(fit.diagram, cities)
    const error = Math.max(...people.map((number) => Math.abs(number / goal - 1)))
    if (best === undefined || error < best.error) best = { diagram: fit.diagram, people, error }
    const boldness = BOLDNESS.first + (BOLDNESS.last - BOLDNESS.first) * (round / ROUNDS)
    shares = shares.map((share, i) => share * (goal / Math.max(people[i], goal / 4)) ** boldness)
  }
  return best
}

/** Returns `count` points where people live. Each point is in the middle of the people who are nearest to it. */
function centersOf(cities, count) {
  // Begins with the largest cities that are far from one another.
  let reach = 2000
  let centers = []
  while (centers.length < count) {
    reach *= 0.9
    centers = []
    for (const city of cities) {
      if (centers.every(({ x, y }) => Math.hypot(x - city.x, y - city.y) > reach)) centers.push(city)
    }
  }
  centers = centers.slice(0, count)
  for (let move = 0; move < MOVES; move++) {
    const sums = centers.map(() => ({ x: 0, y: 0, people: 0 }))
    for (const { x, y, people } of cities) {
      const distances = centers.map((center) => Math.hypot(center.x - x, center.y - y))
      const sum = sums[distances.indexOf(Math.min(...distances))]
      sum.x += people * x
      sum.y += people * y
      sum.people += people
    }
    centers = sums.map(({ x, y, people }, i) => (people > 0 ? { x: x / people, y: y / people } : centers[i]))
  }
  return centers.map(({ x, y }) => [x, y])
}

function peopleOf(diagram, cities) {
  const people = Array.from({ length: diagram.circles.length / 3 }, () => 0)
  for (const city of cities) people[diagram.find(city.x, city.y)] += city.people
  return people
}
