// SPDX-License-Identifier: GPL-3.0-or-later
// Links in the storage of the browser: one for each tab, so that none destroys that of another, and a new tab goes on where one
// that was closed ended.

/** So many of closed tabs are kept. */
const MOST = 10
/** A tab that is loaded again mostly has its name as soon as it is gone, in milliseconds. */
const PATIENCE = 1000

/** What of the browser this needs. `path`: that of the page. `locks` are missing where a page is not served securely. */
export interface Surroundings {
  readonly all: Storage
  readonly ofTab: Storage
  readonly path: string
  readonly locks: LockManager | undefined
  readonly isReload: boolean
}

/** The place of this tab's link. */
export class SceneStorage {
  readonly #all: Storage
  readonly #locks: LockManager | undefined
  readonly #prefix: string
  readonly #name: string
  /** Whose scene it shows until it has written one: also that of a tab that has its name, or has not given it back yet. */
  #from: string

  private constructor({ all, locks, path }: Surroundings, name: string, from: string) {
    this.#all = all
    this.#prefix = prefixOf(path)
    this.#locks = locks
    this.#name = name
    this.#from = from
  }

  /** `goesOn`: whether a tab that has nothing yet takes what a closed one has left. */
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

  /** Keeps a link. Where there is no room, those of closed tabs go, the oldest first; if that is not enough, it is not kept. */
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

  /** Keeps a link if there is room without anything else going: whether there was. */
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
 * What the keys of one site begin with: pages in other folders of the origin are other sites, with scenes of their own. A path
 * has no spaces, so no prefix begins another one.
 */
export function prefixOf(path: string): string {
  return `circle-voronoi ${path.slice(0, path.lastIndexOf('/') + 1)} `
}

async function claimedName({ all, ofTab, path, locks, isReload }: Surroundings, goesOn: boolean): Promise<string> {
  const prefix = prefixOf(path)
  const own = ofTab.getItem(prefix)
  if (locks === undefined) return own ?? crypto.randomUUID()
  // A tab that was duplicated has the name of the other.
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

/** Whether this tab, until it is closed, and no other one has a name. */
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
