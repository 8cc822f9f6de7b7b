// SPDX-License-Identifier: GPL-3.0-or-later
import type { LinkInput } from '../lib/link.ts'
import { LinkWriter } from './link-writer.ts'
import { SceneStorage } from './scene-storage.ts'

/** What changes for so long, in milliseconds, is kept once. */
const REST = 400
/** Longer links are kept by the storage alone: addresses have to stay short enough to be copied. */
const LONGEST_ADDRESS = 100_000

/** Keeps what is shown: as a link in the address, and in the storage of the browser. */
export class Keeping {
  readonly #read: () => LinkInput | undefined
  readonly #links = new LinkWriter()
  #storage: SceneStorage | undefined
  #timer: ReturnType<typeof setTimeout> | undefined

  /** `read`: what is shown, as soon as it is anything. */
  constructor(read: () => LinkInput | undefined) {
    this.#read = read
    document.addEventListener('visibilitychange', () => {
      if (document.hidden && this.#timer !== undefined) this.#write()
    })
  }

  /** What was kept: the link of the address, or else what this tab or a closed one showed last. */
  async begin(): Promise<string | undefined> {
    const link = location.hash.slice(1)
    try {
      const [navigation] = performance.getEntriesByType('navigation') as PerformanceNavigationTiming[]
      const isReload = navigation?.type !== 'navigate'
      const surroundings = { all: localStorage, ofTab: sessionStorage, locks: navigator.locks, isReload }
      this.#storage = await SceneStorage.claim(surroundings, link === '')
    } catch {
      // A browser may forbid its storage.
    }
    return link !== '' ? link : this.#storage?.read()
  }

  /** To be called after each change. */
  changed(): void {
    clearTimeout(this.#timer)
    this.#timer = setTimeout(() => this.#write(), REST)
  }

  async #write(): Promise<void> {
    clearTimeout(this.#timer)
    this.#timer = undefined
    const state = this.#read()
    if (state === undefined) return
    const link = await this.#links.linkOf(state)
    // Meanwhile there may be something newer.
    if (this.#timer !== undefined) return
    const isShort = link !== undefined && link.length <= LONGEST_ADDRESS
    history.replaceState(null, '', isShort ? `#${link}` : location.pathname + location.search)
    if (link !== undefined) await this.#storage?.write(link)
  }
}
