// SPDX-License-Identifier: GPL-3.0-or-later

/** Listeners to events by name. */
export class Events<All> {
  readonly #listeners = new Map<keyof All, Set<(event: never) => void>>()

  /** Subscribes to an event, and returns a function that unsubscribes. */
  on<Name extends keyof All>(name: Name, listener: (event: All[Name]) => void): () => void {
    const listeners = this.#listeners.get(name) ?? new Set()
    this.#listeners.set(name, listeners.add(listener))
    return () => listeners.delete(listener)
  }

  tell<Name extends keyof All>(name: Name, event: All[Name]): void {
    for (const listener of this.#listeners.get(name) ?? []) listener(event as never)
  }

  /** Unsubscribes all listeners. */
  end(): void {
    for (const listeners of this.#listeners.values()) listeners.clear()
  }
}
