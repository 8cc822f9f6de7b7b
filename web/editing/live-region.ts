// SPDX-License-Identifier: GPL-3.0-or-later

import { describeCell, type Speech } from './describe-cell.ts'
import type { State } from './state.ts'
import type { Store } from './store.ts'

/** Delay without further changes before an announcement, in milliseconds. Drags are announced at their end. */
const REST = 250

/** Announces edits and the selection to screen readers, each once. */
export function mountLiveRegion(store: Store<State>, said: HTMLElement, speech: Speech): void {
  let before = store.get()
  let timer: ReturnType<typeof setTimeout> | undefined
  /** The pending announcement, and the circle that the action selected. */
  let done: { readonly text: string; readonly id: number | undefined } | undefined

  const say = (text: string) => {
    clearTimeout(timer)
    timer = setTimeout(() => {
      done = undefined
      // Screen readers announce a repeated text only if the node is new.
      said.replaceChildren(text)
    }, REST)
  }
  store.subscribe((state) => {
    const { selected, described } = state
    if (state.said !== before.said) {
      done = { text: state.said.text, id: selected }
      // The description of a newly selected circle arrives a moment later. Waiting for it allows one announcement for
      // both.
      const isKnown = selected === undefined || described?.id === selected
      if (isKnown) say(done.text)
      else clearTimeout(timer)
    } else if (
      described !== undefined &&
      described.id === selected &&
      (selected !== before.selected || before.described?.id !== selected)
    ) {
      const description = describeCell(described, speech)[0]
      const text = done?.id === selected ? description : speech.words.circle(speech.called(selected), description)
      say(done === undefined ? text : `${done.text}. ${text}`)
    }
    before = state
  })
}
