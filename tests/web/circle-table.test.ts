// SPDX-License-Identifier: GPL-3.0-or-later
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import type { Circle, Edit } from '../../web/lib/index.ts'
import { boundingBox } from '../../web/view/camera.ts'
import { type CircleChange, CircleTable, NO_CHANGE } from '../../web/view/circle-table.ts'

/** The change that an edit causes. `id` is the id of an inserted circle. */
function changeOf(edit: Edit, id: number): CircleChange {
  const ids = Int32Array.of(id)
  if (edit.kind === 'remove') return { ...NO_CHANGE, removed: ids }
  const { x, y, r } = edit.circle as Circle
  const circles = Float64Array.of(x, y, r)
  return { ...NO_CHANGE, ...(edit.kind === 'insert' ? { inserted: ids } : { replaced: ids }), circles }
}

/** Numbers with ties, and without. */
const value = fc.oneof(fc.integer({ min: -6, max: 6 }), fc.double({ min: -100, max: 100, noNaN: true }))
const arbitraryCircle = fc.record({
  x: value,
  y: value,
  r: fc.oneof(fc.nat(3), fc.double({ min: 0, max: 9, noNaN: true })),
})

describe('CircleTable', () => {
  it('knows its circles after any edits', () => {
    const step = fc.oneof(
      arbitraryCircle.map((circle) => ({ kind: 'insert', circle }) as const),
      fc.record({ kind: fc.constant('replace' as const), k: fc.nat(), circle: arbitraryCircle }),
      fc.record({ kind: fc.constant('remove' as const), k: fc.nat() }),
    )
    const bounds = fc.tuple(value, value, value, value)
    fc.assert(
      fc.property(fc.array(step, { maxLength: 20 }), bounds, arbitraryCircle, (steps, [x0, y0, x1, y1], place) => {
        const table = new CircleTable(Float64Array.of(0, 0, 1, 5, 5, 2))
        const model = new Map<number, Circle>([
          [0, { x: 0, y: 0, r: 1 }],
          [1, { x: 5, y: 5, r: 2 }],
        ])
        let count = 2
        for (const step of steps) {
          const ids = [...model.keys()]
          const id = step.kind === 'insert' ? count++ : ids[step.k % ids.length]
          if (id === undefined) continue
          table.follow(changeOf(step.kind === 'insert' ? step : ({ ...step, id } as Edit), id))
          if (step.kind === 'remove') model.delete(id)
          else model.set(id, step.circle)
        }
        // The circles are a copy.
        table.circles().fill(7)
        const all = [...model].sort(([a], [b]) => a - b)
        expect([...table.ids()]).toEqual(all.map(([id]) => id))
        expect([...table.circles()]).toEqual(all.flatMap(([, { x, y, r }]) => [x, y, r]))
        expect(table.box()).toEqual(boundingBox(table.circles()))
        for (let id = -2; id < count + 2; id++) {
          expect(table.get(id)).toEqual(model.get(id))
          expect(table.next(id, 1)).toBe(id < 0 ? undefined : all.find(([other]) => other >= id)?.[0])
          const before = all.findLast(([other]) => other <= id)?.[0]
          expect(table.next(id, -1)).toBe(id >= count ? undefined : before)
        }
        const box = { minX: Math.min(x0, x1), minY: Math.min(y0, y1), maxX: Math.max(x0, x1), maxY: Math.max(y0, y1) }
        const isIn = ({ x, y }: Circle) => x >= box.minX && x <= box.maxX && y >= box.minY && y <= box.maxY
        expect(table.within(box)).toEqual(all.filter(([, circle]) => isIn(circle)).map(([id]) => id))
        const near = all.some(([, { x, y, r }]) => Math.hypot(x - place.x, y - place.y) <= r + place.r)
        const hit = table.hitAt(place, place.r)
        expect(hit !== undefined && hit.part !== 'cell').toBe(near)
      }),
    )
  })

  it('knows its box and its core anew after each edit', () => {
    const square = (min: number, max: number) => ({ minX: min, minY: min, maxX: max, maxY: max })
    const table = new CircleTable(
      Float64Array.from({ length: 3 * 21 }, (_, k) => (k % 3 === 2 ? 1 : Math.floor(k / 3))),
    )
    expect([table.box(), table.core()]).toEqual([square(-1, 21), square(1, 19)])
    table.follow(changeOf({ kind: 'insert', circle: { x: 90, y: 90, r: 2 } }, 21))
    expect([table.box(), table.core()]).toEqual([square(-1, 92), square(2, 19)])
    table.follow(changeOf({ kind: 'remove', id: 0 }, 0))
    expect([table.box(), table.core()]).toEqual([square(0, 92), square(2, 20)])
    table.follow(changeOf({ kind: 'replace', id: 21, circle: { x: 0, y: 0, r: 5 } }, 21))
    expect([table.box(), table.core()]).toEqual([square(-5, 21), square(1, 19)])
  })

  it('has a core that outliers do not widen', () => {
    const circles = Float64Array.from({ length: 3 * 100 }, (_, k) => (k % 3 === 2 ? 1 : Math.floor(k / 3)))
    circles.set([1e12, -1e12, 1e11], 30)
    expect(new CircleTable(circles).core()).toEqual({ minX: 5, minY: 4, maxX: 95, maxY: 94 })
  })

  it('has a core where all centers are one, and where there are none', () => {
    expect(new CircleTable(new Float64Array()).core()).toEqual({ minX: -1, minY: -1, maxX: 1, maxY: 1 })
    expect(new CircleTable(Float64Array.of(2, 2, 1, 2, 2, 3)).core()).toEqual({ minX: -1, minY: -1, maxX: 5, maxY: 5 })
  })
})
