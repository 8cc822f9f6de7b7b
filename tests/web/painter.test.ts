// SPDX-License-Identifier: GPL-3.0-or-later
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import type { Circle, Edit } from '../../web/lib/index.ts'
import { BasePicture } from '../../web/view/base-picture.ts'
import { CircleTable } from '../../web/view/circle-table.ts'
import { DEFAULT_LAYERS } from '../../web/view/layers.ts'
import { Tiles } from '../../web/view/painter/tiles.ts'
import { Painter } from '../../web/view/painter.ts'
import type {
  FromPainter,
  GlobalResults,
  Highlights,
  InProgress,
  PaintRequest,
  PixelBox,
  ToPainter,
} from '../../web/view/protocol.ts'
import type { SceneClient } from '../../web/view/scene-client.ts'
import type { Style } from '../../web/view/style.ts'
import { library, seededRandom } from './library.ts'
import { Canvas } from './page-canvas.ts'

const COUNTS = { circles: 0, hidden: 0, vertices: 0, edges: 0 }
const NO_MARKS: Highlights = { selected: undefined, hovered: undefined }
/** The smallest valid module. The tests never run it. */
const WASM = Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0)

/** A thread that answers on command. */
class FakeWorker {
  static all: FakeWorker[] = []
  readonly got: ToPainter[] = []
  isTerminated = false
  onmessage: ((event: { data: FromPainter }) => void) | undefined
  onerror: ((event: { message: string }) => void) | undefined

  constructor() {
    FakeWorker.all.push(this)
  }

  postMessage(message: ToPainter): void {
    this.got.push(message)
  }

  terminate(): void {
    this.isTerminated = true
  }

  answer(data: FromPainter): void {
    this.onmessage?.({ data })
  }

  of<Kind extends ToPainter['kind']>(kind: Kind): Extract<ToPainter, { kind: Kind }>[] {
    return this.got.filter((message) => message.kind === kind) as Extract<ToPainter, { kind: Kind }>[]
  }
}

function opened(revision: number): FromPainter {
  return { kind: 'opened', scene: 1, revision, counts: COUNTS, seconds: 0 }
}

describe('the painter', () => {
  let painter: Painter
  let scene: SceneClient
  let found: (GlobalResults | undefined)[]
  const worker = (k = -1) => FakeWorker.all.at(k) as FakeWorker
  const request: PaintRequest = {
    paintId: 1,
    grid: { id: 1, x: 0, y: 0, scale: 1, pixelRatio: 1 },
    seen: { left: 0, top: 0, width: 10, height: 10 },
    wanted: { left: 0, top: 0, width: 256, height: 256 },
  }

  beforeEach(() => {
    FakeWorker.all = []
    vi.stubGlobal('Worker', FakeWorker)
    painter = new Painter({ wasm: WASM })
    found = []
    scene = painter.add({ painted() {}, marked() {}, outlined() {}, found: (each) => found.push(each), failed() {} })
  })
  afterEach(() => vi.unstubAllGlobals())

  it('tells why there is no thread, and tries once more when something is asked again', async () => {
    let isBroken = true
    class BrokenWorker extends FakeWorker {
      constructor() {
        if (isBroken) throw new Error('There are no threads here.')
        super()
      }
    }
    vi.stubGlobal('Worker', BrokenWorker)
    const other = new Painter({ wasm: WASM }).add({ painted() {}, marked() {}, outlined() {}, found() {}, failed() {} })
    await expect(other.open(new Float64Array())).rejects.toThrow('There are no threads here.')
    isBroken = false
    const open = other.open(new Float64Array())
    worker().answer(opened(2))
    expect((await open).counts).toEqual(COUNTS)
  })

  it('never tells a new thread what the last one was doing when it failed, and says that something failed', async () => {
    const circles = Float64Array.of(0, 0, 1)
    const failures: [string, unknown][] = []
    const events = { painted() {}, marked() {}, outlined() {}, found() {} }
    const failing = painter.add({ ...events, failed: ({ message }, lost) => failures.push([message, lost]) })
    const begin = async () => {
      const open = failing.open(circles)
      const { revision } = worker().of('open').at(-1) as { revision: number }
      worker().answer({ ...opened(revision), scene: 2 } as FromPainter)
      await open
      failing.look(request, {} as never)
      failing.setLayers({ ...DEFAULT_LAYERS, hull: true })
    }
    const told = () =>
      worker()
        .got.slice(1)
        .flatMap((message) => ('scene' in message && message.scene === 2 ? [message.kind] : []))
    const during = (kind: InProgress['kind']) =>
      worker().answer({ kind: 'failed', message: 'it broke', during: { scene: 2, kind } })

    await begin()
    // The request is unanswered when the thread ends, whatever the thread reports.
    failing.mark(0, undefined)
    worker().onerror?.({ message: 'it broke' })
    expect(told()).toEqual(['add', 'layers', 'open', 'look'])
    const message = expect.stringContaining('it broke')
    expect(failures).toEqual([[message, { marks: true, layers: false }]])

    // The next thread fails before it has done anything. Its successor receives less, and has no successor itself.
    during('paint')
    expect(told()).toEqual(['add', 'open', 'look'])
    expect(failures.at(-1)).toEqual([message, { marks: true, layers: true }])
    during('paint')
    expect(FakeWorker.all.length).toBe(3)

    // Answered settings are repeated, unless the thread fails while describing them.
    for (const [kind, marks, layers] of [
      ['ask', false, false],
      ['edit', true, false],
      ['look', true, false],
      ['find', false, true],
      ['layers', false, true],
    ] as const) {
      await begin()
      failing.mark(0, undefined)
      worker().answer({ kind: 'marked', scene: 2, marks: NO_MARKS })
      during(kind)
      expect(failures.at(-1)).toEqual([message, { marks, layers }])
      expect([told().includes('mark'), told().includes('layers')]).toEqual([!marks, !layers])
    }
    // A failure of another scene is not caused by this one.
    await begin()
    worker().answer({ kind: 'failed', message: 'it broke', during: { scene: 1, kind: 'paint' } })
    expect(failures.at(-1)).toEqual([message, { marks: false, layers: false }])
  })

  it('replaces a thread that continues by another one with all layers once everything is painted again', async () => {
    const open = scene.open(Float64Array.of(0, 0, 1))
    worker().answer(opened(1))
    await open
    scene.setLayers(DEFAULT_LAYERS)
    const painted = { kind: 'painted', scene: 1, grid: 1, patches: [], paintId: 1 } as const
    const failAfter = (isWhole: boolean) => {
      worker().answer({ ...painted, isWhole })
      worker().onerror?.({ message: 'it broke' })
      return [FakeWorker.all.length, worker().of('layers').length]
    }
    expect([true, true, false].map(failAfter)).toEqual([
      [2, 1],
      [3, 1],
      [4, 0],
    ])
  })

  it('starts nothing once it is disposed of', async () => {
    painter.dispose()
    await expect(scene.open(new Float64Array())).rejects.toThrow(/disposed/)
    expect(FakeWorker.all.length).toBe(1)
  })
})

