// SPDX-License-Identifier: GPL-3.0-or-later
import { describe, expect, it } from 'vitest'
import { idOf } from '../../web/view/painter/cell-boxes.ts'
import { cellArea } from '../../web/view/painter/measures.ts'
import { Picture } from '../../web/view/painter/picture.ts'
import { trialOf } from '../../web/view/painter/trial.ts'
import { dataSet, library, seededRandom } from './library.ts'

const noOutline = () => new Float64Array()

describe('what a circle would take', () => {
  it('is what it takes once it is there, and nothing changes before', () => {
    const seed = Number(process.env.CIRCLE_VORONOI_SEED ?? 5)
    const random = seededRandom(seed)
    const sets = [
      dataSet('waka'),
      dataSet('introduction'),
      Float64Array.from({ length: 600 }, (_, k) => (k % 3 === 2 ? 1.5 * random() ** 4 : 20 * random())),
      Float64Array.from({ length: 300 }, (_, k) => [k, 0, 0.3][k % 3] as number),
      Float64Array.of(0, 0, 1),
    ]
    for (const [set, circles] of sets.entries()) {
      const editor = library.edit(circles)
      const picture = new Picture(editor)
      const { diagram } = picture
      const extent = Math.max(...circles.map(Math.abs))
      for (let k = 0; k < 16; k++) {
        const size = [0, 0.01, 0.1, 0.6][k % 4] as number
        const circle = {
          x: (1.4 * random() - 0.2) * extent,
          y: (1.4 * random() - 0.2) * extent,
          r: size * random() * extent,
        }
        const context = `seed ${seed}, set ${set}, circle ${k}: ${JSON.stringify(circle)}`
        const before = editor.snapshot()
        const nearest = diagram.indexOf(editor.nearest(circle.x, circle.y))
        const trial = trialOf(library, picture, circle, nearest, noOutline)
        expect(editor.snapshot(), context).toEqual(before)

        const after = library.compute(Float64Array.of(...diagram.circles, circle.x, circle.y, circle.r))
        const own = diagram.circles.length / 3
        expect(trial.hiddenBy === undefined, context).toBe(after.cells.exists(own))
        if (trial.hiddenBy !== undefined) continue
        const area = cellArea(after, own)
        if (Number.isFinite(area)) expect(Math.abs(trial.area - area), context).toBeLessThan(1e-9 * area)
        else expect(trial.area, context).toBe(area)
        const hidden = (i: number) => diagram.cells.exists(i) && !after.cells.exists(i)
        const robbed = new Set<number>(after.neighbors(own))
        for (let i = 0; i < own; i++) if (hidden(i)) robbed.add(i)
        expect(
          trial.taken.map(({ id }) => id).sort((a, b) => a - b),
          context,
        ).toEqual([...robbed].map((i) => idOf(diagram, i)).sort((a, b) => a - b))
        for (const { id, x, y, area } of trial.taken) {
          const i = diagram.indexOf(id)
          expect([x, y]).toEqual([...diagram.circles.subarray(3 * i, 3 * i + 2)])
          const [was, is] = [cellArea(diagram, i), cellArea(after, i)]
          if (was < Number.POSITIVE_INFINITY) expect(Math.abs(area - (was - is)), context).toBeLessThan(1e-9 * was)
          else if (is < Number.POSITIVE_INFINITY) expect(area, context).toBe(Number.POSITIVE_INFINITY)
        }
        // The whole cell is taken from other circles.
        if (Number.isFinite(trial.area)) {
          const sum = trial.taken.reduce((sum, { area }) => sum + area, 0)
          const scale = trial.taken.reduce((most, { id }) => {
            const was = cellArea(diagram, diagram.indexOf(id))
            return Number.isFinite(was) ? Math.max(most, was) : most
          }, trial.area)
          expect(Math.abs(sum - trial.area), context).toBeLessThan(1e-7 * scale)
        }
      }
    }
  })

  it('is all of the plane where there is no other circle', () => {
    const picture = new Picture(library.edit([]))
    const trial = trialOf(library, picture, { x: 1, y: 2, r: 1 }, -1, noOutline)
    expect(trial).toMatchObject({ hiddenBy: undefined, area: Number.POSITIVE_INFINITY, taken: [] })
  })
})
