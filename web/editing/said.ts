// SPDX-License-Identifier: GPL-3.0-or-later

import { describeCell } from './describe-cell.ts'
import type { State } from './state.ts'
import type { Store } from './store.ts'
import type { EditingWords } from './words.ts'

/** So long nothing may change before it is said, in milliseconds: of a drag, the end. */
const REST = 250

/** Says what was done, and which circle is selected, to who does not see it: each once. */
export function mountSaid(store: Store<State>, said: HTMLElement, words: () => EditingWords): void {
  let before = store.get()
  let timer: ReturnType<typeof setTimeout> | undefined
  /** The action that is not announced yet, and the circle that it left selected. */
  let done: { readonly text: string; readonly id: number | undefined } | undefined

  const say = (text: string) => {
    clearTimeout(timer)
    timer = setTimeout(() => {
      done = undefined
      // The same text once more is heard only if it comes anew.
      said.replaceChildren(text)
    }, REST)
  }
  store.subscribe((state) => {
    const { selected, described } = state
    if (state.said !== before.said) {
      done = { text: state.said.text, id: selected }
      // A circle that it selected is described a moment later: both are announced together.
      const isKnown = selected === undefined || described?.id === selected
      if (isKnown) say(done.text)
      else clearTimeout(timer)
    } else if (
      described !== undefined &&
      described.id === selected &&
      (selected !== before.selected || before.described?.id !== selected)
    ) {
      const description = describeCell(described, words())[0]
      const text = done?.id === selected ? description : words().circle(selected, description)
      say(done === undefined ? text : `${done.text}. ${text}`)
    }
    before = state
  })
}
