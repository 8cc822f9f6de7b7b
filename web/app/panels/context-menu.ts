// SPDX-License-Identifier: GPL-3.0-or-later
import { html, render } from 'lit/html.js'
import type { State } from '../../editing/state.ts'
import type { Point } from '../../lib/index.ts'
import type { Store } from '../../view/store.ts'
import type { View } from '../../view/view.ts'
import type { PageActions } from '../page-actions.ts'
import { byId } from './by-id.ts'

/** Distance that counts as on a circle, in pixels. */
const SLACK = 5

type Item = readonly [label: string, keys: string, act: () => unknown]

/** Returns a function that opens a menu, for the circle at a pixel, the selection or the empty place. */
export function contextMenu(
  store: Store<State>,
  actions: PageActions,
  view: View,
  name: () => void,
): (at: Point) => void {
  const menu = byId('menu', HTMLElement)
  const figure = byId('figure', HTMLElement)

  const itemsAt = (point: Point): readonly Item[] => {
    const place = view.toPlane(point)
    const hit = view.hitAt(place, SLACK / view.camera.scale)
    const isOnCircle = hit !== undefined && hit.part !== 'cell'
    if (isOnCircle && !actions.selection.isSelected(hit.id)) actions.selection.select([hit.id])
    const count = store.get().selection.length
    if (!isOnCircle) {
      return [
        ['Add a circle here', 'double-click', () => actions.circles.addFitting(place)],
        ['Select all', 'Ctrl+A', () => actions.selection.selectAll()],
        ['Show everything', '0', () => actions.camera.fit()],
      ]
    }
    return [
      ...(count === 1 ? [['Name …', '', name] as const] : []),
      ['Zoom to', 'F', () => actions.camera.zoomToSelection()],
      ['Duplicate', 'Ctrl+D', () => actions.circles.duplicateSelected()],
      ['Delete', 'Delete', () => actions.circles.removeSelected()],
    ]
  }

  const open = (items: readonly Item[], { x, y }: Point) => {
    const choose = (act: Item[2]) => () => {
      menu.hidePopover()
      figure.focus()
      act()
    }
    render(
      items.map(
        ([label, keys, act]) =>
          html`<button type="button" role="menuitem" @click=${choose(act)}><span>${label}</span><kbd>${keys}</kbd></button>`,
      ),
      menu,
    )
    menu.showPopover()
    const { width, height } = menu.getBoundingClientRect()
    menu.style.left = `${Math.max(Math.min(x, innerWidth - width - SLACK), 0)}px`
    menu.style.top = `${Math.max(Math.min(y, innerHeight - height - SLACK), 0)}px`
    menu.querySelector('button')?.focus()
  }

  menu.addEventListener('keydown', (event) => {
    // The shortcuts of the page are for the figure.
    event.stopPropagation()
    if (event.key === 'Escape') menu.hidePopover()
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key]
    if (step === undefined) return
    event.preventDefault()
    const buttons = [...menu.querySelectorAll('button')]
    const k = buttons.indexOf(document.activeElement as HTMLButtonElement)
    buttons.at((k + step) % buttons.length)?.focus()
  })
  menu.addEventListener('toggle', ({ newState }) => {
    const hasFocus = [document.body, null].includes(document.activeElement as HTMLElement | null)
    if (newState === 'closed' && (hasFocus || menu.contains(document.activeElement))) figure.focus()
  })
  return (at) => open(itemsAt(at), at)
}
