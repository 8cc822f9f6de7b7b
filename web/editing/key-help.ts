// SPDX-License-Identifier: GPL-3.0-or-later

/** The names of keys, and their action. */
export type KeyRow = readonly [keys: string, action: string]

/** The keyboard shortcuts of a figure (`keyboard.ts`). */
export const ENGLISH_KEYS = {
  select: {
    one: ['Enter', 'select a circle'],
    next: ['Tab, Shift + Tab', 'the next one, the one before'],
    neighbor: ['Ctrl + arrows', 'the neighbor on that side'],
    all: ['Ctrl + A, Escape', 'all, none'],
    zoom: ['F', 'zoom to the selection'],
  },
  edit: {
    add: ['N', 'add a circle near the middle, where there is room'],
    move: ['arrows', 'move the selection: Shift for larger steps, Alt for smaller ones'],
    resize: ['+ −', 'resize the selection, with the same steps'],
    remove: ['Delete', 'delete the selection'],
    duplicate: ['Ctrl + D', 'duplicate the selection'],
    undo: ['Ctrl + Z, Ctrl + Shift + Z', 'undo, redo'],
    snap: ['S', 'snapping on or off'],
  },
  look: {
    pan: ['arrows', 'pan'],
    zoom: ['+ −', 'zoom'],
    fit: ['0', 'show everything; again: leave out what lies far outside'],
  },
  /** Introduces `look`, the keys of a figure without a selection. */
  withoutSelection: 'Without a selection:',
} satisfies Record<string, Readonly<Record<string, KeyRow>> | string>

export type KeyHelp = typeof ENGLISH_KEYS

/** Lists all keyboard shortcuts as text for screen readers. `more` holds additional shortcuts of the page. */
export function spokenKeys(help: KeyHelp, isReadonly: boolean, more: readonly KeyRow[] = []): string {
  const { select, edit, look, withoutSelection } = help
  const sentences = (rows: readonly KeyRow[]) => rows.map(([keys, action]) => `${keys}: ${action}.`)
  return [
    ...sentences(Object.values(select)),
    ...(isReadonly ? [] : [...sentences(Object.values(edit)), ...sentences(more), withoutSelection]),
    ...sentences(Object.values(look)),
  ].join(' ')
}
