// SPDX-License-Identifier: GPL-3.0-or-later
// <circle-voronoi> in engines other than Chromium: the plain page, the one file, and the player.
import { expect, test } from '@playwright/test'
import { boundingBox, fitted, toScreen } from '../../web/view/camera.ts'
import { ROOT } from '../pack/project.mjs'
import { type Server, STRICT_POLICY, serve } from '../pack/static-server.ts'
import { type Engine, until } from './engine.ts'
import { ENGINES } from './engines.ts'

type Element = HTMLElementTagNameMap['circle-voronoi']

let server: Server
test.beforeAll(async () => {
  // The one file starts its thread from a text.
  server = await serve(ROOT, `${STRICT_POLICY}; worker-src 'self' blob:`)
})
test.afterAll(() => server.close())

/** Waits until the first figure of a page shows its circles, and returns their values and positions. */
function shown(engine: Engine) {
  return engine.evaluate(async () => {
    await customElements.whenDefined('circle-voronoi')
    const element = document.querySelector('circle-voronoi') as Element
    await element.ready
    await element.updateComplete
    const root = element.shadowRoot as ShadowRoot
    const { left, top, width, height } = (root.querySelector('.figure') as HTMLElement).getBoundingClientRect()
    const buttons = (root.querySelector('.controls') as HTMLElement).clientHeight
    return { circles: [...element.circles], box: { left, top, width, height }, buttons }
  })
}

const circlesOf = (engine: Engine) =>
  engine.evaluate(() => [...(document.querySelector('circle-voronoi') as Element).circles])

/** Drags the third circle, and reverts the drag by a key. */
async function expectToBeLive(engine: Engine): Promise<void> {
  const { circles, box, buttons } = await shown(engine)
  const room = { top: buttons === 0 ? 16 : buttons + 12, right: 16, bottom: 16, left: 16 }
  const camera = fitted(boundingBox(Float64Array.from(circles)), box, room)
  const { x, y } = toScreen(camera, box, { x: circles[6] as number, y: circles[7] as number })
  const at = { x: box.left + x, y: box.top + y }
  await engine.drag([at, { x: at.x - 20, y: at.y + 15 }, { x: at.x - 40, y: at.y + 30 }])
  await until(
    'dragged',
    () => circlesOf(engine),
    (now) => (now[6] as number) < (circles[6] as number),
  )
  await engine.press('Control+z')
  await until(
    'undone',
    () => circlesOf(engine),
    (now) => String(now) === String(circles),
  )
}

for (const [name, openEngine] of ENGINES) {
  test(`in ${name}: a figure is dragged, also that of the one file, and the method is played`, async () => {
    const engine = await openEngine()
    try {
      for (const page of ['plain', 'bundle']) {
        await engine.open(`${server.address}examples/element/${page}/index.html`)
        await expectToBeLive(engine)
      }
      await engine.open(`${server.address}examples/element/player/index.html`)
      await shown(engine)
      const sentence = () =>
        engine.evaluate(() => {
          const element = document.querySelector('circle-voronoi') as Element
          return element.shadowRoot?.querySelector('.sentence')?.textContent ?? ''
        })
      expect(await sentence()).toBe('There are 7 circles.')
      await engine.evaluate(() => {
        const element = document.querySelector('circle-voronoi') as Element
        element.shadowRoot?.querySelector<HTMLElement>('input[type=range]')?.focus()
      })
      await engine.press('ArrowRight')
      await until('at step 1', sentence, (text) => text.startsWith('The Delaunay graph of the centers has'))
      const played = await engine.evaluate(async () => {
        const element = document.querySelector('circle-voronoi') as Element
        await element.stepTo(3)
        const samples = await element.toSVG()
        await element.stepTo(1e6)
        return { hasSamples: samples !== (await element.toSVG()), step: element.getState().step }
      })
      expect(played).toEqual({ hasSamples: true, step: 82 })
      expect(await sentence()).toContain('The judge proves the diagram.')
      await engine.evaluate(async () => {
        const element = document.querySelector('circle-voronoi') as Element
        await element.stepTo(20)
        await element.play()
      })
      await until(
        'playing',
        () => engine.evaluate(() => (document.querySelector('circle-voronoi') as Element).step),
        (step) => (step ?? 0) > 20,
      )
    } finally {
      await engine.close()
    }
  })
}
