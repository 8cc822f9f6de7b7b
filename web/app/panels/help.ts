// SPDX-License-Identifier: GPL-3.0-or-later
import { html, render } from 'lit/html.js'
import { icon } from '../../player/icon.ts'
import { CLOSE } from '../../view/icons.ts'
import { byId } from './by-id.ts'

const HELP: readonly (readonly [title: string, rows: readonly (readonly [how: string, what: string])[]])[] = [
  [
    'Look',
    [
      ['wheel, pinch, + −', 'zoom'],
      ['drag, Space + drag, middle button, arrows', 'pan'],
      ['0', 'show everything; again: leave out what lies far outside'],
      ['F', 'zoom to the selection'],
    ],
  ],
  [
    'Select',
    [
      ['click, Enter', 'a circle by its disc or its cell'],
      ['Shift + click, Shift + drag', 'several'],
      ['Tab, Shift + Tab', 'the next one, the one before'],
      ['Ctrl + arrows', 'the neighbor on that side'],
      ['Ctrl + A, Escape', 'all, none'],
    ],
  ],
  [
    'Edit',
    [
      ['double click or double tap, A and drag', 'add a circle'],
      ['N', 'add a circle in the middle of the picture'],
      ['press and hold where no circle is', 'see what a new circle would take; release to add it'],
      ['drag its disc, its rim, the square handle', 'move, resize, scale'],
      ['arrows, + −', 'move and resize by a step: Shift ten, Alt a tenth'],
      ['Alt + drag, S', 'snap to neighbors and to a grid'],
      ['Ctrl + C, X, V, D', 'copy, cut, paste, duplicate'],
      ['Delete', 'delete'],
      ['Ctrl + Z, Ctrl + Shift + Z', 'undo, redo'],
      ['Enter', 'type the numbers of the selected circle'],
    ],
  ],
  [
    'Tools',
    [
      ['V, H, A', 'select, pan, add until Escape'],
      ['P', 'draw a region: click corners, or arrows and Space; double click or Enter closes, Escape cancels'],
      ['?', 'this help'],
    ],
  ],
]

/** Shows what pointer and keys do. */
export function showHelp(): void {
  const dialog = byId('help', HTMLDialogElement)
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
      <p class="reading"><a href="./tutorial/">Tutorial</a> <a href="./docs/">Documentation</a></p>
    `,
    dialog,
  )
  // A click beside it closes it.
  dialog.onclick = ({ target }) => {
    if (target === dialog) dialog.close()
  }
  dialog.showModal()
}
