// SPDX-License-Identifier: GPL-3.0-or-later

import type { Store } from '../view/store.ts'
import { describedIn, selectedIn } from '../view/view-state.ts'
import { describeCell, type Speech } from './describe-cell.ts'
import type { State } from './state.ts'

/** Delay without further changes before an announcement, in milliseconds. Drags are announced at their end. */
const ANNOUNCEMENT_DELAY = 250

/**
 * Announces edits, and the selected circle with its cell, at rest, as they are then. A cell is announced again once it
 * has changed.
 */
export function mountLiveRegion(store: Store<State>, said: HTMLElement, speech: Speech): void {
  let before = store.get()
  let timer: ReturnType<typeof setTimeout> | undefined
  /** The pending announcement, and the circle that the action selected. */
  let done: { readonly text: string; readonly id: number | undefined } | undefined
  /** The announced description of the selected circle. */
  let announced = ''

  const descriptionOf = (state: State) => {
    const described = describedIn(state)
    return described === undefined ? '' : describeCell(described, speech)[0]
  }
  const say = () => {
    const selected = selectedIn(store.get())
    const description = descriptionOf(store.get())
    const texts = done === undefined ? [] : [done.text]
    if (selected !== undefined && description !== '' && description !== announced) {
      texts.push(done?.id === selected ? description : speech.words.circle(speech.called(selected), description))
      announced = description
    }
    done = undefined
    // Screen readers announce a repeated text only if the node is new.
    if (texts.length > 0) said.replaceChildren(texts.join('. '))
  }
  store.subscribe((state) => {
    const selected = selectedIn(state)
    const isSelected = selected !== selectedIn(before)
    if (isSelected) announced = ''
    const isAction = state.said !== before.said
    if (isAction) done = { text: state.said.text, id: selected }
    const isOther = isAction || isSelected || state.highlights.selected !== before.highlights.selected
    before = state
    if (!isOther) return
    clearTimeout(timer)
    // The description of a newly selected circle arrives a moment later. Waiting for it allows one announcement for
    // both.
    if (selected === undefined || describedIn(state) !== undefined) timer = setTimeout(say, ANNOUNCEMENT_DELAY)
  })
}
