// SPDX-License-Identifier: GPL-3.0-or-later
import fc from 'fast-check'
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import type { Point } from '../../web/lib/index.ts'
import { toPlane, toScreen } from '../../web/view/camera.ts'
import { Tiles } from '../../web/view/painter/tiles.ts'
import { type Grid, type Painted, type PaintRequest, type PixelBox, TILE } from '../../web/view/protocol.ts'
import type { Style } from '../../web/view/style.ts'
import { MOST_ENLARGED, TileBuffer } from '../../web/view/tile-buffer.ts'
import { action as actionOf } from './arbitrary-circles.ts'
import { Canvas } from './page-canvas.ts'

describe('tiles', () => {
  const style = {} as Style
  const paintAll = (tiles: Tiles) => {
    const boxes: PixelBox[] = []
    while (tiles.isWaiting) boxes.push(...tiles.paintNext().map(({ box }) => box))
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

  it('of another picture are shown once all visible ones are painted, and of the first one at once', () => {
    const tiles = new Tiles(() => {})
    const seen = { left: 256, top: 256, width: 512, height: 256 }
    const grid = { id: 1, x: 0, y: 0, scale: 1, pixelRatio: 1 }
    const wanted = { left: 0, top: 0, width: 1024, height: 768 }
    tiles.turnTo({ paintId: 1, grid, seen, wanted, style })
    /** The number of tiles that each step shows. */
    const shown = () => {
      const counts: number[] = []
      while (tiles.isWaiting) counts.push(tiles.paintNext().length)
      return counts
    }
    expect(shown()).toEqual(Array(12).fill(1))
    tiles.restart()
    expect(shown()).toEqual([0, 2, ...Array(10).fill(1)])
    // An edit shows all at once, and another grid has nothing to keep.
    tiles.restart()
    tiles.paintNext()
    expect([tiles.release().length, tiles.paintSeen().length]).toEqual([1, 1])
    tiles.restart()
    tiles.turnTo({ paintId: 2, grid: { ...grid, id: 2 }, seen, wanted, style })
    expect(shown()).toEqual(Array(12).fill(1))
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

/** A piece of a picture on a canvas: pixels of a grid, after so many edits. */
interface Piece {
  readonly grid: Grid
  readonly box: PixelBox
  readonly edits: number
  readonly left: number
  readonly top: number
  readonly width: number
}

/** A canvas that keeps the pieces that are drawn on it. */
class PieceCanvas {
  pieces: Piece[] = []
  readonly canvas = this
  readonly width: number
  readonly height: number
  constructor(width: number, height: number) {
    this.width = width
    this.height = height
  }
  getContext() {
    return this
  }
  drawImage({ pieces, width: whole }: PieceCanvas, left: number, top: number, width = whole): void {
    const zoom = width / whole
    const drawn = pieces.map((piece) => ({
      ...piece,
      left: left + zoom * piece.left,
      top: top + zoom * piece.top,
      width: zoom * piece.width,
    }))
    const isBelow = (piece: Piece) => drawn.some((other) => other.left === piece.left && other.top === piece.top)
    const isInside = (piece: Piece) =>
      piece.left < this.width && piece.top < this.height && piece.left + piece.width > 0 && piece.top + piece.width > 0
    this.pieces = [...this.pieces.filter((piece) => !isBelow(piece)), ...drawn.filter(isInside)]
  }
  clearRect(left: number, top: number, width: number, height: number): void {
    this.pieces = this.pieces.filter(
      (piece) =>
        piece.left >= left + width ||
        piece.top >= top + height ||
        piece.left + piece.width <= left ||
        piece.top + piece.width <= top,
    )
  }
}

describe('the base picture', () => {
  const SIZE = { width: 300, height: 200 }
  beforeEach(() => vi.stubGlobal('OffscreenCanvas', PieceCanvas))
  afterEach(() => vi.unstubAllGlobals())

  const place = fc.integer({ min: -700, max: 700 })
  const isLate = fc.constantFrom(false, false, true)
  const length = { minLength: 5, maxLength: 25, size: 'max' } as const
  const action = fc.oneof(
    actionOf('look', { x: place, y: place, scale: fc.constantFrom(1, 1, 1, 1, 2, 0.25, 0.002) }),
    actionOf('again'),
    actionOf('paint', { isWhole: fc.constantFrom(true, true, false), isLate }),
    actionOf('edit', { x: place, y: place, isLate }),
  )

  it('shows pixels where they belong, none from before an edit, and is whole once its newest request is painted', () => {
    fc.assert(
      fc.property(fc.array(action, length), fc.constantFrom(1, 2), (script, ratio) => {
        const picture = new TileBuffer()
        let camera = { x: 0, y: 0, scale: 1 }
        let [edits, images, isWhole, isBegun] = [0, 0, false, false]
        /** Points of the plane that were seen sharply. */
        let known: readonly Point[] = []
        const requests: PaintRequest[] = []
        const note = (request: PaintRequest | undefined) => {
          if (request === undefined) return
          requests.push(request)
          isWhole = false
          isBegun = false
        }
        /** The tiles of a request that meet a box. */
        const tilesOf = ({ grid, wanted }: PaintRequest, count = Infinity) => {
          const patches = []
          for (let left = wanted.left; left < wanted.left + wanted.width; left += TILE) {
            for (let top = wanted.top; top < wanted.top + wanted.height && patches.length < count; top += TILE) {
              const box = { left, top, width: TILE, height: TILE }
              const image = Object.assign(new PieceCanvas(TILE, TILE), { close: () => images-- })
              image.pieces = [{ grid, box, edits, left: 0, top: 0, width: TILE }]
              images += 1
              patches.push({ box, image: image as unknown as ImageBitmap })
            }
          }
          return patches
        }
        for (const action of [{ kind: 'look', x: 0, y: 0, scale: 1 } as const, ...script]) {
          const formerGrid = requests.at(-1)?.grid
          // A thread that has begun with the newest request answers no edits for an older one.
          const request = requests.at('isLate' in action && action.isLate && !isBegun ? -2 : -1)
          if (action.kind === 'look') {
            camera = { x: action.x, y: action.y, scale: action.scale }
            note(picture.request(camera, SIZE, ratio))
            expect(picture.request(camera, SIZE, ratio)).toBeUndefined()
          } else if (request === undefined) continue
          else if (action.kind === 'again') note(picture.requestAll(camera, SIZE))
          else {
            const { grid, paintId } = request
            const isEdit = action.kind === 'edit'
            edits += Number(isEdit)
            isBegun ||= request === requests.at(-1)
            const patches = tilesOf(request, isEdit || action.isWhole ? Infinity : 2)
            if (isEdit) {
              const box = { minX: action.x, minY: action.y, maxX: action.x + 200, maxY: action.y + 300 }
              const edited: Partial<Painted> = { kind: 'edited', grid: grid.id, patches, boxes: [box] }
              picture.put(edited as Painted)
            } else {
              picture.put({ kind: 'painted', grid: grid.id, patches, paintId, isWhole: action.isWhole })
              isWhole ||= action.isWhole && request === requests.at(-1)
            }
          }
          const screen = new PieceCanvas(SIZE.width * ratio, SIZE.height * ratio)
          picture.draw(screen as unknown as CanvasRenderingContext2D, camera, SIZE, ratio)
          for (const { grid, box, left, top, width } of screen.pieces) {
            const corner = { x: grid.x + box.left / grid.scale, y: grid.y - box.top / grid.scale }
            const { x, y } = toScreen(camera, SIZE, corner)
            expect(Math.max(Math.abs(left - x * ratio), Math.abs(top - y * ratio))).toBeLessThan(0.51)
            expect(width).toBeCloseTo((TILE * camera.scale * ratio) / grid.scale, 6)
            // Browsers take minutes for extreme scales.
            expect(width).toBeLessThanOrEqual(TILE * MOST_ENLARGED)
          }
          if (action.kind === 'edit') {
            const middle = toScreen(camera, SIZE, { x: action.x + 100, y: action.y + 150 })
            expect(screen.pieces.filter((piece) => piece.edits < edits && holds(piece, middle, ratio))).toEqual([])
          }
          expect([picture.isWhole, images]).toEqual([isWhole, 0])
          const sharp = screen.pieces.filter(({ grid }) => grid.id === requests.at(-1)?.grid.id)
          const isSeen = (point: Point) => sharp.some((piece) => holds(piece, point, ratio))
          const points = [1, 150, 299].flatMap((x) => [1, 100, 199].map((y) => ({ x, y })))
          if (isWhole && picture.isSharp(camera, ratio)) expect(points.filter((point) => !isSeen(point))).toEqual([])
          // Pixels that are known stay while the picture is moved.
          const isMoved = action.kind === 'look' && formerGrid === requests.at(-1)?.grid
          const onScreen = ({ x, y }: Point) => x > 1 && x < SIZE.width - 1 && y > 1 && y < SIZE.height - 1
          const still = known.map((point) => toScreen(camera, SIZE, point)).filter(onScreen)
          if (isMoved) expect(still.filter((point) => !isSeen(point))).toEqual([])
          known = points.filter(isSeen).map((point) => toPlane(camera, SIZE, point))
        }
        picture.clear()
        expect(picture.isWhole).toBe(false)
      }),
    )
  })

  function holds({ left, top, width }: Piece, { x, y }: Point, ratio: number): boolean {
    return left <= x * ratio && left + width >= x * ratio && top <= y * ratio && top + width >= y * ratio
  }
})
