// SPDX-License-Identifier: GPL-3.0-or-later
// A treemap in a page. A click on the other year leads there, and each picture on the way is a treemap of its own.
import { loadRegions } from '../../dist/lib/regions.js'
import { disc, peopleIn, YEARS } from './people.js'
import { svgOf } from './svg.js'

const SIZE = 800
const SECONDS = 2.5

const { region, treemap } = await loadRegions()
const whole = region([disc({ x: SIZE / 2, y: SIZE / 2, r: SIZE / 2 - 4 })])
const picture = document.querySelector('#picture')
const output = document.querySelector('output')
const slider = document.querySelector('#year')
const isStill = matchMedia('(prefers-reduced-motion: reduce)')
let root = treemap(peopleIn(YEARS[0]), { region: whole })
let frame = 0
show(YEARS[0])

slider.addEventListener('input', () => {
  cancelAnimationFrame(frame)
  show(Number(slider.value))
})
for (const button of document.querySelectorAll('button')) {
  button.addEventListener('click', () => goTo(Number(button.value)))
}

/** Sites stay where they are, so that cells only grow and shrink. */
function show(year) {
  root = treemap(peopleIn(year), { region: whole, previous: root })
  picture.innerHTML = svgOf(root, SIZE)
  slider.value = year
  const people = root.children.flatMap(({ children }) => children).reduce((sum, { value }) => sum + value, 0)
  output.value = `${Math.round(year)}: ${Math.round(people)} million people`
}

function goTo(year) {
  cancelAnimationFrame(frame)
  if (isStill.matches) return show(year)
  const from = Number(slider.value)
  const start = performance.now()
  const step = (now) => {
    const done = Math.min((now - start) / 1000 / SECONDS, 1)
    show(from + (year - from) * done ** 2 * (3 - 2 * done))
    if (done < 1) frame = requestAnimationFrame(step)
  }
  frame = requestAnimationFrame(step)
}
