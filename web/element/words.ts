// SPDX-License-Identifier: GPL-3.0-or-later

import { ENGLISH_KEYS } from '../editing/key-help.ts'
import type { ProblemWords } from '../editing/problem.ts'
import { ENGLISH_EDITING } from '../editing/words.ts'
import type { PlayerWords } from '../player/words.ts'
import type { DiagramCounts } from '../view/diagram-counts.ts'
import { ENGLISH_GOALS } from './goals.ts'
import type { ElementRefusals } from './refusals.ts'

/** The texts of an element. */
export interface Words extends ReturnType<typeof english> {
  /** Further texts that are built into English. */
  readonly others?: { readonly refusals: ElementRefusals & ProblemWords; readonly player: PlayerWords }
}

/** The English texts of an element. */
export function english(lang: string) {
  const number = numbersOf(lang)
  const count = (value: number, one: string, many = `${one}s`) => `${number(value)} ${value === 1 ? one : many}`
  return {
    /** The language of the texts, as a value of the attribute `lang`. */
    lang,
    /** The default name of a figure. */
    label: 'Circles and their Voronoi diagram',
    keys: ENGLISH_KEYS,
    /** The hint for using the wheel over a figure that leaves it to the page. */
    wheelHint: 'Ctrl and the wheel zoom; so does the wheel alone after a click',
    met: 'Solved.',
    unmet: 'Not solved yet.',
    goals: ENGLISH_GOALS,
    buttons: {
      add: 'Add a circle',
      remove: 'Delete what is selected',
      undo: 'Undo',
      redo: 'Redo',
      zoomOut: 'Zoom out',
      zoomIn: 'Zoom in',
      fit: 'Fit',
    },
    /** The name of the player. */
    player: 'The method, step by step',
    editing: ENGLISH_EDITING,
    /** Describes the figure in a sentence. */
    describe({ circles, hidden, vertices, edges }: DiagramCounts) {
      const inside = hidden === 0 ? '' : `, ${number(hidden)} of them hidden inside others`
      return `${count(circles, 'circle')}${inside}; the diagram has ${count(vertices, 'vertex', 'vertices')} and ${count(edges, 'edge')}.`
    },
  }
}

/** Formats small numbers without loading locale data. */
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
