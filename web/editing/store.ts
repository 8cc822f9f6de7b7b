// SPDX-License-Identifier: GPL-3.0-or-later
import { nextFrame } from '../view/next-frame.ts'

/** Holds a value, and notifies its subscribers once per frame if it was replaced. */
export interface Store<Value> {
  get(): Value
  update(change: (value: Value) => Value): void
  /** Subscribes a listener, and returns a function that unsubscribes it. */
  subscribe(listener: (value: Value) => void): () => void
}

export function createStore<Value>(initial: Value): Store<Value> {
  const listeners = new Set<(value: Value) => void>()
  let value = initial
  let isScheduled = false
  const tell = () => {
    isScheduled = false
    for (const listener of listeners) listener(value)
  }
  return {
    get: () => value,
    update(change) {
      const next = change(value)
      if (next === value) return
      value = next
      if (isScheduled || listeners.size === 0) return
      isScheduled = true
      nextFrame(tell)
    },
    subscribe(listener) {
      listeners.add(listener)
      listener(value)
      return () => listeners.delete(listener)
    },
  }
}
