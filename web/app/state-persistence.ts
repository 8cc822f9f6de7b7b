// SPDX-License-Identifier: GPL-3.0-or-later
import { CircleVoronoiError } from '../lib/index.ts'
import { encodeLinkAtOnce, type LinkInput } from '../lib/link.ts'
import type { LinkWriter } from './link-writer.ts'
import { prefixOf, SceneStorage } from './scene-storage.ts'

/** Debounce delay in milliseconds. */
const REST = 400
/** Longer links are saved to the storage only, because addresses must stay short enough to copy. */
const LONGEST_ADDRESS = 100_000
/**
 * The session storage entry with the newest link and the addresses at which a reload restores it. A closing page cannot
 * change its address any more, and a reload may have started before the address changed.
 */
const lateKey = () => `${prefixOf(location.pathname)}late`

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
    const link = this.#hash.slice(1)
    let late: string | undefined
    try {
      const [navigation] = performance.getEntriesByType('navigation') as PerformanceNavigationTiming[]
      const isReload = navigation?.type !== 'navigate'
      late = takenLate(this.#hash, isReload)
      const { pathname: path } = location
      const surroundings = { all: localStorage, ofTab: sessionStorage, path, locks: navigator.locks, isReload }
      this.#storage = await SceneStorage.claim(surroundings, link === '')
    } catch {
      // Storage may be forbidden.
    }
    return late ?? (link !== '' ? link : this.#storage?.read())
  }

  /** Call after each change. */
  changed(): void {
    this.#isKept = false
    clearTimeout(this.#timer)
    this.#timer = setTimeout(() => this.#write(), REST)
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
    keepLate(link !== undefined && this.#hash !== this.#hashBefore ? this.#lateText(link) : '')
    if (link !== undefined) await this.#storage?.write(link)
    this.#isKept = this.#timer === undefined
  }

  /** Saves synchronously, because the page is about to close. */
  #writeAtOnce(): void {
    const state = this.#read()
    if (state === undefined || this.isAddressNew) return
    try {
      const link = encodeLinkAtOnce(state)
      this.#storage?.put(link)
      keepLate(this.#lateText(link))
    } catch (error) {
      if (!(error instanceof CircleVoronoiError)) throw error
    }
  }

  /** The text of the entry: the link, and the addresses at which a reload restores it. */
  #lateText(link: string): string {
    return `${link} ${this.#hash} ${this.#hashBefore}`
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

/**
 * Returns and removes the link that the page left at an address, if the page returns by reload, Back or Forward.
 * Opening the address as a link discards the entry.
 */
function takenLate(hash: string, isThereAgain: boolean): string | undefined {
  const [link, ...hashes] = (sessionStorage.getItem(lateKey()) ?? '').split(' ')
  sessionStorage.removeItem(lateKey())
  return isThereAgain && hashes.includes(hash) ? link : undefined
}

function keepLate(text: string): void {
  try {
    sessionStorage.setItem(lateKey(), text)
  } catch {
    // The storage is full or forbidden.
  }
}
