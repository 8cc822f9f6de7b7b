// SPDX-License-Identifier: GPL-3.0-or-later
import fc from 'fast-check'
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import {
  DATA_SETS,
  dataSetOf,
  labelOf,
  loadDataSet,
  loadLinked,
  nameFrom,
  nameOf,
  sourceOf,
} from '../../web/app/data-sets.ts'
import { FilesClient } from '../../web/app/files/files-client.ts'
import type { Recipe } from '../../web/app/generators/generators.ts'
import { LinkWriter } from '../../web/app/link-writer.ts'
import { SceneStorage } from '../../web/app/scene-storage.ts'
import { StatePersistence } from '../../web/app/state-persistence.ts'
import { circlesOfLink } from '../../web/editing/scene-link.ts'
import { decodeLink, encodeLink, LINK_LIMITS, type LinkInput } from '../../web/lib/link.ts'
import { CircleTable, NO_CHANGE } from '../../web/view/circle-table.ts'
import { library } from './library.ts'

const THREE = Float64Array.of(0, 0, 1, 5, 5, 2, 9, 9, 1)
const scene = { circles: THREE, dataSet: 'three', isEdited: false }

describe('what a link says of circles', () => {
  it('is the circles where there is no data set, or much was done', () => {
    const table = new CircleTable(THREE.slice())
    expect(circlesOfLink({ ...scene, dataSet: '' }, table, LINK_LIMITS.circles)).toEqual({ circles: THREE })
    expect(circlesOfLink({ ...scene, isEdited: true }, table, LINK_LIMITS.circles)).toEqual({ circles: THREE })
    table.follow({
      ...NO_CHANGE,
      replaced: Int32Array.of(0, 1, 2),
      circles: Float64Array.of(0, 0, 0, 1, 0, 0, 2, 0, 0),
    })
    expect(circlesOfLink(scene, table, LINK_LIMITS.circles)).toEqual({
      circles: Float64Array.of(0, 0, 0, 1, 0, 0, 2, 0, 0),
    })
  })

  it('makes the same circles of the data set again', () => {
    const circle = fc.record({ x: fc.integer({ min: 0, max: 9 }), y: fc.constant(5), r: fc.constantFrom(0, 1) })
    const step = fc.oneof(
      circle.map((circle) => ({ circle })),
      fc.record({ k: fc.nat() }),
      fc.record({ k: fc.nat(), circle }),
    )
    const many = Float64Array.from({ length: 3 * 40 }, (_, k) => (k % 3 === 2 ? 0 : k))
    fc.assert(
      fc.property(fc.array(step, { maxLength: 12 }), (steps) => {
        const editor = library.edit(many)
        const table = new CircleTable(many.slice())
        for (const step of steps) {
          const id = 'k' in step ? (editor.ids()[step.k % editor.size()] as number) : -1
          const edit = !('k' in step)
            ? { kind: 'insert' as const, ...step }
            : 'circle' in step
              ? { kind: 'replace' as const, id, circle: step.circle }
              : { kind: 'remove' as const, id }
          table.follow(editor.apply([edit]))
        }
        const { edits = [], dataSet } = circlesOfLink({ ...scene, circles: many }, table, LINK_LIMITS.circles)
        expect(dataSet).toBe('three')
        const again = library.edit(many)
        again.apply(edits)
        expect(again.snapshot().circles).toEqual(table.circles())
        editor.dispose()
        again.dispose()
      }),
      { numRuns: 50 },
    )
  })
})

