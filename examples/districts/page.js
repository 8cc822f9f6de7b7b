// SPDX-License-Identifier: GPL-3.0-or-later
// The cities of Europe in districts of equal population
import { loadRegions } from '../../dist/lib/regions.js'
import { districtsOf } from './districts.js'

/** Radius of a city of a million, in kilometers. The areas of the file's circles are proportional to populations. */
const RADIUS = 30
const COLORS = ['#e9b44c', '#6aa5c9', '#d9869f', '#86b98b', '#a99bd0', '#e39a6f', '#9db4a0']

const regions = await loadRegions()
const rows = (await (await fetch('../../public/data/cities.csv')).text()).trim().split('\n').slice(1)
const cities = rows.map((row) => {
  const [x, y, r] = row.split(',').map(Number)
  return { x, y, r, people: (r / RADIUS) ** 2 }
})
const shape = regions.region(await (await fetch('../../public/data/cities.region.json')).json())

const count = document.querySelector('#count')
const picture = document.querySelector('#picture')
const output = document.querySelector('#result')
count.addEventListener('input', draw)
draw()

function draw() {
  document.querySelector('#chosen').value = count.value
  const { diagram, people, error } = districtsOf(regions, cities, Number(count.value), shape)
  const { minX, minY, maxX, maxY } = shape.box
  // Adds a color if the neighbors have all other colors.
  const colors = []
  people.forEach((_, i) => {
    const taken = Array.from(diagram.neighbors(i, { region: shape }), (neighbor) => colors[neighbor])
    colors.push(COLORS.find((color) => !taken.includes(color)) ?? COLORS[i % COLORS.length])
  })
  const cells = people.map((number, i) => {
    const title = `<title>${number.toFixed(2)} million people</title>`
    return `<path d="${diagram.cellPath(i, { region: shape, tolerance: 1 })}" fill="${colors[i]}">${title}</path>`
  })
  const dots = cities.map(({ x, y, r }) => `<circle cx="${x}" cy="${y}" r="${r}" />`)
  // North is up.
  picture.innerHTML = `<svg viewBox="${minX} ${-maxY} ${maxX - minX} ${maxY - minY}" role="img" aria-label="Map of districts">
    <g transform="scale(1,-1)">
      <g stroke="#fff" stroke-width="8">${cells.join('')}</g>
      <g fill="#1d2430" fill-opacity="0.55">${dots.join('')}</g>
    </g>
  </svg>`
  const [least, most] = [Math.min(...people), Math.max(...people)].map((number) => number.toFixed(2))
  output.value = `${people.length} districts of ${least} to ${most} million people: at most ${(100 * error).toFixed(1)} % from the mean`
}
