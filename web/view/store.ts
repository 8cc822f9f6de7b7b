// SPDX-License-Identifier: GPL-3.0-or-later
import { nextFrame } from './next-frame.ts'

/** Holds a value that is replaced, never modified. */
export interface Store<Value> {
  get(): Value
  update(change: (value: Value) => Value): void
  /** Subscribes a listener that is told once per frame in which the value was replaced. Returns how to unsubscribe. */
  subscribe(listener: (value: Value) => void): () => void
  /** Subscribes a listener that is told of each new value at once. Returns how to unsubscribe. */
  watch(listener: (value: Value, before: Value) => void): () => void
}

export function createStore<Value>(initial: Value): Store<Value> {
  const listeners = new Set<(value: Value) => void>()
  const watchers = new Set<(value: Value, before: Value) => void>()
  let value = initial
  let isScheduled = false
  const tell = () => {
    isScheduled = false
    for (const listener of listeners) listener(value)
  }
  return {
    get: () => value,
    update(change) {
      const before = value
      value = change(value)
      if (value === before) return
      if (!isScheduled && listeners.size > 0) {
        isScheduled = true
        nextFrame(tell)
      }
      for (const watcher of watchers) watcher(value, before)
    },
    subscribe(listener) {
      listeners.add(listener)
      listener(value)
      return () => listeners.delete(listener)
    },
    watch(listener) {
      watchers.add(listener)
      return () => watchers.delete(listener)
    },
  }
}
