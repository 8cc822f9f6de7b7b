// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from '../../lib/diagram-data.ts'
import type { Diagram } from '../../lib/index.ts'
import type { Actions } from '../actions.ts'
import { NOBODY, type State, selectedCircle } from '../state.ts'
import type { Store } from '../store.ts'
import { byId } from './by-id.ts'

type Field = 'x' | 'y' | 'r'
const FIELDS: readonly Field[] = ['x', 'y', 'r']

/** The numbers, the cell and the neighbours of the selected circle. Returns how to move the focus there. */
export function mountInspector(store: Store<State>, actions: Actions): () => void {
  const panel = byId('inspector', HTMLElement)
  const title = byId('inspector-title', HTMLHeadingElement)
  const cell = byId('inspector-cell', HTMLParagraphElement)
  const neighbors = byId('inspector-neighbors', HTMLUListElement)
  const fields = FIELDS.map((name) => byId(`field-${name}`, HTMLInputElement))
  const canvas = byId('canvas', HTMLCanvasElement)

  // What is being typed, or was refused, stays in its field for the user to mend.
  let typing: HTMLInputElement | undefined
  fields.forEach((field, i) => {
    field.addEventListener('input', () => {
      typing = field
    })
    field.addEventListener('change', () => {
      const { selected } = store.get()
      const circle = selectedCircle(store.get())
      if (circle === undefined) return
      const numbers = [circle.x, circle.y, circle.r] as [number, number, number]
      numbers[i] = field.valueAsNumber
      actions.setCircle(selected, ...numbers)
    })
    field.addEventListener('blur', () => {
      typing = undefined
    })
    field.addEventListener('keydown', (event) => {
      if (event.key === 'Escape') canvas.focus()
    })
  })
  byId('deselect', HTMLButtonElement).addEventListener('click', () => {
    actions.select(NOBODY)
    canvas.focus()
  })

  let shownNeighbors: string | undefined
  const showNeighbors = (indices: readonly number[]) => {
    if (indices.join() === shownNeighbors) return
    shownNeighbors = indices.join()
    neighbors.replaceChildren(...indices.map((index) => chip(index, actions)))
  }

  store.subscribe((state) => {
    const circle = selectedCircle(state)
    panel.hidden = circle === undefined
    if (circle === undefined) return

    if (title.textContent !== `Circle ${state.selected}`) title.textContent = `Circle ${state.selected}`
    fields.forEach((field, i) => {
      const value = circle[FIELDS[i] as Field]
      const text = shortest(value)
      field.title = String(value)
      field.setAttribute('aria-invalid', String(field === typing && state.problem !== ''))
      if (field !== typing && field.value !== text) field.value = text
    })
    const [description, indices] = describeCell(state.diagram, state.selected)
    cell.textContent = description
    showNeighbors(indices)
  })

  return () => (fields[0] as HTMLInputElement).focus()
}

function describeCell(diagram: Diagram | undefined, circle: number): [string, readonly number[]] {
  if (diagram === undefined || circle >= diagram.circles.length / 3) return ['', []]
  const cell = diagram.cell(circle)
  if (cell === undefined) {
    const by = hiderOf(diagram, circle)
    return [`Hidden inside circle ${by}: it has no cell.`, [by]]
  }
  const neighbors = [...new Set(cell.neighbors)]
  const kind = cell.isBounded ? 'Bounded cell' : 'Unbounded cell'
  return [`${kind}, ${neighbors.length} ${neighbors.length === 1 ? 'neighbour' : 'neighbours'}`, neighbors]
}

function hiderOf({ hidden }: Diagram, circle: number): number {
  for (let h = 0; h < hidden.length; h += 2) if (at(hidden, h) === circle) return at(hidden, h + 1)
  return NOBODY
}

function chip(index: number, actions: Actions): HTMLLIElement {
  const button = document.createElement('button')
  button.type = 'button'
  button.textContent = String(index)
  button.setAttribute('aria-label', `Circle ${index}`)
  button.addEventListener('click', () => actions.select(index))
  button.addEventListener('pointerenter', () => actions.hover(index))
  button.addEventListener('pointerleave', () => actions.hover(NOBODY))
  const item = document.createElement('li')
  item.append(button)
  return item
}

/** Six digits are enough to read; the number itself keeps all of its own. */
function shortest(value: number): string {
  return String(Number(value.toPrecision(6)))
}
