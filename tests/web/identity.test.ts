// SPDX-License-Identifier: GPL-3.0-or-later
// Names and colors of circles: edited, undone, linked, and drawn as labels and in the colors.
import fc from 'fast-check'
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { columnsOf, namedAs } from '../../web/editing/attributes.ts'
import { isColor, isIdentity, namesOf, ownColorsOf } from '../../web/editing/identity.ts'
import { axesOf, gridSpacing } from '../../web/view/axes.ts'
import { NO_PADDING } from '../../web/view/camera.ts'
import { CircleTable } from '../../web/view/circle-table.ts'
import { LABEL_SIZE, type Label, type Names, placed } from '../../web/view/labels.ts'
import { DEFAULT_LAYERS } from '../../web/view/layers.ts'
import { PaintedScene } from '../../web/view/painter/painted-scene.ts'
import { SvgDrawing } from '../../web/view/painter/svg-drawing.ts'
import { styleOf } from '../../web/view/style.ts'
import { fail, pageSession } from './editing-session.ts'
import { library, seededRandom } from './library.ts'

const THREE = Float64Array.of(0, 0, 1, 5, 0, 2, 0, 5, 1.5)
const FRAME = { x: 0, y: 0, scale: 20, width: 400, height: 300 }

beforeEach(() => vi.stubGlobal('requestAnimationFrame', (act: () => void) => queueMicrotask(act)))
afterEach(() => vi.unstubAllGlobals())

function edited() {
  const { editing, actions } = pageSession({ onproblem: fail })
  const names = () => namesOf(editing).map(({ id, text }) => `${id} ${text}`)
  return { editing, actions, names }
}