describe('what another thread has to know', () => {
  it('makes the same circles by the same ids', () => {
    const random = seededRandom(17)
    const circleOf = (): Circle => ({ x: 20 * random(), y: 20 * random(), r: 3 * random() ** 4 })
    for (let round = 0; round < 20; round++) {
      const circles = Float64Array.from({ length: 3 * Math.floor(8 * random()) }, random)
      const editor = library.edit(circles)
      const table = new CircleTable(circles.slice())
      let next = circles.length / 3
      for (let k = 0; k < 40; k++) {
        const ids = editor.ids()
        const id = ids[Math.floor(random() * ids.length)]
        const choice = random()
        const edits: Edit[] = []
        if (choice < 0.5 || id === undefined) edits.push({ kind: 'insert', circle: circleOf() })
        else if (choice < 0.7) edits.push({ kind: 'remove', id })
        else if (choice < 0.9)
          edits.push({ kind: 'replace', id, circle: circleOf() }, { kind: 'insert', circle: circleOf() })
        else {
          const come = { kind: 'insert', circle: circleOf() } as const
          edits.push(come, { kind: 'remove', id: next }, come)
        }
        // A refused edit assigns no ids.
        expect(() => editor.apply([...edits, { kind: 'remove', id: 1e6 }])).toThrow()
        table.follow(editor.apply(edits))
        next += edits.filter(({ kind }) => kind === 'insert').length
      }
      const other = library.edit(table.circles(), table.keptIds)
      const copy = new CircleTable(table.circles(), 0, table.keptIds)
      for (const ids of [other.ids(), copy.ids()]) expect([...ids]).toEqual([...editor.ids()])
      expect([copy.circles(), copy.size, copy.count]).toEqual([table.circles(), table.size, table.count])
      for (const id of editor.ids()) expect(other.circle(id)).toEqual(editor.circle(id))
      const another = circleOf()
      expect([...other.insert(another).inserted]).toEqual([...editor.insert(another).inserted])
    }
  })
})

