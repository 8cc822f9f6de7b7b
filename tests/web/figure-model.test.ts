// SPDX-License-Identifier: GPL-3.0-or-later
// A figure with its thread in the hands of a random user: afterwards it equals a new figure of the same circles, and its
// history leads back to the start.
// @vitest-environment happy-dom

import fc from 'fast-check'
import { beforeAll, expect, it } from 'vitest'
import { showStep } from '../../web/editing/state.ts'
import type { Figure } from '../../web/player/figure.ts'
import { type Domain, NO_DOMAIN } from '../../web/view/domain.ts'
import { action as actionOf } from './arbitrary-circles.ts'
import { send } from './page-document.ts'
import { box, ring } from './shapes.ts'
import { FIGURE_SIZE, newFigure } from './whole-figure.ts'
import { FIVE, quiet, surround } from './whole-page.ts'

const SCENES = [
  FIVE,
  new Float64Array(),
  Float64Array.of(3, 4, 0),
  // Two equal circles, and a hidden one.
  Float64Array.of(0, 0, 2, 0, 0, 2, 0, 1, 0.5, 9, 0, 1),
  // A grid has ties.
  Float64Array.from({ length: 48 }, (_, k) => [((k / 3) % 4) | 0, (k / 12) | 0, 0.3][k % 3] as number),
]
const DOMAINS: readonly Domain[] = [
  NO_DOMAIN,
  {
    region: [box(-5, -5, 15, 15)],
    areas: undefined,
  },
  {
    region: [ring(-30, -30, 30, -30, 0, 40)],
    areas: undefined,
  },
  { region: undefined, lattice: { a: [40, 0], b: [3, 45] }, areas: undefined },
]
const KEYS = ['Delete', 'ArrowLeft', 'ArrowUp', '+', '-', 'Tab', 'Enter', 'Escape', 'v', 'a', 'h', '0', 'f', 'x']
const COMMANDS = ['a', 'd', 'z', 'y', 'Z']

const x = fc.integer({ min: 0, max: FIGURE_SIZE.width })
const y = fc.integer({ min: 0, max: FIGURE_SIZE.height })
/** Small numbers with ties, and invalid radii. */
const circle = fc.record({
  x: fc.integer({ min: -5, max: 25 }),
  y: fc.integer({ min: -5, max: 25 }),
  r: fc.constantFrom(0, 0.5, 2, 2, 7, -1, Number.NaN),
})
/** Whether the next action waits for this one. */
const waits = fc.boolean()
const keys = (list: readonly string[], ctrlKey: boolean) =>
  actionOf('key', { key: fc.constantFrom(...list), shiftKey: fc.boolean(), ctrlKey: fc.constant(ctrlKey), waits })
const drag = actionOf('drag', {
  from: fc.tuple(x, y),
  through: fc.array(fc.tuple(x, y), { minLength: 1, maxLength: 3 }),
  end: fc.constantFrom('pointerup', 'pointerup', 'pointercancel', 'Escape'),
  pointerType: fc.constantFrom('mouse', 'touch'),
  shiftKey: fc.boolean(),
  waits,
})
const action = fc.oneof(
  { weight: 4, arbitrary: drag },
  actionOf('click', { at: fc.tuple(x, y), shiftKey: fc.boolean(), waits }),
  actionOf('dblclick', { at: fc.tuple(x, y), waits }),
  { weight: 3, arbitrary: keys(KEYS, false) },
  { weight: 3, arbitrary: keys(COMMANDS, true) },
  actionOf('type', { which: fc.nat(9), circle, waits }),
  actionOf('open', { circles: fc.constantFrom(...SCENES), waits }),
  actionOf('domain', { domain: fc.constantFrom(...DOMAINS), waits }),
  actionOf('play', { step: fc.option(fc.nat(30), { nil: undefined }), waits }),
)
type Action = typeof action extends fc.Arbitrary<infer Value> ? Value : never

const pointer = (pointerType: string, [offsetX, offsetY]: readonly [number, number], shiftKey: boolean) => ({
  pointerId: 1,
  button: 0,
  pointerType,
  offsetX,
  offsetY,
  shiftKey,
})