describe('a circle', () => {
  it('keeps the column of its file for its name', async () => {
    const { editing, actions, names } = edited()
    const attributes = columnsOf(
      { properties: ['{"Stadt":"A","ID":7}', '{"Stadt":"","ID":8}', '{}'], ids: [], heights: [], collection: '' },
      3,
    )
    await editing.open({ circles: THREE, dataSet: '', isEdited: false, attributes })
    expect(names()).toEqual(['1 8', '0 A'])
    await actions.identity.setName(2, 'C')
    expect(names()).toEqual(['1 8', '2 C', '0 A'])
    expect(editing.attributes.columns.map(({ name }) => name)).toEqual(['Stadt', 'ID'])
  })

  it('has its name and its color without white space, and circles of the same size are in their order', async () => {
    const { editing, names } = edited()
    const column = (name: string, ...texts: string[]) => ({ name, values: texts.map((text) => JSON.stringify(text)) })
    const columns = [
      column('Name', ' A ', ' '),
      column(' Id ', '7', ' 8 ', '9'),
      column('colour', ' #abcdef ', '', '#12'),
    ]
    const circles = Float64Array.of(0, 0, 1, 5, 0, 1, 0, 5, 1)
    await editing.open({ circles, dataSet: '', isEdited: false, attributes: { ...namedAs([]), columns } })
    expect(names()).toEqual(['0 A', '1 8', '2 9'])
    expect(ownColorsOf(editing)).toEqual({ values: Float64Array.of(0, Number.NaN, Number.NaN), colors: ['#abcdef'] })
    expect(columns.map((column) => isIdentity(column, columns))).toEqual([true, false, true])
  })

  it('of a data set has its name in a link without writing all circles', async () => {
    const { editing, actions } = edited()
    await editing.open({ circles: THREE, dataSet: 'three', isEdited: false, attributes: namedAs(['A', '', 'C']) })
    expect(actions.opening.linkState()).toMatchObject({ dataSet: 'three' })
    await editing.edit([{ kind: 'insert', circle: { x: 9, y: 9, r: 1 } }])
    expect(actions.opening.linkState()).toMatchObject({ dataSet: 'three', edits: [{ kind: 'insert' }] })
  })

  it('has a color only if it is one', () => {
    expect(['#abc', '#AABBCC80', 'red', '#ab', 'url(#x)', '"><script>', ''].map(isColor)).toEqual([
      true,
      true,
      false,
      false,
      false,
      false,
      false,
    ])
    vi.stubGlobal('CSS', { supports: (_: string, text: string) => ['red', 'inherit', 'var(--x)'].includes(text) })
    expect(['red', 'inherit', 'var(--x)', 'rot'].map(isColor)).toEqual([true, false, false, false])
  })

  it('is drawn in its own color, unless colors show a quantity that somebody chose', () => {
    const style = styleOf(new Proxy({}, { get: (_, name) => `${String(name)}-color` }))
    const scene = new PaintedScene(library)
    scene.open(THREE.slice())
    const ownColors = { values: Float64Array.of(Number.NaN, 0, Number.NaN), colors: ['#abcdef'] }
    const drawn = (layers: object) => {
      scene.setLayers({ ...DEFAULT_LAYERS, ...layers, ownColors })
      const drawing = new SvgDrawing()
      scene.draw(drawing, FRAME, 1, style)
      return String(drawing).match(/#abcdef/g)?.length ?? 0
    }
    // The disc and the tint of the cell.
    expect([{}, { cells: 'different' }].map(drawn)).toEqual([2, 2])
    expect(drawn({ cells: 'none' })).toBe(1)
    expect(drawn({ cells: 'area' })).toBe(0)
    expect(drawn({ column: { name: 'n', values: Float64Array.of(1, 2, 3) } })).toBe(0)
  })
})

describe('labels', () => {
  const random = seededRandom(45)
  const COUNT = 600
  const circles = Float64Array.from({ length: 3 * COUNT }, (_, k) =>
    k % 3 === 0 ? 40 * random() - 20 : k % 3 === 1 ? 30 * random() - 15 : random() ** 4 * 3,
  )
  const table = new CircleTable(circles)
  const list = Array.from({ length: COUNT }, (_, id) => ({
    id,
    text: id % 3 === 0 ? `漢字${id}` : `${'n'.repeat(1 + (id % 12))}${id}`,
  })).sort((one, other) => (table.get(other.id)?.r as number) - (table.get(one.id)?.r as number))
  const names: Names = { list, circles: table, domain: {} }
  const half = (text: string) => (LABEL_SIZE * [...text].reduce((sum, c) => sum + (/[漢字]/.test(c) ? 1 : 0.6), 0)) / 2
  const named = (one: object, frame = FRAME, ...rest: number[]) =>
    placed({ list: [{ id: 0, text: 'abc' }], circles: table, domain: {}, ...one }, frame, ...rest)

  it('overlap nowhere, and the largest circles have theirs', () => {
    const labels = placed(names, { ...FRAME, width: 800, height: 600 })
    expect(labels.length).toBeGreaterThan(20)
    labels.forEach((one, k) => {
      for (const other of labels.slice(0, k)) {
        const isApart =
          Math.abs(one.y - other.y) >= LABEL_SIZE || Math.abs(one.x - other.x) >= half(one.text) + half(other.text)
        expect(isApart, `${one.text} and ${other.text}`).toBe(true)
      }
    })
    const radii = labels.map(({ text }) => table.get(list.find((name) => name.text === text)?.id ?? -1)?.r as number)
    expect(radii).toEqual([...radii].sort((one, other) => other - one))
    expect(radii[0]).toBeGreaterThan(2)
  })

  it('are in their cells, at any scale', () => {
    const diagram = library.compute(circles)
    for (const scale of [10, 20, 60]) {
      const frame = { ...FRAME, scale }
      for (const { text, x, y } of placed(names, frame)) {
        const id = list.find((name) => name.text === text)?.id
        for (const [dx, dy] of [-1, 0, 1].flatMap((i) => [-1, 0, 1].map((j) => [i, j] as const))) {
          const at = [x + dx * half(text), y + (dy * LABEL_SIZE) / 2] as const
          expect(diagram.find((at[0] - 200) / scale, (150 - at[1]) / scale), text).toBe(id)
        }
      }
    }
  })

  it('are in cells that have changed, and in cells that repeat', () => {
    const two = () => new CircleTable(Float64Array.of(0, 0, 0, 0, -8, 0))
    const isThere = (circles: CircleTable, domain: Names['domain'] = {}) => named({ circles, domain }).length > 0
    const near = two()
    expect(isThere(near)).toBe(true)
    const around = [
      [0, -1],
      [0, 1],
      [1, 0],
      [-1, 0],
    ].flat()
    const inserted = Int32Array.of(2, 3, 4, 5)
    const added = Float64Array.from({ length: 12 }, (_, k) =>
      k % 3 === 2 ? 0 : (around[2 * Math.floor(k / 3) + (k % 3)] as number),
    )
    near.follow({ inserted, removed: new Int32Array(), replaced: new Int32Array(), circles: added })
    expect(isThere(near)).toBe(false)
    near.follow({
      inserted: new Int32Array(),
      removed: inserted,
      replaced: new Int32Array(),
      circles: new Float64Array(),
    })
    expect(isThere(near)).toBe(true)
    expect(isThere(two(), { lattice: { a: [20, 0], b: [0, 20] } })).toBe(true)
    expect(isThere(two(), { lattice: { a: [1, 0], b: [0, 20] } })).toBe(false)
  })

  it('end where cells end, and where the picture is painted', () => {
    const circles = new CircleTable(Float64Array.of(0, 0, 0.1))
    expect(named({ circles }, FRAME, 3)).toHaveLength(1)
    expect(named({ circles }, FRAME, 0.5)).toEqual([])
    const at = { minX: -3, minY: -3, maxX: 3, maxY: 3 }
    expect(named({ circles, within: at })).toHaveLength(1)
    // Below, there is no picture yet.
    expect(named({ circles, within: { ...at, minY: -0.2 } })[0]?.y).toBeLessThan(150)
    expect(named({ circles, within: { ...at, minX: 1 } })).toEqual([])
  })

  it('are whole, or the beginnings of names with more than 32 letters, whatever letters these are', () => {
    const circles = new CircleTable(Float64Array.of(0, 0, 9))
    fc.assert(
      fc.property(fc.string({ unit: 'binary', maxLength: 80, size: 'max' }), (text) => {
        const drawn = named({ list: [{ id: 0, text }], circles }, { ...FRAME, width: 4000, scale: 200 })[0]?.text ?? ''
        expect([...drawn].length).toBe(Math.min([...text].length, 32))
        expect([drawn, `${text.slice(0, drawn.length - 1)}…`]).toContain([...text].length > 32 ? drawn : text)
        // Half of a letter of two code units is a surrogate.
        expect(drawn).not.toMatch(/\p{Cs}/u)
      }),
    )
  })

  it('cross no border of the frame, and are on another side of a circle at the border', () => {
    let inside = 0
    for (let k = 0; k < 40; k++) {
      const frame = { ...FRAME, x: random() * 20 - 10, y: random() * 16 - 8, scale: 10 + k }
      for (const { text, x, y } of placed(names, frame)) {
        const sides = [
          [x - half(text), x + half(text), frame.width],
          [y - LABEL_SIZE / 2, y + LABEL_SIZE / 2, frame.height],
        ] as const
        const isOutside = sides.some(([from, to, length]) => to <= 0 || from >= length)
        const isInside = sides.every(([from, to, length]) => from >= 0 && to <= length)
        expect(isInside || isOutside, `${text} at ${x}, ${y}`).toBe(true)
        if (isInside) inside += 1
      }
    }
    expect(inside).toBeGreaterThan(100)
    const at = (x: number, y: number) => named({ circles: new CircleTable(Float64Array.of(x, y, 0)) })[0]
    expect(at(0, 0)?.y).toBeGreaterThan(150)
    expect(at(0, -7)?.y).toBeLessThan(290)
    expect(at(-9.9, 0)?.x).toBeGreaterThan(2)
  })

  it('are never hundreds, and fewer in a small frame', () => {
    const side = 100
    const grid = Float64Array.from({ length: 3 * side * side }, (_, k) => {
      const i = Math.floor(k / 3)
      return [5 * (i % side), 5 * Math.floor(i / side), 1.6][k % 3] as number
    })
    const list = Array.from({ length: side * side }, (_, id) => ({ id, text: String(id) }))
    const countIn = (width: number, height: number) =>
      placed({ list, circles: new CircleTable(grid), domain: {} }, { x: 250, y: 250, scale: 10, width, height }).filter(
        ({ x, y }) => x > 0 && y > 0 && x < width && y < height,
      ).length
    expect(countIn(2000, 1500)).toBe(100)
    expect(countIn(360, 300)).toBe(22)
  })

  it('stay where they are while the frame moves', () => {
    const inside = ({ x, y }: { x: number; y: number }) => x > 60 && x < 340 && y > 60 && y < 240
    const [before, after] = [placed(names, FRAME), placed(names, { ...FRAME, x: 1 })]
    const moved = after.map(({ text, x, y }) => ({ text, x: Math.round(x + 20), y: Math.round(y) })).filter(inside)
    const known = before.map(({ text, x, y }) => ({ text, x: Math.round(x), y: Math.round(y) })).filter(inside)
    expect(moved).toEqual(known)
  })

  it('are on large discs, and beside points, also if radii are weights', () => {
    const at = (r: number, domain = {}) => named({ circles: new CircleTable(Float64Array.of(0, 0, r)), domain })
    expect(at(2)).toEqual([{ text: 'abc', x: 200, y: 150 }])
    expect(at(0)[0]?.y).toBeGreaterThan(150)
    expect(at(2, { areSites: true })).toEqual(at(0))
    expect(named({ circles: new CircleTable(new Float64Array()) })).toEqual([])
  })
})

describe('axes and grid', () => {
  it('have lines at round coordinates, on which circles snap, with numbers at some', () => {
    const { vertical, horizontal, numbers } = axesOf(FRAME, NO_PADDING)
    expect(gridSpacing(FRAME.scale)).toBe(1)
    expect([vertical.axis, horizontal.axis]).toEqual([[200], [150]])
    expect(vertical.numbered).toEqual([0, 100, 300, 400])
    expect(vertical.fine).toHaveLength(16)
    expect(numbers.map(({ text }) => text)).toEqual(['−10', '−5', '5', '10', '−5', '0', '5'])
    // The numbers stand beside the axes: those of x below, those of y to the left, and the origin in the corner.
    const origin = numbers[5] as Label
    expect(origin.x).toBeLessThan(200)
    expect(origin.y).toBe(numbers[0]?.y)
    expect(numbers.slice(4).map(({ y }) => Math.sign(y - 150))).toEqual([1, 1, -1])
  })

  it('have numbers at the border if the axes are elsewhere, off what covers it', () => {
    const covered = { top: 40, right: 10, bottom: 20, left: 70 }
    const { vertical, horizontal, numbers } = axesOf({ ...FRAME, x: 1000, y: 1e6 }, covered)
    expect([vertical.axis, horizontal.axis]).toEqual([[], []])
    for (const { x, y, text } of numbers) {
      expect(x > 70 || /^9|^10/.test(text)).toBe(true)
      expect(y).toBeLessThan(300)
    }
    expect(numbers.filter(({ text }) => text.length === 7).every(({ x }) => x > 70)).toBe(true)
    // Numbers of the vertical lines are at the lower border or the upper one, whichever is nearer to the axis.
    const rows = [1e6, -1e6].map((y) => axesOf({ ...FRAME, x: 1000, y }, covered).numbers.map(({ y }) => y))
    expect(rows.map((ys) => ys.filter((y) => y === ys[0]).length > 3)).toEqual([true, true])
    const aside = (rows[1]?.[0] as number) - covered.top
    expect(aside).toBeGreaterThan(0)
    expect(rows[0]?.[0]).toBe(FRAME.height - covered.bottom - aside)
  })

  it.each([1e-15, 1e-6, 1, 1e9, 1e25])('end at scale %d, also far from the origin', (scale) => {
    for (const x of [0, 1e15, 1e28]) {
      const { vertical, numbers } = axesOf({ ...FRAME, x, scale }, NO_PADDING)
      expect(vertical.fine.length).toBeLessThan(60)
      expect(numbers.every((number) => Number.isFinite(number.x))).toBe(true)
    }
  })
})
