// SPDX-License-Identifier: GPL-3.0-or-later
import { loadedOnce } from '../lib/base/loaded-once.ts'
import { english, type Words } from './words.ts'

let german: typeof import('./german.ts') | undefined
const loadGerman = loadedOnce(() => import('./german.ts'))

/** Of a language; where it is none of these, or not loaded yet, English. */
export function wordsOf(lang: string): Words {
  if (isGerman(lang) && german !== undefined) return german.germanWords(lang)
  return english(/^en(-|$)/i.test(lang) ? lang : 'en')
}

/** Settled once the words of a language are there, or cannot be loaded; `undefined`: they are. */
export function loadWords(lang: string): Promise<void> | undefined {
  if (!isGerman(lang) || german !== undefined) return undefined
  return loadGerman().then(
    (module) => {
      german = module
    },
    () => {
      // It may be there the next time.
    },
  )
}

function isGerman(lang: string): boolean {
  return /^de(-|$)/i.test(lang)
}