async function act(figure: ReturnType<typeof newFigure>, action: Action): Promise<void> {
  const { element, actions, editing } = figure
  let done: Promise<unknown> | undefined
  switch (action.kind) {
    case 'drag': {
      const { from, through, end, pointerType, shiftKey } = action
      send(element, 'pointerdown', pointer(pointerType, from, shiftKey))
      for (const point of through) {
        send(element, 'pointermove', pointer(pointerType, point, shiftKey))
        if (action.waits) await quiet()
      }
      if (end === 'Escape') send(element, 'keydown', { key: 'Escape' })
      send(element, end === 'pointercancel' ? end : 'pointerup', pointer(pointerType, through.at(-1) ?? from, shiftKey))
      break
    }
    case 'click':
      for (const type of ['pointerdown', 'pointerup']) send(element, type, pointer('mouse', action.at, action.shiftKey))
      break
    case 'dblclick':
      send(element, 'dblclick', pointer('mouse', action.at, false))
      break
    case 'key':
      for (const type of ['keydown', 'keyup']) send(element, type, action)
      break
    case 'type': {
      const ids = [...editing.circles.ids()]
      const id = ids[action.which % ids.length]
      if (id !== undefined) actions.circles.set([{ id, circle: action.circle }])
      break
    }
    case 'open':
      done = actions.opening.open(async () => ({ circles: action.circles.slice(), dataSet: '', isEdited: false }))
      break
    case 'domain':
      done = actions.circles.setDomain(action.domain)
      break
    case 'play':
      showStep(figure.store, action.step)
  }
  if (action.waits) {
    await done
    await quiet()
  }
}

/** A sum, whose last digits depend on the order of its parts. */
const rounded = (value: number) => Number(value.toPrecision(9))

/** The circles and everything that is known of their diagram, in the order of the circles. */
async function contentOf({ editing, view, store }: Figure) {
  const ids = [...editing.circles.ids()]
  const placeOf = (id: number) => ids.indexOf(id)
  const told = await view.scene.ask('tell', [ids])
  const cells = ids.map((id) => {
    const cell = told?.cells.get(id)
    if (cell === undefined) return undefined
    const neighbors = [...cell.neighbors].map(placeOf).sort((a, b) => a - b)
    return { ...cell, neighbors, area: rounded(cell.area), perimeter: rounded(cell.perimeter) }
  })
  const { region, lattice } = editing.domain
  const { counts } = store.get().edited ?? {}
  return { circles: [...editing.circles.circles()], counts, region, lattice, facts: { ...told, cells } }
}

const stateOf = ({ editing }: Figure) => [[...editing.circles.circles()], editing.domain.region, editing.domain.lattice]

beforeAll(() => {
  surround()
  document.body.innerHTML = ''
})

async function play(script: readonly Action[]): Promise<void> {
  const figure = newFigure()
  const other = newFigure()
  try {
    await figure.open({ circles: FIVE.slice(), dataSet: '', isEdited: false })
    const start = stateOf(figure)
    for (const action of script) await act(figure, action)
    // Edits that wait are made first.
    await figure.editing.edit([])
    showStep(figure.store, undefined)
    await quiet()
    const end = stateOf(figure)
    const { domain } = figure.editing
    await other.open({ circles: figure.editing.circles.circles(), dataSet: '', isEdited: false, domain })
    await quiet()
    expect(await contentOf(figure)).toEqual(await contentOf(other))
    const { store, actions } = figure
    const steps = store.get().history.done.length
    while (store.get().history.done.length > 0) await actions.circles.undo()
    expect(stateOf(figure)).toEqual(start)
    for (let k = 0; k < steps; k++) await actions.circles.redo()
    expect(stateOf(figure)).toEqual(end)
  } finally {
    figure.dispose()
    other.dispose()
  }
}

it('a figure after any gestures, keys, openings, regions and steps equals a new one, and undo leads back to its start', async () => {
  await fc.assert(
    fc.asyncProperty(fc.array(action, { minLength: 1, maxLength: 12 }), (script) => play(script)),
    { numRuns: 30 },
  )
}, 300_000)
