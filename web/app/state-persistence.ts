// SPDX-License-Identifier: GPL-3.0-or-later
import { CircleVoronoiError } from '../lib/index.ts'
import { encodeLinkAtOnce, type LinkInput } from '../lib/link.ts'
import type { LinkWriter } from './link-writer.ts'
import { type SavedScene, SceneStorage } from './scene-storage.ts'

/** Pause after a change before it is saved, in milliseconds. */
const DELAY = 400
/** Longer links are saved to the storage only, because addresses must stay short enough to copy. */
const LONGEST_ADDRESS = 100_000

/** Saves the state as a link in the address and in the browser's storage. */
export class StatePersistence {
  readonly #read: () => LinkInput | undefined
  readonly #links: LinkWriter
  #storage: SceneStorage | undefined
  #timer: ReturnType<typeof setTimeout> | undefined
  /** Whether the last change has been saved. */
  #isKept = true
  /** The number of the latest write. Writes may finish out of order. */
  #lastWrite = 0
  /** The hash at its last read or write here. A different hash is a link to open. */
  #hash = ''
  /** The hash before the last write. */
  #hashBefore = ''

  /** `read` returns the state once there is one. */
  constructor(links: LinkWriter, read: () => LinkInput | undefined) {
    this.#links = links
    this.#read = read
    document.addEventListener('visibilitychange', () => {
      if (!document.hidden || this.#isKept) return
      this.#writeAtOnce()
      this.#write()
    })
  }

  /** Returns the saved state: the link of the address, or else the last state of this tab or of a closed one. */
  async begin(): Promise<string | undefined> {
    this.#hash = location.hash
    this.#hashBefore = this.#hash
    try {
      const [navigation] = performance.getEntriesByType('navigation') as PerformanceNavigationTiming[]
      const isReload = navigation?.type !== 'navigate'
      const [storage, saved] = await SceneStorage.claim(isReload, this.#hash)
      this.#storage = storage
      if (saved !== undefined) return saved
    } catch {
      // Storage may be forbidden.
    }
    return this.#hash === '' ? undefined : this.#hash.slice(1)
  }

  /** Call after each change. */
  changed(): void {
    this.#isKept = false
    clearTimeout(this.#timer)
    this.#timer = setTimeout(() => this.#write(), DELAY)
  }

  /** Whether the address has a link that has not been opened. */
  get isAddressNew(): boolean {
    return location.hash !== this.#hash
  }

  /**
   * Call once the link of a changed address was opened or refused. Until then the address is not overwritten. After a
   * refusal the previous state is saved again.
   */
  wasOpened(hash: string, isShown: boolean): void {
    // A newer link may have arrived, and even have been opened, during the wait.
    if (hash === location.hash) this.#hash = hash
    if (!isShown) this.changed()
  }

  async #write(): Promise<void> {
    clearTimeout(this.#timer)
    this.#timer = undefined
    const state = this.#read()
    if (state === undefined) return
    this.#lastWrite += 1
    const turn = this.#lastWrite
    const link = await this.#linkOf(state)
    // A newer state may exist by now.
    if (this.#timer !== undefined || turn !== this.#lastWrite) return
    if (this.isAddressNew) return this.changed()
    const isShort = link !== undefined && link.length <= LONGEST_ADDRESS
    history.replaceState(null, '', isShort ? `#${link}` : location.pathname + location.search)
    this.#hashBefore = this.#hash
    this.#hash = location.hash
    if (link !== undefined) await this.#storage?.write(this.#sceneOf(link))
    this.#isKept = this.#timer === undefined
  }

  /** Saves synchronously, because the page is about to close. */
  #writeAtOnce(): void {
    const state = this.#read()
    if (state === undefined || this.isAddressNew) return
    try {
      this.#storage?.put(this.#sceneOf(encodeLinkAtOnce(state)))
    } catch (error) {
      if (!(error instanceof CircleVoronoiError)) throw error
    }
  }

  /**
   * A scene that a reload restores. A closing page cannot change its address any more, and a reload may have started
   * before the address changed.
   */
  #sceneOf(link: string): SavedScene {
    return { link, hashes: [this.#hash, this.#hashBefore] }
  }

  /** `undefined` if the state is too large for a link. */
  async #linkOf(state: LinkInput): Promise<string | undefined> {
    try {
      return await this.#links.linkOf(state)
    } catch (error) {
      if (error instanceof CircleVoronoiError) return undefined
      throw error
    }
  }
}
