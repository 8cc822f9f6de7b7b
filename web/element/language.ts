// SPDX-License-Identifier: GPL-3.0-or-later
import { loadedOnce } from '../lib/base/loaded-once.ts'
import { english, type Words } from './words.ts'

let german: typeof import('./german.ts') | undefined
const loadGerman = loadedOnce(() => import('./german.ts'))

/** The texts in a language. English is the fallback, also until another language is loaded. */
export function wordsOf(lang: string): Words {
  if (isGerman(lang) && german !== undefined) return german.germanWords(lang)
  return english(/^en(-|$)/i.test(lang) ? lang : 'en')
}

/** Loads the texts of a language. Settles when they are loaded or have failed; `undefined` if nothing needs loading. */
export function loadWords(lang: string): Promise<void> | undefined {
  if (!isGerman(lang) || german !== undefined) return undefined
  return loadGerman().then(
    (module) => {
      german = module
    },
    () => {
      // A failed download is tried again next time.
    },
  )
}

function isGerman(lang: string): boolean {
  return /^de(-|$)/i.test(lang)
}
