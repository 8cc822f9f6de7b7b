// SPDX-License-Identifier: GPL-3.0-or-later
// A globe of circles: the cells of a table of places
import { loadFiles } from 'circle-voronoi/files'
import { loadSphere } from 'circle-voronoi/sphere'
import { askOpener, keep, kept, listenToTables } from './brought.js'
import { Cells } from './cells.js'
import { neighborColors, valueColors } from './colors.js'
import { detailsOf } from './details.js'
import { listenTo } from './gestures.js'
import { showCell, showLegend, showProblem, showTable } from './panel.js'
import { Picture, palette } from './picture.js'
import { saveCells } from './saving.js'
import { nameOf, readTable } from './table.js'
import { dragged, flight, placeAt, turnedBy, viewOf, withPlaceAt, zoomedAt } from './view.js'

// table ──► diagram ──► shown ──┬──► pictures, panel
// pointer, keys ──► view, marks ┘

const byId = (id) => document.getElementById(id)
/** The duration of a flight to a place, in milliseconds. */
const FLIGHT = 600
/** Screen readers hear the cell under the keyboard's cursor once keys have rested for this long, in milliseconds. */
const REST = 400

const globe = byId('globe')
const still = matchMedia('(prefers-reduced-motion: reduce)')
const [files, { computeSphere }] = await Promise.all([loadFiles(), loadSphere()])

/** The table with its diagram, colors and shapes. */
let shown
let view = viewOf([])
/** The circles of the cell under the pointer or the keyboard's cursor, and of the selected cell. */
let hovered
let selected
let hasCursor = false
const picture = new Picture(globe, () => {
  if (shown === undefined) return undefined
  const marked = hovered ?? selected
  return { ...shown, view, marked, name: marked === undefined ? '' : nameOf(shown.table, marked), hasCursor }
})

/** Opens a table that somebody brought, and keeps it. A table with a problem changes nothing. */
function open(given) {
  if (!show(given, 'own neighbors')) return
  const { name, text, radius, unit } = shown.table
  keep({ name, text, radius, unit })
  selected = undefined
  view = viewOf(shown.table.places)
  draw()
}

/** Shows a table, perhaps the same with other columns. */
function show(given, colorBy) {
  try {
    const table = readTable(files, given)
    const diagram = diagramOf(table)
    shown = { table, diagram, cells: new Cells(diagram), colorBy, ...coloringOf(table, diagram, colorBy) }
  } catch ({ message }) {
    showProblem(`${message.replace(/[.\s]*$/, '')}.`)
    return false
  }
  hovered = undefined
  showProblem('')
  showTable(shown)
  showLegend(shown.legend, palette())
  draw()
  return true
}

/** The errors of the library do not know the name of the table. */
function diagramOf({ name, places }) {
  try {
    return computeSphere(places)
  } catch ({ message }) {
    throw new Error(`${name}: ${message.replace(/^Cap /, 'circle ')}`)
  }
}

/** Colors by a choice of the menu: `own` and the name of a measure, or `column` and its name. */
function coloringOf(table, diagram, colorBy) {
  const [, kind, name] = /^(\w+) (.*)$/s.exec(colorBy)
  if (kind === 'own' && name === 'neighbors') return neighborColors(diagram)
  const measures = {
    area: () => [...diagram.cellAreas()],
    radius: () => [...table.places].filter((_, k) => k % 3 === 2),
  }
  return valueColors(diagram, kind === 'own' ? measures[name]() : table.rows.map((row) => row[name]))
}

function draw(isMoving = false) {
  picture.draw(isMoving)
  showCell(shown, hovered ?? selected, visit)
}

function mark() {
  picture.drawMarks()
  showCell(shown, hovered ?? selected, visit)
}

function circleAt(place) {
  if (place === undefined || shown === undefined) return undefined
  const circle = shown.diagram.find(...place)
  return circle < 0 ? undefined : circle
}

let timer

/** Moves the view. The cell under the keyboard's cursor is marked, and said after a while. */
function look(next) {
  view = next
  if (hasCursor) {
    hovered = circleAt([view.longitude, view.latitude])
    clearTimeout(timer)
    timer = setTimeout(() => hovered !== undefined && say(hovered), REST)
  }
  draw(true)
}

function say(circle) {
  byId('said').textContent = detailsOf(shown, circle).sentence
}

let flying = 0

/** Turns the globe to a circle and selects it. */
function visit(circle) {
  const { caps } = shown.diagram
  selected = circle
  hovered = undefined
  say(circle)
  const wayTo = flight(view, [caps[3 * circle], caps[3 * circle + 1]])
  const start = performance.now()
  const fly = (now) => {
    const share = still.matches ? 1 : Math.min(Math.max((now - start) / FLIGHT, 0), 1)
    view = wayTo(share)
    draw(share < 1)
    if (share < 1) flying = requestAnimationFrame(fly)
  }
  cancelAnimationFrame(flying)
  fly(start)
}

/** Stops a flight when somebody takes the globe. */
function taken(action) {
  return (...args) => {
    cancelAnimationFrame(flying)
    action(...args)
  }
}

listenTo(globe, {
  drag: taken((from, to) => {
    const place = placeAt(view, picture.size, from)
    const moved = [to[0] - from[0], to[1] - from[1]]
    look((place && withPlaceAt(view, picture.size, place, to)) ?? dragged(view, picture.size, moved))
  }),
  zoom: taken((factor, point) => look(zoomedAt(view, picture.size, factor, point))),
  turn: taken((east, north) => look(turnedBy(view, east / view.zoom, north / view.zoom))),
  home: taken(() => look(viewOf(shown?.table.places ?? []))),
  hover: (point) => {
    const circle = point && circleAt(placeAt(view, picture.size, point))
    if (circle === hovered) return
    hovered = circle
    mark()
  },
  select: (point) => {
    const place = point === undefined ? [view.longitude, view.latitude] : placeAt(view, picture.size, point)
    selected = circleAt(place)
    mark()
    if (selected !== undefined) say(selected)
  },
  showCursor: (isShown) => {
    if (hasCursor === isShown) return
    hasCursor = isShown
    if (isShown) look(view)
    else {
      // The keyboard goes on to the panel, which shows the cell under the cursor.
      selected = hovered ?? selected
      hovered = undefined
      mark()
    }
  },
})
byId('save').addEventListener('click', () => saveCells(shown))
for (const id of ['radius', 'unit']) {
  byId(id).addEventListener('change', () => {
    const { table, colorBy } = shown
    const choice = { name: table.name, text: table.text, radius: byId('radius').value, unit: byId('unit').value }
    // The choice stays as it was if the column is no radius.
    if (!show(choice, colorBy)) showTable(shown)
    else if (kept() !== undefined) keep(choice)
  })
}
byId('color').addEventListener('change', () => {
  const colorBy = byId('color').value
  shown = { ...shown, colorBy, ...coloringOf(shown.table, shown.diagram, colorBy) }
  showLegend(shown.legend, palette())
  draw()
})
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
  if (shown !== undefined) showLegend(shown.legend, palette())
})
listenToTables(byId('file'), open, showProblem)
askOpener(open)

const last = kept()
if (last !== undefined) open(last)
if (shown === undefined) await openCities()

async function openCities() {
  const response = await fetch('../../public/data/world-cities.csv')
  if (!response.ok) showProblem('The cities could not be loaded. Open a table.')
  const text = await response.text()
  // Somebody may have opened a table by now.
  if (!response.ok || shown !== undefined) return
  show({ name: 'Cities of a million', text }, 'own neighbors')
  view = viewOf(shown.table.places)
  draw()
}
