// SPDX-License-Identifier: GPL-3.0-or-later
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { CircleTable } from '../../web/app/circle-table.ts'
import type { Edit } from '../../web/lib/index.ts'
import { boundingBox } from '../../web/view/camera.ts'

const NONE = new Int32Array()
const value = fc.double({ min: -100, max: 100, noNaN: true })
const arbitraryCircle = fc.record({ x: value, y: value, r: fc.double({ min: 0, max: 9, noNaN: true }) })

describe('CircleTable', () => {
  it('gives a copy of its circles', () => {
    const table = new CircleTable(Float64Array.of(0, 0, 1, 5, 5, 2))
    table.circles().fill(7)
    expect(table.circles()).toEqual(Float64Array.of(0, 0, 1, 5, 5, 2))
  })

  it('has room for circles that come, and gaps where some have gone', () => {
    const table = new CircleTable(Float64Array.of(0, 0, 1, 5, 5, 2))
    table.apply([{ kind: 'insert', circle: { x: 9, y: 9, r: 9 } }], Int32Array.of(2))
    expect(table.circles()).toEqual(Float64Array.of(0, 0, 1, 5, 5, 2, 9, 9, 9))
    table.apply([{ kind: 'remove', id: 1 }], NONE)
    expect(table.circles()).toEqual(Float64Array.of(0, 0, 1, 9, 9, 9))
    expect([table.get(1), table.get(2)]).toEqual([undefined, { x: 9, y: 9, r: 9 }])
    expect([table.next(1, 1), table.next(1, -1), table.next(3, 1)]).toEqual([2, 0, undefined])
  })

  it('has the box of its circles after any edits', () => {
    const edit = fc.oneof(
      arbitraryCircle.map((circle) => ({ kind: 'insert', circle }) as const),
      fc.record({ k: fc.nat(), circle: arbitraryCircle }),
      fc.record({ k: fc.nat() }),
    )
    fc.assert(
      fc.property(fc.array(edit, { maxLength: 20 }), (edits) => {
        const table = new CircleTable(Float64Array.of(0, 0, 1, 5, 5, 2))
        let [count, ids] = [2, [0, 1]]
        for (const step of edits) {
          const id = 'k' in step ? ids[step.k % ids.length] : count
          if (id === undefined) continue
          if ('kind' in step) ids = [...ids, count++]
          else if (!('circle' in step)) ids = ids.filter((other) => other !== id)
          const edit: Edit =
            'kind' in step ? step : 'circle' in step ? { kind: 'replace', id, ...step } : { kind: 'remove', id }
          table.apply([edit], Int32Array.of(id))
          expect(table.box()).toEqual(boundingBox(table.circles()))
          expect(table.circles()).toHaveLength(3 * ids.length)
        }
      }),
    )
  })

  it('has a core that outliers do not widen', () => {
    const circles = Float64Array.from({ length: 3 * 100 }, (_, k) => (k % 3 === 2 ? 1 : Math.floor(k / 3)))
    circles.set([1e12, -1e12, 1e11], 30)
    const { minX, minY, maxX, maxY } = new CircleTable(circles).core()
    expect([minX, minY].every((value) => value >= 0 && value < 10)).toBe(true)
    expect([maxX, maxY].every((value) => value > 90 && value < 100)).toBe(true)
  })

  it('has a core where all centres are one, and where there are none', () => {
    expect(new CircleTable(new Float64Array()).core()).toEqual({ minX: -1, minY: -1, maxX: 1, maxY: 1 })
    expect(new CircleTable(Float64Array.of(2, 2, 1, 2, 2, 3)).core()).toEqual({ minX: -1, minY: -1, maxX: 5, maxY: 5 })
  })
})
