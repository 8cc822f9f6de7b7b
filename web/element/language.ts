// SPDX-License-Identifier: GPL-3.0-or-later
import { english, type Words } from './words.ts'

let german: typeof import('./german.ts') | undefined
let loading: Promise<void> | undefined

/** Of a language; where it is none of these, or not loaded yet, English. */
export function wordsOf(lang: string): Words {
  if (isGerman(lang) && german !== undefined) return german.germanWords(lang)
  return english(/^en(-|$)/i.test(lang) ? lang : 'en')
}

/** Settled once the words of a language are there, or cannot be loaded; `undefined`: they are. */
export function loadWords(lang: string): Promise<void> | undefined {
  if (!isGerman(lang) || german !== undefined) return undefined
  loading ??= import('./german.ts').then(
    (module) => {
      german = module
    },
    () => {
      // It may be there the next time.
      loading = undefined
    },
  )
  return loading
}

function isGerman(lang: string): boolean {
  return /^de(-|$)/i.test(lang)
}
