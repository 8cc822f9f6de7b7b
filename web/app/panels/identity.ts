// SPDX-License-Identifier: GPL-3.0-or-later

import type { State } from '../../editing/state.ts'
import type { Store } from '../../view/store.ts'
import { describedIn, selectedIn } from '../../view/view-state.ts'
import type { PageActions } from '../page-actions.ts'
import { byId } from './by-id.ts'

/** The title, the name and the color of the selected circle. */
export function mountIdentity(store: Store<State>, actions: PageActions): void {
  const title = byId('inspector-title', HTMLHeadingElement)
  const name = byId('field-name', HTMLInputElement)
  const color = byId('field-color', HTMLInputElement)
  const figure = byId('figure', HTMLElement)

  /** The circle whose name is being written. */
  let writing: number | undefined
  name.addEventListener('input', () => {
    writing = selectedIn(store.get())
  })
  const write = () => {
    const id = writing
    writing = undefined
    if (id !== undefined && name.value.trim() !== actions.identity.nameOf(id))
      actions.identity.setName(id, name.value.trim())
  }
  name.addEventListener('change', write)
  name.addEventListener('keydown', (event) => {
    if (event.key === 'Enter') write()
    if (event.key !== 'Escape') return
    event.stopPropagation()
    writing = undefined
    name.value = actions.identity.nameOf(selectedIn(store.get()) as number)
    figure.focus()
  })
  const pick = colorPicker(actions, store)
  color.addEventListener('input', pick.input)
  color.addEventListener('change', pick.change)

  let shown: readonly unknown[] = []
  store.subscribe((state) => {
    const { attributes } = state
    const [selected, described] = [selectedIn(state), describedIn(state)]
    const now = [selected, described?.color, attributes]
    if (selected === undefined || now.every((value, k) => value === shown[k])) return
    shown = now
    const known = actions.identity.nameOf(selected)
    title.textContent = known || `Circle ${selected}`
    if (writing !== selected) name.value = known
    name.placeholder = `Circle ${selected}`
    const hex = hexOf(actions.identity.ownColorOf(selected) ?? described?.color ?? '')
    if (hex !== undefined && document.activeElement !== color) color.value = hex
  })
}

/** Listeners of a field for colors. The selected circles get the color that is picked, as one undo step. */
export function colorPicker(actions: PageActions, store: Store<State>) {
  let gesture: number | undefined
  return {
    input({ target }: Event) {
      gesture ??= actions.circles.beginGesture()
      actions.identity.setColor(store.get().selection, (target as HTMLInputElement).value, gesture)
    },
    change() {
      gesture = undefined
    },
  }
}

/** Converts a CSS color to the format of color fields, `#rrggbb`; `undefined` if it is not opaque. */
export function hexOf(color: string): string | undefined {
  const context = new OffscreenCanvas(1, 1).getContext('2d') as OffscreenCanvasRenderingContext2D
  context.fillStyle = '#00000000'
  context.fillStyle = color
  return context.fillStyle.startsWith('#') ? context.fillStyle : undefined
}
