// SPDX-License-Identifier: GPL-3.0-or-later
// A treemap in a page Click a cell, or reach it with the tab key, to make it grow. Shift makes it shrink.
import { loadRegions } from '../../dist/lib/regions.js'
import { disc, LAND } from './land.js'
import { svgOf } from './svg.js'
import { sumOf, treemap } from './treemap.js'

const SIZE = 800
const GROWTH = 1.25

const regions = await loadRegions()
const whole = regions.region([disc({ x: SIZE / 2, y: SIZE / 2, r: SIZE / 2 - 4 })])
const tree = structuredClone(LAND)
const picture = document.querySelector('#picture')
const output = document.querySelector('output')
draw()

picture.addEventListener('click', ({ target, shiftKey }) => change(target, shiftKey))
picture.addEventListener('keydown', (event) => {
  if (event.key === 'Enter' || event.key === ' ') {
    event.preventDefault()
    change(event.target, event.shiftKey)
  }
})

function change(target, isSmaller) {
  const names = target.dataset?.names
  if (names === undefined) return
  const leaf = names.split('/').reduce(({ children }, name) => children.find((child) => child.name === name), tree)
  leaf.value *= isSmaller ? 1 / GROWTH : GROWTH
  draw()
  picture.querySelector(`[data-names="${CSS.escape(names)}"]`)?.focus()
}

function draw() {
  const start = performance.now()
  const cells = treemap(regions, tree, whole)
  picture.innerHTML = svgOf(cells, SIZE)
  for (const path of picture.querySelectorAll('[data-names]')) {
    path.setAttribute('tabindex', '0')
    path.setAttribute('role', 'button')
  }
  // The relative errors of the cells' areas.
  const total = sumOf(tree)
  const errors = cells.map(({ value, area }) => Math.abs((area / whole.area) * (total / value) - 1))
  output.value = `${cells.length} cells in ${Math.round(performance.now() - start)} ms; the worst area is off by ${Math.max(...errors).toExponential(0)}`
}