describe('tiles', () => {
  const style = {} as Style
  const paintAll = (tiles: Tiles) => {
    const boxes: PixelBox[] = []
    for (let patch = tiles.paintNext(); patch !== undefined; patch = tiles.paintNext()) boxes.push(patch.box)
    return boxes
  }
  beforeEach(() => vi.stubGlobal('OffscreenCanvas', Canvas))
  afterEach(() => vi.unstubAllGlobals())

  it('of a viewport are painted once, and again when the whole picture or the grid has changed', () => {
    const tiles = new Tiles(() => {})
    const box = { left: 0, top: 0, width: 512, height: 512 }
    const grid = { id: 1, x: 0, y: 0, scale: 1, pixelRatio: 1 }
    const viewport = { paintId: 1, grid, seen: box, wanted: box, style }
    const counts = [
      () => tiles.turnTo(viewport),
      () => tiles.turnTo(viewport),
      () => tiles.restart(),
      () => tiles.turnTo({ ...viewport, grid: { ...grid, id: 2, scale: 2 } }),
    ].map((act) => {
      act()
      return paintAll(tiles).length
    })
    expect(counts).toEqual([4, 0, 4, 4])
  })

  it.each([1, 2])(
    'in the middle are painted first, and changed boxes with their strokes: pixel ratio %d',
    (pixelRatio) => {
      const tiles = new Tiles(() => {})
      const grid = { id: 1, x: 0, y: 0, scale: 1, pixelRatio }
      const seen = { left: 300, top: 300, width: 150, height: 150 }
      tiles.turnTo({ paintId: 1, grid, seen, wanted: { left: 0, top: 0, width: 768, height: 768 }, style })
      const boxes = paintAll(tiles)
      const away = boxes.map(({ left, top }) => Math.max(Math.abs(left + 128 - 375), Math.abs(top + 128 - 375)))
      expect(away).toEqual(away.toSorted((one, other) => one - other))
      expect([boxes.length, boxes[0]]).toEqual([9, { left: 256, top: 256, width: 256, height: 256 }])
      const changed = tiles.repaint([{ minX: 300, minY: -340, maxX: 320, maxY: -310 }])
      const margin = 4 * pixelRatio
      expect(changed.map(({ box }) => box)).toEqual([
        { left: 300 - margin, top: 310 - margin, width: 20 + 2 * margin, height: 30 + 2 * margin },
      ])
      expect(tiles.repaint(undefined)).toHaveLength(9)
    },
  )
})

