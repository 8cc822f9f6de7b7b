// SPDX-License-Identifier: GPL-3.0-or-later

import { describeCell } from '../../editing/describe-cell.ts'
import type { State } from '../../editing/state.ts'
import { short } from '../../view/short.ts'
import type { Store } from '../../view/store.ts'
import { describedIn, selectedIn } from '../../view/view-state.ts'
import { wholeNumber } from '../../view/whole-number.ts'
import { listenToPresses } from '../input/after-press.ts'
import type { PageActions } from '../page-actions.ts'
import { byId } from './by-id.ts'

type Field = 'x' | 'y' | 'r'
const FIELDS: readonly Field[] = ['x', 'y', 'r']
/** Digits of the numbers in one line. */
const DIGITS = 3
/** Largest number of buttons for neighbors. */
const MOST_NEIGHBORS = 500

/** The numbers, the cell and the neighbors of the selected circle. Returns a function that moves the focus there. */
export function mountInspector(store: Store<State>, actions: PageActions): () => void {
  const panel = byId('inspector', HTMLElement)
  const line = byId('inspector-line', HTMLElement)
  const cell = byId('inspector-cell', HTMLParagraphElement)
  const neighbors = byId('inspector-neighbors', HTMLUListElement)
  const fields = FIELDS.map((name) => byId(`field-${name}`, HTMLInputElement))
  const figure = byId('figure', HTMLElement)
  const afterPress = listenToPresses(document)
  const circleIn = (state: State) => {
    const id = selectedIn(state)
    return id === undefined ? undefined : actions.circles.circle(id)
  }

  // The field being edited. Refused text stays in it for correction.
  let typing: HTMLInputElement | undefined
  fields.forEach((field, i) => {
    field.addEventListener('input', () => {
      typing = field
    })
    field.addEventListener('change', () => {
      // Earlier input may still be pending, so this uses the predicted values.
      const [held, ...others] = actions.circles.selectedCircles()
      if (held === undefined || others.length > 0) return
      actions.circles.set([{ id: held.id, circle: { ...held.circle, [FIELDS[i] as Field]: field.valueAsNumber } }])
    })
    field.addEventListener('blur', () => {
      typing = undefined
      // Restores the number if the edit was refused.
      const { problem } = store.get()
      const circle = circleIn(store.get())
      if (circle === undefined) return
      const text = short(circle[FIELDS[i] as Field])
      if (field.value !== text && problem !== '')
        afterPress(() => store.get().problem === problem && actions.messages.complain(''))
      field.value = text
      field.setAttribute('aria-invalid', 'false')
    })
    field.addEventListener('keydown', (event) => {
      if (event.key === 'Escape') figure.focus()
    })
  })
  byId('deselect', HTMLButtonElement).addEventListener('click', () => {
    actions.selection.select([])
    figure.focus()
  })

  let shownNeighbors: string | undefined
  const showNeighbors = (indices: readonly number[]) => {
    const shown = indices.slice(0, MOST_NEIGHBORS)
    const text = `${shown.map((id) => actions.messages.called(id)).join('\n')} of ${indices.length}`
    if (text === shownNeighbors) return
    shownNeighbors = text
    const hadFocus = neighbors.contains(document.activeElement)
    neighbors.replaceChildren(...shown.map((index) => chip(index, actions)))
    if (indices.length > shown.length) {
      const more = document.createElement('li')
      more.textContent = `and ${wholeNumber(indices.length - shown.length)} more`
      neighbors.append(more)
    }
    if (hadFocus) (neighbors.querySelector('button') ?? figure).focus()
  }

  store.subscribe((state) => {
    const circle = circleIn(state)
    const described = describedIn(state)
    if (circle === undefined && panel.contains(document.activeElement)) figure.focus()
    panel.hidden = circle === undefined
    if (circle === undefined) return

    line.textContent = FIELDS.map((name) => `${name} ${short(circle[name], DIGITS)}`).join('  ')
    fields.forEach((field, i) => {
      const value = circle[FIELDS[i] as Field]
      const text = short(value)
      field.title = String(value)
      field.setAttribute('aria-invalid', String(field === typing && state.problem !== ''))
      if (field !== typing && field.value !== text) field.value = text
    })
    // The cell's description arrives later. Until then its place keeps its size.
    panel.classList.toggle('awaiting', described === undefined)
    if (described === undefined) return
    const [description, indices] = describeCell(described, actions.messages)
    cell.textContent = description
    showNeighbors(indices)
  })

  return () => (fields[0] as HTMLInputElement).focus()
}

function chip(index: number, actions: PageActions): HTMLLIElement {
  const button = document.createElement('button')
  button.type = 'button'
  const name = actions.identity.nameOf(index)
  button.textContent = name || String(index)
  button.setAttribute('aria-label', name || `Circle ${index}`)
  button.addEventListener('click', () => actions.selection.goTo(index))
  button.addEventListener('pointerenter', () => actions.selection.hover(index))
  button.addEventListener('pointerleave', () => actions.selection.hover(undefined))
  const item = document.createElement('li')
  item.append(button)
  return item
}
