// SPDX-License-Identifier: GPL-3.0-or-later
// <circle-voronoi> that is scaled, turned and zoomed, in engines other than Chromium: the pointer is where its circle is.
import { test } from '@playwright/test'
import type { Point } from '../../web/lib/index.ts'
import { centerOfFirst, onPage, ownPlace, PLACES, whenPlaced, writePlaced } from '../pack/places.ts'
import { ROOT } from '../pack/project.mjs'
import { type Server, serve } from '../pack/static-server.ts'
import { until } from './engine.ts'
import { ENGINES } from './engines.ts'

let server: Server
test.beforeAll(async () => {
  server = await serve(ROOT, "default-src 'self' data: 'wasm-unsafe-eval' 'unsafe-inline'")
})
test.afterAll(() => server.close())

for (const [name, openEngine] of ENGINES) {
  test(`in ${name}: the mouse drags a circle wherever a page puts its figure`, async () => {
    test.setTimeout(120_000 * PLACES.length)
    const engine = await openEngine()
    try {
      for (const [place, around, zoom = 1] of PLACES) {
        const path = writePlaced(`build/placed-${name}`, around)
        await engine.open(`${server.address}${path}`)
        await engine.evaluate(whenPlaced)
        const points: Point[] = []
        for (const k of [0, 1, 2, 3, 4]) {
          const [x, y] = await engine.evaluate(onPage, ownPlace(0.5 + k, 0.5 + (3 * k) / 4), zoom)
          points.push({ x, y })
        }
        await engine.drag(points)
        const center = () => engine.evaluate(centerOfFirst)
        // WebKit's driver rounds to whole pixels, which are up to 1/6 of a unit.
        const isThere = ([x, y]: readonly number[]) => Math.abs(Number(x) - 4) < 0.2 && Math.abs(Number(y) - 3) < 0.2
        await until(`dragged where it is ${place}`, center, isThere)
      }
    } finally {
      await engine.close()
    }
  })
}
