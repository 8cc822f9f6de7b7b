// SPDX-License-Identifier: GPL-3.0-or-later

import { ENGLISH_KEYS, type KeyHelp } from '../editing/key-help.ts'
import type { ProblemWords } from '../editing/problem.ts'
import { type EditingWords, ENGLISH_EDITING } from '../editing/words.ts'
import type { PlayerWords } from '../player/words.ts'
import type { DiagramCounts } from '../view/diagram-counts.ts'
import type { ElementRefusals } from './refusals.ts'

/** What an element says by itself. */
export interface Words {
  /** Their language, as an attribute `lang` has it. */
  readonly lang: string
  /** What a figure is called where its page does not say it. */
  readonly label: string
  readonly keys: KeyHelp
  /** What is said to whoever turns the wheel, or moves a finger, over a figure that leaves it to the page. */
  readonly wheelHint: string
  readonly met: string
  readonly unmet: string
  readonly buttons: {
    readonly add: string
    readonly remove: string
    readonly undo: string
    readonly redo: string
    readonly zoomOut: string
    readonly zoomIn: string
    readonly fit: string
  }
  /** What the player is called. */
  readonly player: string
  /** What is shown, as a sentence. */
  describe(counts: DiagramCounts): string
  readonly editing: EditingWords
  /** What English says by itself, in another language. */
  readonly others?: { readonly refusals: ElementRefusals & ProblemWords; readonly player: PlayerWords }
}

/** What an element says by itself, in English. */
export function english(lang: string): Words {
  const number = numbersOf(lang)
  const count = (value: number, one: string, many = `${one}s`) => `${number(value)} ${value === 1 ? one : many}`
  return {
    lang,
    label: 'Circles and their Voronoi diagram',
    keys: ENGLISH_KEYS,
    wheelHint: 'Ctrl and the wheel zoom; so does the wheel alone after a click',
    met: 'Solved.',
    unmet: 'Not solved yet.',
    buttons: {
      add: 'Add a circle',
      remove: 'Delete what is selected',
      undo: 'Undo',
      redo: 'Redo',
      zoomOut: 'Zoom out',
      zoomIn: 'Zoom in',
      fit: 'Fit',
    },
    player: 'The method, step by step',
    editing: ENGLISH_EDITING,
    describe({ circles, hidden, vertices, edges }) {
      const inside = hidden === 0 ? '' : `, ${number(hidden)} of them hidden inside others`
      return `${count(circles, 'circle')}${inside}; the diagram has ${count(vertices, 'vertex', 'vertices')} and ${count(edges, 'edge')}.`
    },
  }
}

/** Small numbers are written without loading the rules of languages. */
export function numbersOf(lang: string): (value: number) => string {
  return (value) => (value < 1000 ? String(value) : grouped(value, lang))
}

/** A page may have any text as its language. */
function grouped(value: number, lang: string): string {
  try {
    return value.toLocaleString(lang)
  } catch {
    return value.toLocaleString(lang.slice(0, 2))
  }
}
