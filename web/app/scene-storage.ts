// SPDX-License-Identifier: GPL-3.0-or-later
// Stores the scenes of tabs in the browser, each in its own entry, so that tabs do not overwrite each other. An entry is the
// time, a link, and the hashes of the addresses at which a reload restores the link.

/** Number of closed tabs that are stored. */
const MOST = 10
/** Wait for the lock of this tab's name after a reload, in milliseconds. It is usually released at once. */
const PATIENCE = 1000

export interface SavedScene {
  readonly link: string
  readonly hashes: readonly string[]
}

/** The entry of this tab. */
export class SceneStorage {
  readonly #entries = localStorage
  readonly #locks: LockManager | undefined = navigator.locks
  readonly #prefix: string
  #key = ''

  private constructor() {
    // Pages in other folders of the same origin are other sites. Paths contain no spaces, so that no prefix is the
    // beginning of another.
    const { pathname } = location
    this.#prefix = `circle-voronoi ${pathname.slice(0, pathname.lastIndexOf('/') + 1)} `
  }

  /**
   * Claims an entry. Returns it with the link that the tab continues. Without a hash, this is the link of the tab, or of
   * the tab that was closed last; after a reload, the link of its address.
   */
  static async claim(isReload: boolean, hash: string): Promise<[SceneStorage, string | undefined]> {
    const storage = new SceneStorage()
    const tab = sessionStorage
    const own = tab.getItem(storage.#prefix) ?? undefined
    const key = await storage.#claimed(own, isReload, hash === '')
    storage.#key = key
    tab.setItem(storage.#prefix, key)
    // A duplicated tab has copied the key of the other tab, and continues its scene.
    const [, link, ...hashes] = (storage.#entries.getItem(own ?? key) ?? '').split(' ')
    if (hash === '' || (isReload && hashes.includes(hash))) return [storage, link]
    // Once the link of an address is opened, a reload restores nothing older there.
    if (link !== undefined && key === own) storage.put({ link, hashes: [] })
    return [storage, undefined]
  }

  /** Stores a scene. If the storage is full, closed tabs are removed, oldest first. Gives up if that is not enough. */
  async write(scene: SavedScene): Promise<void> {
    const held = new Set((await this.#locks?.query())?.held?.map(({ name }) => name))
    const closed = this.#newestFirst().filter((key) => key !== this.#key && !held.has(key))
    for (const key of closed.splice(MOST)) this.#entries.removeItem(key)
    while (!this.put(scene)) {
      const oldest = closed.pop()
      if (oldest === undefined) return
      this.#entries.removeItem(oldest)
    }
  }

  /** Stores a scene if there is room. Returns whether it succeeded. */
  put({ link, hashes }: SavedScene): boolean {
    try {
      this.#entries.setItem(this.#key, [Date.now(), link, ...hashes].join(' '))
      return true
    } catch {
      return false
    }
  }

  async #claimed(own: string | undefined, isReload: boolean, goesOn: boolean): Promise<string> {
    const created = this.#prefix + crypto.randomUUID()
    if (this.#locks === undefined) return own ?? created
    if (own !== undefined && (await holds(this.#locks, own, isReload))) return own
    for (const key of goesOn && own === undefined ? this.#newestFirst() : []) {
      if (await holds(this.#locks, key, false)) return key
    }
    await holds(this.#locks, created, false)
    return created
  }

  #newestFirst(): string[] {
    const timeOf = (key: string) => Number.parseInt(this.#entries.getItem(key) ?? '0', 10)
    const keys = Array.from({ length: this.#entries.length }, (_, k) => this.#entries.key(k) ?? '')
    return keys.filter((key) => key.startsWith(this.#prefix)).sort((a, b) => timeOf(b) - timeOf(a))
  }
}

/** Whether this tab holds a key exclusively until it is closed. */
function holds(locks: LockManager, key: string, waits: boolean): Promise<boolean> {
  return new Promise((resolve) => {
    const hold = (lock: Lock | null) => {
      resolve(lock !== null)
      return lock === null ? undefined : new Promise<void>(() => {})
    }
    const options = waits ? { signal: AbortSignal.timeout(PATIENCE) } : { ifAvailable: true }
    locks.request(key, options, hold).catch(() => resolve(false))
  })
}
