// SPDX-License-Identifier: GPL-3.0-or-later
// The panel beside the globe.
import { colorOf } from './colors.js'
import { detailsOf } from './details.js'
import { nameOf } from './table.js'

const byId = (id) => document.getElementById(id)
/** Colors without a column. */
export const OWN_COLORS = { neighbors: 'all different', area: 'area of the cell', radius: 'radius' }

/** Shows the table: how many circles there are, and the choices of columns. */
export function showTable({ table, diagram, colorBy }) {
  const count = diagram.caps.length / 3
  const hidden = diagram.hidden.length / 2
  const circles = `${count.toLocaleString('en')} ${count === 1 ? 'circle' : 'circles'}`
  const inside = hidden === 0 ? '' : `, ${hidden.toLocaleString('en')} hidden inside others`
  byId('summary').querySelector('output').value = `${table.name}: ${circles}${inside}`
  fill(byId('radius'), [['', 'none: points'], ...table.numeric.map((name) => [name, name])], table.radius)
  byId('unit').value = table.unit
  byId('unit').disabled = table.radius === ''
  const columns = Object.keys(table.rows[0] ?? {})
  const own = Object.entries(OWN_COLORS).map(([value, label]) => [`own ${value}`, label])
  fill(byId('color'), [...own, ...columns.map((name) => [`column ${name}`, name])], colorBy)
  byId('save').disabled = false
}

function fill(select, entries, value) {
  select.replaceChildren(...entries.map(([value, label]) => new Option(label, value)))
  select.value = value
}

/** Shows what the colors mean. */
export function showLegend(legend, palette) {
  const list = byId('legend')
  list.hidden = legend.length === 0
  list.replaceChildren(
    ...legend.map(({ color, label }) => {
      const item = document.createElement('li')
      const swatch = document.createElement('span')
      swatch.className = 'swatch'
      swatch.style.background = colorOf(palette, color)
      item.append(swatch, label)
      return item
    }),
  )
}

let last = {}

/** Shows a cell; nothing without a circle. `visit` is called with a neighbor that is clicked. */
export function showCell(shown, circle, visit) {
  // The buttons of a shown cell stay while they are pressed.
  if (last.diagram === shown?.diagram && last.circle === circle) return
  last = { diagram: shown?.diagram, circle }
  byId('cell').hidden = circle === undefined
  if (circle === undefined) return
  const { name, facts, neighbors } = detailsOf(shown, circle)
  byId('cell-name').textContent = name
  byId('facts').replaceChildren(...facts.flatMap(([label, text]) => [element('dt', label), element('dd', text)]))
  byId('neighbors-title').hidden = neighbors.length === 0
  byId('neighbors').replaceChildren(
    ...neighbors.map((neighbor) => {
      const button = element('button', nameOf(shown.table, neighbor))
      button.type = 'button'
      button.addEventListener('click', () => visit(neighbor))
      const item = document.createElement('li')
      item.append(button)
      return item
    }),
  )
}

/** Shows a problem; an empty text hides it. */
export function showProblem(text) {
  byId('problem').hidden = text === ''
  byId('problem').textContent = text
}

function element(name, text) {
  const element = document.createElement(name)
  element.textContent = text
  return element
}
