// SPDX-License-Identifier: GPL-3.0-or-later
// Links in the storage of the browser: one for each tab, so that none destroys that of another, and a new tab goes on where one
// that was closed ended.

const PREFIX = 'circle-voronoi/'
/** So many of closed tabs are kept. */
const MOST = 10
/** A tab that is loaded again mostly has its name as soon as it is gone, in milliseconds. */
const PATIENCE = 1000

/** What of the browser this needs. `locks` are missing where a page is not served securely. */
export interface Surroundings {
  readonly all: Storage
  readonly ofTab: Storage
  readonly locks: LockManager | undefined
  readonly isReload: boolean
}

/** The place of this tab's link. */
export class SceneStorage {
  readonly #all: Storage
  readonly #locks: LockManager | undefined
  readonly #name: string
  /** Whose scene it shows until it has written one: also that of a tab that has its name, or has not given it back yet. */
  #from: string

  private constructor({ all, locks }: Surroundings, name: string, from: string) {
    this.#all = all
    this.#locks = locks
    this.#name = name
    this.#from = from
  }

  /** `goesOn`: whether a tab that has nothing yet takes what a closed one has left. */
  static async claim(surroundings: Surroundings, goesOn: boolean): Promise<SceneStorage> {
    const own = surroundings.ofTab.getItem(PREFIX)
    const name = await claimedName(surroundings, goesOn)
    surroundings.ofTab.setItem(PREFIX, name)
    return new SceneStorage(surroundings, name, own ?? name)
  }

  read(): string | undefined {
    return this.#all.getItem(PREFIX + this.#from)?.split(' ')[1]
  }

  /** Keeps a link. Where there is no room, those of closed tabs go, the oldest first; if that is not enough, it is not kept. */
  async write(link: string): Promise<void> {
    const held = new Set((await this.#locks?.query())?.held?.map(({ name }) => name))
    const others = newestFirst(this.#all).filter((name) => name !== this.#name && !held.has(PREFIX + name))
    for (const name of others.splice(MOST)) this.#all.removeItem(PREFIX + name)
    while (!this.put(link)) {
      const oldest = others.pop()
      if (oldest === undefined) return
      this.#all.removeItem(PREFIX + oldest)
    }
  }

  /** Keeps a link if there is room without anything else going: whether there was. */
  put(link: string): boolean {
    try {
      this.#all.setItem(PREFIX + this.#name, `${Date.now()} ${link}`)
      this.#from = this.#name
      return true
    } catch {
      return false
    }
  }
}

async function claimedName({ all, ofTab, locks, isReload }: Surroundings, goesOn: boolean): Promise<string> {
  const own = ofTab.getItem(PREFIX)
  if (locks === undefined) return own ?? crypto.randomUUID()
  // A tab that was duplicated has the name of the other.
  if (own !== null && (await holds(locks, own, isReload ? PATIENCE : 0))) return own
  for (const name of goesOn && own === null ? newestFirst(all) : []) if (await holds(locks, name, 0)) return name
  const name = crypto.randomUUID()
  await holds(locks, name, 0)
  return name
}

function newestFirst(all: Storage): string[] {
  const names = Array.from({ length: all.length }, (_, k) => all.key(k) ?? '').filter((key) => key.startsWith(PREFIX))
  const timeOf = (key: string) => Number.parseInt(all.getItem(key) ?? '0', 10)
  return names.sort((a, b) => timeOf(b) - timeOf(a)).map((key) => key.slice(PREFIX.length))
}

/** Whether this tab, until it is closed, and no other one has a name. */
function holds(locks: LockManager, name: string, patience: number): Promise<boolean> {
  return new Promise((resolve) => {
    const hold = (lock: Lock | null) => {
      resolve(lock !== null)
      return lock === null ? undefined : new Promise<void>(() => {})
    }
    const options = patience > 0 ? { signal: AbortSignal.timeout(patience) } : { ifAvailable: true }
    locks.request(PREFIX + name, options, hold).catch(() => resolve(false))
  })
}
