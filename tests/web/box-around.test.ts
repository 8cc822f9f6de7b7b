// SPDX-License-Identifier: GPL-3.0-or-later
import { describe, expect, it } from 'vitest'
import { boxAround } from '../../web/app/box-around.ts'

describe('the box around circles', () => {
  it('leaves circles near the origin where they are, with room on both sides', () => {
    expect(boxAround({ minX: 1, minY: 0, maxX: 9, maxY: 5 }, 3)).toEqual({
      lattice: { a: [10, 0], b: [0, 5.4] },
      move: { x: 0, y: 0 },
    })
  })

  it('has other circles move into its middle', () => {
    const { lattice, move } = boxAround({ minX: -5, minY: 1000, maxX: 5, maxY: 1010 }, 3)
    expect(lattice).toEqual({ a: [11, 0], b: [0, 11] })
    expect(move).toEqual({ x: 5.5, y: -999.5 })
  })

  it('holds circles of any size, one circle, a point, and none', () => {
    for (const scale of [1e-150, 1e-7, 0.3, 1, 7777, 1e12, 1e140]) {
      for (const [minX, minY, maxX, maxY] of [
        [-1, -1, 1, 1],
        [0, 0, 3, 0.001],
        [0.9, -40, 3, 0],
      ] as const) {
        const box = { minX: scale * minX, minY: scale * minY, maxX: scale * maxX, maxY: scale * maxY }
        const { lattice, move } = boxAround(box, 5)
        expect(lattice.a[1]).toBe(0)
        expect(lattice.b[0]).toBe(0)
        expect(box.minX + move.x).toBeGreaterThanOrEqual(0)
        expect(box.minY + move.y).toBeGreaterThanOrEqual(0)
        expect(box.maxX + move.x).toBeLessThan(lattice.a[0])
        expect(box.maxY + move.y).toBeLessThan(lattice.b[1])
        expect(lattice.a[0]).toBeLessThan(1.6 * Math.max(box.maxX - box.minX, box.maxY - box.minY))
      }
    }
    expect(boxAround({ minX: 3, minY: -2, maxX: 3, maxY: -2 }, 1)).toEqual({
      lattice: { a: [1, 0], b: [0, 1] },
      move: { x: -2.5, y: 2.5 },
    })
    expect(boxAround({ minX: Infinity, minY: Infinity, maxX: -Infinity, maxY: -Infinity }, 0).lattice).toEqual({
      a: [10, 0],
      b: [0, 10],
    })
  })
})
