// SPDX-License-Identifier: GPL-3.0-or-later
import { CircleVoronoiError } from '../lib/index.ts'
import { encodeLinkAtOnce, type LinkInput } from '../lib/link.ts'
import type { LinkWriter } from './link-writer.ts'
import { prefixOf, SceneStorage } from './scene-storage.ts'

/** What changes for so long, in milliseconds, is kept once. */
const REST = 400
/** Longer links are kept by the storage alone: addresses have to stay short enough to be copied. */
const LONGEST_ADDRESS = 100_000
/**
 * The entry of the session storage with the newest link, and with the addresses at which a reload shows it. A page that closes
 * can no longer change its address, and a reload may have begun before the address changed.
 */
const lateKey = () => `${prefixOf(location.pathname)}late`

/** Keeps what is shown: as a link in the address, and in the storage of the browser. */
export class Keeping {
  readonly #read: () => LinkInput | undefined
  readonly #links: LinkWriter
  #storage: SceneStorage | undefined
  #timer: ReturnType<typeof setTimeout> | undefined
  /** Whether what is shown is kept, up to the last change. */
  #isKept = true
  /** The writing that was begun last: one that was begun before may end later. */
  #lastWrite = 0
  /** What the address said when it was read or written here last: another one is a link that is about to be opened. */
  #hash = ''
  /** What the address said before the last write. */
  #hashBefore = ''

  /** `read`: what is shown, as soon as it is anything. */
  constructor(links: LinkWriter, read: () => LinkInput | undefined) {
    this.#links = links
    this.#read = read
    document.addEventListener('visibilitychange', () => {
      if (!document.hidden || this.#isKept) return
      this.#writeAtOnce()
      this.#write()
    })
  }

  /** What was kept: the link of the address, or else what this tab or a closed one showed last. */
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
      // A browser may forbid its storage.
    }
    return late ?? (link !== '' ? link : this.#storage?.read())
  }

  /** To be called after each change. */
  changed(): void {
    this.#isKept = false
    clearTimeout(this.#timer)
    this.#timer = setTimeout(() => this.#write(), REST)
  }

  /** Whether the address has a link that is still to be opened. */
  get isAddressNew(): boolean {
    return location.hash !== this.#hash
  }

  /**
   * To be called once the link of a changed address was opened, or could not be: till then it is not written over. What stayed
   * in its place is kept.
   */
  wasOpened(hash: string, isShown: boolean): void {
    // Meanwhile there may be another one, which may even have been opened first.
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
    // Meanwhile there may be something newer.
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

  /** For a page that is about to go: what ends later is lost. */
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

  /** Returns the text of the entry: the link, and the addresses at which a reload shows it. */
  #lateText(link: string): string {
    return `${link} ${this.#hash} ${this.#hashBefore}`
  }

  /** `undefined`: too large for a link. */
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
 * Returns the link that the page of an address left last, if the page is there again: by a reload, or by Back and Forward.
 * Whoever opens the address as a link gets what the link says, and nothing is left.
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
    // There is no room, or it is forbidden.
  }
}