describe('the base picture', () => {
  const size = { width: 300, height: 200 }
  const ORIGIN = { x: 0, y: 0, scale: 1 }
  let canvases: { drawn: unknown[][]; width: number; height: number }[]
  let closed: number
  beforeEach(() => {
    canvases = []
    closed = 0
    vi.stubGlobal(
      'OffscreenCanvas',
      class {
        readonly drawn: unknown[][] = []
        readonly width: number
        readonly height: number
        constructor(width: number, height: number) {
          this.width = width
          this.height = height
          canvases.push(this)
        }
        getContext() {
          return {
            drawImage: (...args: unknown[]) => this.drawn.push(args),
            clearRect: (...box: unknown[]) => this.drawn.push(['clear', ...box]),
          }
        }
      },
    )
  })
  afterEach(() => vi.unstubAllGlobals())

  const image = { close: () => closed++ } as unknown as ImageBitmap
  const patch = { box: { left: 256, top: 512, width: 256, height: 256 }, image }
  const whole = (picture: BasePicture, { paintId, grid }: PaintRequest) =>
    picture.put({ kind: 'painted', scene: 1, grid: grid.id, patches: [], paintId, isWhole: true })
  /** The canvases on the screen, with their places. */
  const shown = (picture: BasePicture, camera: typeof ORIGIN, ratio = 1) => {
    const places: unknown[][] = []
    const context = {
      canvas: { width: 300 * ratio, height: 200 * ratio },
      clearRect: (...box: number[]) => places.push(['clear', ...box]),
      drawImage: (canvas: (typeof canvases)[number], ...place: number[]) =>
        places.push([canvases.indexOf(canvas), ...place.map((pixel) => Math.round(100 * pixel) / 100)]),
    }
    picture.draw(context as unknown as CanvasRenderingContext2D, camera, size, ratio)
    expect(places[0]).toEqual(['clear', 0, 0, 300 * ratio, 200 * ratio])
    return places.slice(1)
  }

  it('asks for whole tiles around what is seen, and for more only beyond them', () => {
    const picture = new BasePicture()
    const first = picture.see(ORIGIN, size, 1)
    expect(first).toEqual({
      paintId: 1,
      grid: { id: 1, x: -150, y: 100, scale: 1, pixelRatio: 1 },
      seen: { left: 0, top: 0, width: 301, height: 201 },
      wanted: { left: -256, top: -256, width: 1024, height: 768 },
    })
    expect([canvases[0]?.width, canvases[0]?.height]).toEqual([1024, 768])
    // The last places within the margins on all four sides.
    for (const [x, y] of [
      [-256, 0],
      [467, 0],
      [0, 256],
      [0, -311],
    ] as const) {
      const other = new BasePicture()
      other.see(ORIGIN, size, 1)
      expect(other.see({ ...ORIGIN, x, y }, size, 1), `${x} ${y}`).toBeUndefined()
      expect(other.see({ ...ORIGIN, x: x + Math.sign(x), y: y + Math.sign(y) }, size, 1)).toBeDefined()
    }
    const before = canvases.length
    const more = picture.see({ ...ORIGIN, x: 600, y: -300 }, size, 1)
    expect(more).toMatchObject({ paintId: 2, grid: first?.grid, wanted: { left: 256, top: 0 } })
    // Pixels that are known are copied.
    expect(canvases[before]?.drawn).toEqual([[canvases[0], -256 - 256, -256]])
  })

  it('asks for all pixels again, for what is seen then, and is whole once that request is painted', () => {
    const picture = new BasePicture()
    expect(picture.again(ORIGIN, size)).toBeUndefined()
    const first = picture.see(ORIGIN, size, 2) as PaintRequest
    whole(picture, first)
    expect([picture.isWhole, picture.isSharp({ ...ORIGIN, x: 9, y: 9 }, 2)]).toEqual([true, true])
    expect(picture.again({ x: 10, y: 20, scale: 1 }, size)).toEqual({
      paintId: 2,
      grid: first.grid,
      seen: { left: 20, top: -40, width: 601, height: 401 },
      wanted: first.wanted,
    })
    expect(picture.isWhole).toBe(false)
    whole(picture, first)
    expect(picture.isWhole).toBe(false)
    whole(picture, { ...first, paintId: 2 })
    expect(picture.isWhole).toBe(true)
    expect([1, 2].map((ratio) => picture.isSharp({ ...ORIGIN, scale: 2 }, ratio))).toEqual([false, false])
    picture.clear()
    expect([picture.isWhole, shown(picture, ORIGIN)]).toEqual([false, []])
  })

  it('is drawn where the camera is, enlarged until sharp pixels are there, and on whole pixels in its own scale', () => {
    const picture = new BasePicture()
    whole(picture, picture.see(ORIGIN, size, 2) as PaintRequest)
    expect(shown(picture, ORIGIN, 2)).toEqual([[0, -256, -256, 1280, 1024]])
    expect(shown(picture, { ...ORIGIN, x: 10, y: 5 }, 2)).toEqual([[0, -276, -246, 1280, 1024]])
    const places = [1, 1.5].map((scale) => shown(picture, { x: 0.3, y: 0.4, scale }, 2).flat())
    expect(places.map((place) => place.every(Number.isInteger))).toEqual([true, false])
    // Pixels of half the scale are shown twice as large around the middle of the picture.
    expect(shown(picture, { ...ORIGIN, scale: 2 }, 2)).toEqual([[0, -300 - 512, -200 - 512, 2560, 2048]])
    const counts = [256, 257, 1 / 256, 1 / 257].map((scale) => shown(picture, { ...ORIGIN, scale }, 2).length)
    expect(counts).toEqual([1, 0, 1, 0])
    // The former pixels are below the new ones until the new ones are whole. Only two scales are kept.
    const visible = (scale: number) => shown(picture, { ...ORIGIN, scale }, 2).map(([canvas]) => canvas)
    const second = picture.see({ ...ORIGIN, scale: 2 }, size, 2) as PaintRequest
    expect(visible(2)).toEqual([0, 1])
    const third = picture.see({ ...ORIGIN, scale: 4 }, size, 2) as PaintRequest
    expect(visible(4)).toEqual([0, 2])
    whole(picture, second)
    expect(visible(4)).toEqual([0, 2])
    whole(picture, third)
    expect(visible(4)).toEqual([2])
  })

  it('takes patches where they belong, frees them, and shows no circles from before an edit', () => {
    const picture = new BasePicture()
    const first = picture.see(ORIGIN, size, 1) as PaintRequest
    picture.put({ kind: 'painted', scene: 1, grid: first.grid.id, patches: [patch], paintId: 1, isWhole: true })
    expect(canvases[0]?.drawn).toEqual([[image, 512, 768]])
    const second = picture.see({ ...ORIGIN, scale: 2 }, size, 1) as PaintRequest
    const boxes = [{ minX: 10, minY: 20, maxX: 40, maxY: 70 }]
    const edited = (grid: number) => {
      for (const { drawn } of canvases) drawn.length = 0
      picture.put({ kind: 'edited', grid, patches: [patch], boxes } as never)
      return canvases.map(({ drawn }) => drawn)
    }
    const cleared = ['clear', 10 + 150 + 256, 100 - 70 + 256, 30, 50]
    expect(edited(first.grid.id)).toEqual([[[image, 512, 768]], []])
    expect(edited(second.grid.id)).toEqual([[cleared], [[image, expect.any(Number), expect.any(Number)]]])
    expect(edited(99)).toEqual([[cleared], []])
    expect(closed).toBe(4)
  })
})
