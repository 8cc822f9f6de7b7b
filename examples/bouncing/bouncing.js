// SPDX-License-Identifier: GPL-3.0-or-later
// A thousand bouncing discs in a box, and their Voronoi diagram An editor keeps the diagram up to date. Two discs that
// touch are neighbors, so only discs that share an edge can collide.
import { loadCircleVoronoi } from '../../dist/lib/index.js'

const DISCS = 1000
const COLUMNS = 40
const ROWS = DISCS / COLUMNS
const TIME_STEP = 1 / 60
/** Number of frames in each report. */
const TOLD = 30

const random = randomNumbers(1)
const discs = Array.from({ length: DISCS }, (_, i) => ({
  x: (i % COLUMNS) + 0.5,
  y: Math.floor(i / COLUMNS) + 0.5,
  r: 0.15 + 0.25 * random(),
  vx: 4 * (random() - 0.5),
  vy: 4 * (random() - 0.5),
}))

const canvas = document.querySelector('canvas')
const context = canvas.getContext('2d')
const scale = canvas.width / COLUMNS
const output = document.querySelector('output')

const library = await loadCircleVoronoi()
const editor = library.edit(discs)
const diagram = editor.snapshot()
editor.onchange = (change) => diagram.apply(change)
const times = []
let frames = 0
requestAnimationFrame(frame)

function frame() {
  const start = performance.now()
  bounceNeighbors()
  discs.forEach((disc, id) => {
    move(disc)
    editor.replace(id, disc)
  })
  const edited = performance.now()
  draw()
  times.push({ edits: edited - start, drawing: performance.now() - edited })
  frames += 1
  if (times.length === TOLD) tell()
  requestAnimationFrame(frame)
}

function bounceNeighbors() {
  // Discs are never inserted or removed, so that indices are ids.
  const { edges } = diagram
  for (let k = 0; k < edges.length; k += 4) bounce(discs[edges[k]], discs[edges[k + 1]])
}

/** Two discs that touch and approach each other bounce. Their masses are their areas. */
function bounce(a, b) {
  const dx = b.x - a.x
  const dy = b.y - a.y
  const distance = Math.hypot(dx, dy)
  if (distance === 0 || distance > a.r + b.r) return
  const nearing = ((a.vx - b.vx) * dx + (a.vy - b.vy) * dy) / distance
  if (nearing <= 0) return
  const [massA, massB] = [a.r ** 2, b.r ** 2]
  const impulse = (2 * nearing * massA * massB) / (massA + massB) / distance
  a.vx -= (impulse / massA) * dx
  a.vy -= (impulse / massA) * dy
  b.vx += (impulse / massB) * dx
  b.vy += (impulse / massB) * dy
}

/** Moves a disc, which bounces off the walls. */
function move(disc) {
  disc.x += disc.vx * TIME_STEP
  disc.y += disc.vy * TIME_STEP
  if (disc.x < disc.r) disc.vx = Math.abs(disc.vx)
  if (disc.x > COLUMNS - disc.r) disc.vx = -Math.abs(disc.vx)
  if (disc.y < disc.r) disc.vy = Math.abs(disc.vy)
  if (disc.y > ROWS - disc.r) disc.vy = -Math.abs(disc.vy)
}

function draw() {
  context.setTransform(1, 0, 0, 1, 0, 0)
  context.clearRect(0, 0, canvas.width, canvas.height)
  context.setTransform(scale, 0, 0, scale, 0, 0)
  context.fillStyle = '#9fc3e6'
  context.beginPath()
  diagram.renderCircles({ context })
  context.fill()
  context.strokeStyle = '#23415f'
  context.lineWidth = 1.25 / scale
  context.beginPath()
  diagram.render({ context, bounds: [0, 0, COLUMNS, ROWS], tolerance: 0.25 / scale })
  context.stroke()
}

function tell() {
  const median = (part) =>
    times
      .map((time) => time[part])
      .sort((a, b) => a - b)
      [TOLD >> 1].toFixed(1)
  output.value = `frame ${frames}: edits ${median('edits')} ms, drawing ${median('drawing')} ms`
  times.length = 0
}

function randomNumbers(seed) {
  let state = seed
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0
    return state / 2 ** 32
  }
}
