// SPDX-License-Identifier: GPL-3.0-or-later
// Stores links in the browser: one per tab, so that tabs do not overwrite each other. A new tab continues with the last
// closed one.

/** Number of closed tabs that are stored. */
const MOST = 10
/** Wait for the lock of this tab's name after a reload, in milliseconds. It is usually released at once. */
const PATIENCE = 1000

/** The browser's services. `path` is the page's path. `locks` are missing in insecure contexts. */
export interface Surroundings {
  readonly all: Storage
  readonly ofTab: Storage
  readonly path: string
  readonly locks: LockManager | undefined
  readonly isReload: boolean
}

/** The entry of this tab's link. */
export class SceneStorage {
  readonly #all: Storage
  readonly #locks: LockManager | undefined
  readonly #prefix: string
  readonly #name: string
  /**
   * The entry whose scene the tab shows until its first write. The entry may belong to another tab or still be locked.
   */
  #from: string

  private constructor({ all, locks, path }: Surroundings, name: string, from: string) {
    this.#all = all
    this.#prefix = prefixOf(path)
    this.#locks = locks
    this.#name = name
    this.#from = from
  }

  /** `goesOn`: whether a tab without a link takes over the link of a closed tab. */
  static async claim(surroundings: Surroundings, goesOn: boolean): Promise<SceneStorage> {
    const prefix = prefixOf(surroundings.path)
    const own = surroundings.ofTab.getItem(prefix)
    const name = await claimedName(surroundings, goesOn)
    surroundings.ofTab.setItem(prefix, name)
    return new SceneStorage(surroundings, name, own ?? name)
  }

  read(): string | undefined {
    return this.#all.getItem(this.#prefix + this.#from)?.split(' ')[1]
  }

  /** Stores a link. If the storage is full, closed tabs are removed, oldest first. Gives up if that is not enough. */
  async write(link: string): Promise<void> {
    const held = new Set((await this.#locks?.query())?.held?.map(({ name }) => name))
    const prefix = this.#prefix
    const others = newestFirst(this.#all, prefix).filter((name) => name !== this.#name && !held.has(prefix + name))
    for (const name of others.splice(MOST)) this.#all.removeItem(prefix + name)
    while (!this.put(link)) {
      const oldest = others.pop()
      if (oldest === undefined) return
      this.#all.removeItem(prefix + oldest)
    }
  }

  /** Stores a link if there is room. Returns whether it succeeded. */
  put(link: string): boolean {
    try {
      this.#all.setItem(this.#prefix + this.#name, `${Date.now()} ${link}`)
      this.#from = this.#name
      return true
    } catch {
      return false
    }
  }
}

/**
 * The prefix of a site's keys. Pages in other folders of the same origin are other sites. Paths contain no spaces, so
 * that no prefix is the beginning of another.
 */
export function prefixOf(path: string): string {
  return `circle-voronoi ${path.slice(0, path.lastIndexOf('/') + 1)} `
}

async function claimedName({ all, ofTab, path, locks, isReload }: Surroundings, goesOn: boolean): Promise<string> {
  const prefix = prefixOf(path)
  const own = ofTab.getItem(prefix)
  if (locks === undefined) return own ?? crypto.randomUUID()
  // A duplicated tab has copied the other tab's name.
  if (own !== null && (await holds(locks, prefix + own, isReload ? PATIENCE : 0))) return own
  const left = goesOn && own === null ? newestFirst(all, prefix) : []
  for (const name of left) if (await holds(locks, prefix + name, 0)) return name
  const name = crypto.randomUUID()
  await holds(locks, prefix + name, 0)
  return name
}

function newestFirst(all: Storage, prefix: string): string[] {
  const names = Array.from({ length: all.length }, (_, k) => all.key(k) ?? '').filter((key) => key.startsWith(prefix))
  const timeOf = (key: string) => Number.parseInt(all.getItem(key) ?? '0', 10)
  return names.sort((a, b) => timeOf(b) - timeOf(a)).map((key) => key.slice(prefix.length))
}

/** Whether this tab holds a name exclusively until it is closed. */
function holds(locks: LockManager, name: string, patience: number): Promise<boolean> {
  return new Promise((resolve) => {
    const hold = (lock: Lock | null) => {
      resolve(lock !== null)
      return lock === null ? undefined : new Promise<void>(() => {})
    }
    const options = patience > 0 ? { signal: AbortSignal.timeout(patience) } : { ifAvailable: true }
    locks.request(name, options, hold).catch(() => resolve(false))
  })
}