describe('names of circles', () => {
  const nobody = () => Promise.reject(new Error('nothing is to be made'))

  it('say how circles are made, and nothing else is a name', async () => {
    const recipes: Recipe[] = [
      { kind: 'family', family: 'log-uniform', seed: 0, count: 1 },
      { kind: 'family', family: 'grid', seed: Number.MAX_SAFE_INTEGER, count: 1_000_000 },
      { kind: 'figure', figure: '15a' },
    ]
    for (const recipe of recipes) {
      expect(sourceOf(nameOf(recipe))).toEqual(recipe)
      expect(
        (await loadDataSet(nameOf(recipe), async (asked) => Float64Array.of(JSON.stringify(asked).length))).circles,
      ).toEqual(Float64Array.of(JSON.stringify(recipe).length))
    }
    const wrong = 'grid:1:1000001 grid:1:0 grid:9007199254740992:5 grid:1 grid:1:2:3 Grid:1:2 grid:-1:2'.split(' ')
    const others = ' random random: random:17 spruces:1 ../spruces __proto__ figure- figure-../6'.split(' ')
    for (const name of [...wrong, ...others]) {
      expect(sourceOf(name), name).toBeUndefined()
      expect(dataSetOf(name), name).toBeUndefined()
      expect(labelOf(name), name).toBe('')
      await expect(loadDataSet(name, nobody)).rejects.toThrow()
    }
  })

  it('each entry of the menu is found by its names', () => {
    for (const dataSet of DATA_SETS) expect(dataSetOf(nameFrom(dataSet))).toBe(dataSet)
    expect(labelOf('dense:3:4000')).toBe('dense, 4,000')
    expect(dataSetOf('dense:3:4001')).toBeUndefined()
  })

  it('of a link are as many as a link may have, and no more', async () => {
    const made: unknown[] = []
    const make = async (recipe: unknown) => {
      made.push(recipe)
      return new Float64Array()
    }
    await loadLinked(`grid:1:${LINK_LIMITS.circles}`, make)
    expect(made).toEqual([{ kind: 'family', family: 'grid', seed: 1, count: LINK_LIMITS.circles }])
    await expect(loadLinked(`grid:1:${LINK_LIMITS.circles + 1}`, make)).rejects.toThrow()
    expect(made).toHaveLength(1)
  })

  it('of more circles than a link may have do not stand for them', () => {
    const circles = new Float64Array(3 * LINK_LIMITS.circles + 3)
    const scene = { circles, dataSet: 'points:1:100001', isEdited: false }
    expect(circlesOfLink(scene, new CircleTable(circles), LINK_LIMITS.circles).circles).toHaveLength(circles.length)
  })
})

/** Writes links as a test says. */
const linksOf = (linkOf: () => Promise<string>) => Object.assign(new LinkWriter(new FilesClient()), { linkOf })

/** A storage with room for a number of characters. */
class Room extends Map<string, string> implements Storage {
  readonly #letters: number
  constructor(letters = Number.POSITIVE_INFINITY) {
    super()
    this.#letters = letters
  }
  get length() {
    return this.size
  }
  key = (k: number) => [...this.keys()][k] ?? null
  getItem = (key: string) => this.get(key) ?? null
  removeItem = (key: string) => void this.delete(key)
  setItem(key: string, value: string) {
    const others = [...this].filter(([name]) => name !== key)
    if (others.join('').length + key.length + value.length > this.#letters)
      throw new DOMException('', 'QuotaExceededError')
    this.set(key, value)
  }
}

interface Opening {
  readonly hash?: string
  readonly ofTab?: Room
  readonly isReload?: boolean
  readonly path?: string
}

/** The tabs of a browser. */
class Browser {
  readonly all: Room
  readonly #held = new Map<string, object>()
  #onclose = () => {}

  constructor(letters?: number) {
    this.all = new Room(letters)
  }

