// SPDX-License-Identifier: GPL-3.0-or-later
import { html, render } from 'lit/html.js'
import { ENGLISH_KEYS, type KeyRow } from '../../editing/key-help.ts'
import { icon } from '../../player/icon.ts'
import { CLOSE } from '../../view/icons.ts'
import { PAGE_KEYS } from '../page-keys.ts'
import { byId } from './by-id.ts'

/** Puts the pointer gesture before the keys of the same action. */
const also = (pointer: string, [keys, action]: KeyRow): KeyRow => [`${pointer}, ${keys}`, action]

const { select, edit, look } = ENGLISH_KEYS
const HELP: readonly (readonly [title: string, rows: readonly KeyRow[]])[] = [
  [
    'Look',
    [also('wheel, pinch', look.zoom), also('drag, Space + drag, middle button', look.pan), look.fit, select.zoom],
  ],
  [
    'Select',
    [
      ['click, Enter', 'a circle by its disc or its cell'],
      ['Shift + click, Shift + drag; a long press by a finger', 'several'],
      select.next,
      select.neighbor,
      select.all,
    ],
  ],
  ['Tools', [PAGE_KEYS.tools, PAGE_KEYS.region, PAGE_KEYS.help]],
  [
    'Edit',
    [
      ['double-click or double tap, A and drag', 'add a circle'],
      ['press and hold where no circle is', 'see what a new circle would take; release to add it'],
      edit.add,
      ['drag its disc, its rim, the square handle', 'move, resize, scale'],
      edit.move,
      edit.resize,
      ['Alt + drag', 'snap to neighbors and to a grid'],
      edit.snap,
      PAGE_KEYS.copy,
      edit.duplicate,
      edit.remove,
      edit.undo,
      PAGE_KEYS.numbers,
    ],
  ],
]

/** Shows the help on pointer and keys. */
export function showHelp(): void {
  const dialog = byId('help', HTMLDialogElement)
  const source = byId('source', HTMLAnchorElement).href
  render(
    html`
      <form method="dialog" class="row">
        <h2 id="help-title">Mouse, fingers and keys</h2>
        <button class="icon" aria-label="Close" title="Close (Escape)">
          ${icon(CLOSE)}
        </button>
      </form>
      <div class="help">
        ${HELP.map(
          ([title, rows]) =>
            html`<section>
              <h3>${title}</h3>
              <dl>${rows.map(([how, what]) => html`<dt>${how}</dt><dd>${what}</dd>`)}</dl>
            </section>`,
        )}
      </div>
      <p class="reading"><a href="./tutorial/">Tutorial</a> <a href="./docs/">Documentation</a>
        <a href=${source}>Source</a></p>
    `,
    dialog,
  )
  // A click on the backdrop closes the dialog.
  dialog.onclick = ({ target }) => {
    if (target === dialog) dialog.close()
  }
  dialog.showModal()
}