  async open({ hash = '', ofTab = new Room(), isReload = false, path = '/' }: Opening = {}) {
    const tab = {}
    const locks = {
      request: async (name: string, { ifAvailable = false }: LockOptions, hold: (lock: object | null) => unknown) => {
        if (!ifAvailable && this.#held.has(name)) {
          await new Promise<void>((resolve) => {
            this.#onclose = resolve
          })
        }
        const isFree = !this.#held.has(name)
        if (isFree) this.#held.set(name, tab)
        await hold(isFree ? {} : null)
      },
      query: async () => ({ held: [...this.#held.keys()].map((name) => ({ name })) }),
    }
    const [storage, shown] = await opened({ all: this.all, ofTab, path, locks }, isReload, hash)
    const close = () => {
      for (const [name, holder] of this.#held) if (holder === tab) this.#held.delete(name)
      this.#onclose()
    }
    return { shown, ofTab, path, close, write: (link: string) => storage.write({ link, hashes: [] }) }
  }

  /** Reloads a tab, and returns what it shows. */
  async reload({ ofTab, path, close }: { ofTab: Room; path: string; close(): void }) {
    // A reloaded tab waits until its former page has closed.
    const reloaded = this.open({ ofTab, path, isReload: true })
    close()
    return (await reloaded).shown
  }
}

/** Claims the storage of a tab. */
function opened(
  { all, ofTab, path = '/', locks }: { all: Room; ofTab: Room; path?: string; locks: object | undefined },
  isReload: boolean,
  hash: string,
) {
  vi.stubGlobal('localStorage', all)
  vi.stubGlobal('sessionStorage', ofTab)
  vi.stubGlobal('location', { pathname: path })
  vi.stubGlobal('navigator', { locks })
  return SceneStorage.claim(isReload, hash)
}

describe('the storage of scenes', () => {
  afterEach(() => vi.unstubAllGlobals())

  it('has a place for each tab', async () => {
    const browser = new Browser()
    const [first, second] = [await browser.open(), await browser.open()]
    await first.write('v1.a')
    await second.write('v1.b')
    const closed = await browser.open()
    await closed.write('v1.closed')
    closed.close()
    expect(await browser.reload(first)).toBe('v1.a')
    // Duplicates a tab.
    const copy = new Room()
    for (const [key, value] of second.ofTab) copy.setItem(key, value)
    const third = await browser.open({ ofTab: copy })
    expect(third.shown).toBe('v1.b')
    await third.write('v1.c')
    expect([await browser.reload(second), await browser.reload(third)]).toEqual(['v1.b', 'v1.c'])
    expect((await browser.open()).shown).toBe('v1.closed')
  })

  it('has a new place where the lock of the former one cannot be had', async () => {
    const [all, ofTab] = [new Room(), new Room()]
    const [storage] = await opened({ all, ofTab, locks: undefined }, false, '')
    storage.put({ link: 'v1.a', hashes: [] })
    const own = [...ofTab.values()]
    const locks = { request: () => Promise.reject(new DOMException('waited too long', 'AbortError')) }
    const [, shown] = await opened({ all, ofTab, locks }, true, '')
    expect(shown).toBe('v1.a')
    expect([...ofTab.values()]).not.toEqual(own)
  })

  it('makes room by what closed tabs have left, the oldest first, and never by that of open ones', async () => {
    const browser = new Browser(400)
    const open = await browser.open()
    await open.write('v1.open')
    for (const [time, link] of ['v1.older', 'v1.newer'].entries()) {
      vi.spyOn(Date, 'now').mockReturnValue(time)
      const tab = await browser.open({ hash: '#v1.link' })
      await tab.write(link)
      tab.close()
    }
    vi.restoreAllMocks()
    const large = await browser.open({ hash: '#v1.link' })
    await large.write('x'.repeat(150))
    expect((await browser.open()).shown).toBe('v1.newer')
    // A link that is too large is dropped without other effects.
    await large.write('y'.repeat(500))
    expect([await browser.reload(large), await browser.reload(open)]).toEqual(['x'.repeat(150), 'v1.open'])
  })

  it('keeps ten of closed tabs', async () => {
    const browser = new Browser()
    for (let k = 0; k < 14; k++) {
      const tab = await browser.open({ hash: '#v1.link' })
      await tab.write(`v1.${k}`)
      tab.close()
    }
    await (await browser.open({ hash: '#v1.link' })).write('v1.last')
    expect(browser.all.length).toBe(11)
  })

  it('leaves what a site in another folder of the origin keeps, above or below, and in the same tab', async () => {
    const browser = new Browser(800)
    const ofTab = new Room()
    const paths = ['/', '/voronoi/', '/voronoi/next/', '/voronoi%20old/']
    for (const [k, path] of paths.entries()) {
      const site = await browser.open({ ofTab, path })
      expect([path, site.shown]).toEqual([path, undefined])
      await site.write(`v1.${k}`)
      site.close()
    }
    // The page has several addresses in its folder.
    for (const [k, path] of paths.entries()) {
      const again = await browser.open({ path: `${path}index.html` })
      expect([path, again.shown]).toEqual([path, `v1.${k}`])
      // A large link does not displace the links of open tabs.
      await again.write('x'.repeat(300))
      again.close()
    }
    const kept = await Promise.all(paths.map(async (path) => (await browser.open({ path })).shown))
    expect(kept.map((link) => link?.length)).toEqual([300, 4, 4, 4])
  })

  it('keeps the one of a tab where there are no locks', async () => {
    const [all, ofTab] = [new Room(), new Room()]
    const shown = async (tab: Room) => {
      const [storage, link] = await opened({ all, ofTab: tab, locks: undefined }, false, '')
      await storage.write({ link: 'v1.a', hashes: [] })
      return link
    }
    expect([await shown(ofTab), await shown(ofTab), await shown(new Room())]).toEqual([undefined, 'v1.a', undefined])
  })
})

describe('what a page leaves late', () => {
  let page: EventTarget & { hidden: boolean }
  beforeEach(() => {
    vi.useFakeTimers()
    page = Object.assign(new EventTarget(), { hidden: false })
    vi.stubGlobal('document', page)
    vi.stubGlobal('localStorage', new Room())
    vi.stubGlobal('sessionStorage', new Room())
    vi.stubGlobal('navigator', {})
  })
  afterEach(() => {
    vi.useRealTimers()
    vi.restoreAllMocks()
    vi.unstubAllGlobals()
  })

  /** A closed page's link writer never finishes. */
  const gone = linksOf(() => new Promise<string>(() => {}))

  /** The link that a page finds when it reaches an address by a navigation of this type. */
  async function begun(type: NavigationTimingType, hash: string) {
    vi.stubGlobal('location', { hash, pathname: '/', search: '' })
    vi.spyOn(performance, 'getEntriesByType').mockReturnValue([{ type } as PerformanceNavigationTiming])
    let shown: LinkInput | undefined
    const keeping = new StatePersistence(gone, () => shown)
    const link = await keeping.begin()
    const leave = (state: LinkInput) => {
      shown = state
      keeping.changed()
      // The page closes before the debounce delay is over.
      page.hidden = true
      page.dispatchEvent(new Event('visibilitychange'))
      page.hidden = false
    }
    return { dataSet: link && (await decodeLink(link)).dataSet, leave }
  }

  const hash = async () => `#${await encodeLink({ dataSet: 'introduction' })}`

  it.each(['reload', 'back_forward'] as const)('is there again after %s', async (type) => {
    const { leave, dataSet } = await begun('navigate', await hash())
    expect(dataSet).toBe('introduction')
    leave({ dataSet: 'spruces' })
    for (let k = 0; k < 2; k++) expect((await begun(type, await hash())).dataSet).toBe('spruces')
    // The link is opened once more.
    expect((await begun('navigate', await hash())).dataSet).toBe('introduction')
    expect((await begun(type, await hash())).dataSet).toBe('introduction')
  })

  /** A page at an address. The test finishes its links. */
  function keeping(hash: string) {
    const made: ((link: string | Promise<string>) => void)[] = []
    const links = linksOf(() => new Promise<string>((resolve) => made.push(resolve)))
    const address = { hash, pathname: '/', search: '?q' }
    const replaced: string[] = []
    vi.stubGlobal('location', address)
    vi.stubGlobal('history', {
      replaceState: (_: unknown, __: string, to: string) => {
        replaced.push(to)
        address.hash = to.startsWith('#') ? to : ''
      },
    })
    vi.spyOn(performance, 'getEntriesByType').mockReturnValue([])
    return { made, address, replaced, keeping: new StatePersistence(links, () => ({ dataSet: 'spruces' })) }
  }

  it.each(['#v1.before', '#v1.new'])('is there where a reload began before the address changed: %s', async (loaded) => {
    const { made, address, keeping: kept } = keeping('#v1.before')
    await kept.begin()
    kept.changed()
    await vi.advanceTimersByTimeAsync(400)
    made[0]?.('v1.new')
    await vi.advanceTimersByTimeAsync(0)
    expect(address.hash).toBe('#v1.new')
    const { keeping: again } = keeping(loaded)
    vi.spyOn(performance, 'getEntriesByType').mockReturnValue([{ type: 'reload' } as PerformanceNavigationTiming])
    expect(await again.begin()).toBe('v1.new')
  })

  it('is not written over a link that is still to be opened, but after it', async () => {
    const { made, address, keeping: kept } = keeping('#v1.a')
    await kept.begin()
    kept.changed()
    await vi.advanceTimersByTimeAsync(400)
    address.hash = '#v1.b'
    expect(kept.isAddressNew).toBe(true)
    made[0]?.('v1.late')
    await vi.advanceTimersByTimeAsync(399)
    expect(address.hash).toBe('#v1.b')
    kept.wasOpened('#v1.b', true)
    await vi.advanceTimersByTimeAsync(1)
    made[1]?.('v1.c')
    await vi.advanceTimersByTimeAsync(0)
    expect(address.hash).toBe('#v1.c')
    expect(kept.isAddressNew).toBe(false)
  })

  it('is the newest where the link of something older takes longer', async () => {
    const { made, address, keeping: kept } = keeping('')
    await kept.begin()
    for (let k = 0; k < 2; k++) {
      kept.changed()
      await vi.advanceTimersByTimeAsync(400)
    }
    made[1]?.('v1.new')
    await vi.advanceTimersByTimeAsync(0)
    made[0]?.('v1.old')
    await vi.advanceTimersByTimeAsync(0)
    expect(address.hash).toBe('#v1.new')
  })

  it('is there again where the link of another address is refused', async () => {
    const { made, address, keeping: kept } = keeping('#v1.a')
    await kept.begin()
    address.hash = '#v1.damaged'
    kept.wasOpened('#v1.damaged', false)
    await vi.advanceTimersByTimeAsync(400)
    made[0]?.('v1.a')
    await vi.advanceTimersByTimeAsync(0)
    expect(address.hash).toBe('#v1.a')
  })

  it('is written at once where the page is hidden, if it is not kept yet, and not as it is shown again', async () => {
    const { made, keeping: kept } = keeping('')
    await kept.begin()
    const show = (hidden: boolean) => {
      page.hidden = hidden
      page.dispatchEvent(new Event('visibilitychange'))
      return made.length
    }
    expect([show(true), show(false)]).toEqual([0, 0])
    kept.changed()
    expect([show(false), show(true)]).toEqual([0, 1])
    made[0]?.('v1.a')
    await vi.advanceTimersByTimeAsync(1000)
    expect([show(true), made.length]).toEqual([1, 1])
  })
})
