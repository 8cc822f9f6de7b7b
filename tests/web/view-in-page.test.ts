// SPDX-License-Identifier: GPL-3.0-or-later
// A view with its thread, without pixels: what it tells, its layers and its pictures.
// @vitest-environment happy-dom

import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { toSVG } from '../../web/view/export.ts'
import { DEFAULT_LAYERS } from '../../web/view/layers.ts'
import { mount } from '../../web/view/mount.ts'
import type { Highlights } from '../../web/view/protocol.ts'
import { createStore } from '../../web/view/store.ts'
import type { View } from '../../web/view/view.ts'
import { initialView } from '../../web/view/view-state.ts'
import { held } from './element-page.ts'
import { draws } from './page-canvas.ts'
import { make, measure } from './page-document.ts'
import { quiet, soon, surround } from './whole-page.ts'

const CIRCLES = Float64Array.of(0, 0, 2, 10, 0, 1, 5, 8, 1.5)
const { media } = surround()

let view: View
let store = createStore(initialView())
let place: HTMLElement
beforeEach(async () => {
  document.body.innerHTML = ''
  vi.stubGlobal('matchMedia', () => media)
  place = document.body.appendChild(make('div'))
  measure(place, { clientWidth: 80, clientHeight: 60, offsetWidth: 80, offsetHeight: 60 })
  store = createStore(initialView())
  view = mount(place, store)
  view.setCamera({ x: 5, y: 4, scale: 4 })
  await view.scene.open(CIRCLES.slice())
  await quiet()
})
afterEach(async () => {
  held.release()
  view.dispose()
  vi.unstubAllGlobals()
  media.matches = false
  await quiet()
})

const canvases = () => [...place.querySelectorAll('canvas')]
const select = (selection: readonly number[]) => store.update((state) => ({ ...state, selection }))
/** The events of a name, as they come. */
function heard(name: Parameters<View['on']>[0]) {
  const told: unknown[] = []
  view.on(name, (event) => told.push(event))
  return told
}

it.each<[string, () => unknown, () => unknown]>([
  [
    'a band',
    () => Object.assign(view, { rectangle: { from: { x: 1, y: 1 }, to: { x: 9, y: 9 } } }),
    () => Object.assign(view, { rectangle: undefined }),
  ],
  [
    'a sketch',
    () => Object.assign(view, { sketch: Float64Array.of(0, 0, 9, 9) }),
    () => Object.assign(view, { sketch: undefined }),
  ],
  ['a name', () => view.setIdentities([{ id: 0, text: 'A' }], undefined), () => view.setIdentities([], undefined)],
  ['a highlight', () => select([1]), () => select([])],
])('%s is drawn above the picture with the next frame, and gone once it is taken away', async (_, show, hide) => {
  const overlay = canvases()[1] as HTMLCanvasElement
  draws.delete(overlay)
  show()
  await quiet()
  expect(draws.get(overlay)).toBeGreaterThan(0)
  hide()
  await quiet()
  draws.delete(overlay)
  view.setCamera({ x: 6, y: 4, scale: 4 })
  await quiet()
  expect(draws.get(overlay)).toBeUndefined()
})

describe('a view tells', () => {
  it('of the selected circle among new circles, also under the same id', async () => {
    const marked = heard('marked') as Highlights[]
    select([1])
    await quiet()
    expect(marked.at(-1)?.selected?.circle.x).toBe(10)
    await view.scene.open(Float64Array.of(0, 0, 2, 20, 0, 1, 5, 8, 1.5))
    select([])
    select([1])
    await soon(() => expect(marked.at(-1)?.selected?.circle.x).toBe(20))
  })
  it('of the newest circle that is tried, and once where there is none any more', async () => {
    const tried = heard('tried')
    const circle = { x: 4, y: 3, r: 1 }
    await Promise.all([view.tryCircle(circle), view.tryCircle({ ...circle, r: 0.5 })])
    expect(tried).toHaveLength(1)
    await Promise.all([view.tryCircle(circle), view.tryCircle(undefined), view.tryCircle(undefined)])
    expect([tried.length, tried.at(-1)]).toEqual([2, undefined])
  })

  it('of edits that were made, and of none that is refused', async () => {
    const changed = heard('changed')
    await expect(view.scene.edit([{ kind: 'remove', id: 9 }])).rejects.toMatchObject({ code: 'unknownCircle' })
    expect(changed).toHaveLength(0)
    const replaced = view.scene.edit([{ kind: 'remove', id: 0 }])
    const outcome = await Promise.allSettled([view.scene.open(CIRCLES.slice(0, 3)), replaced])
    expect(outcome.map(({ status }) => status)).toContain('fulfilled')
    expect(view.circles.count).toBe(1)
  })

  it('of its camera until listeners unsubscribe, and nobody after its end', () => {
    const told: string[] = []
    const stop = view.on('camera', () => told.push('first'))
    view.on('camera', () => told.push('second'))
    view.setCamera({ x: 1, y: 1, scale: 1 })
    stop()
    view.setCamera({ x: 2, y: 1, scale: 1 })
    expect(told).toEqual(['first', 'second', 'second'])
    view.dispose()
    view.setCamera({ x: 3, y: 1, scale: 1 })
    expect(told).toHaveLength(3)
  })

  it('of its style after changes of colors and style sheets, and of no other file', () => {
    const told = heard('style')
    for (let k = 0; k < 2; k++) media.dispatchEvent(new Event('change'))
    const before = told.length
    expect(before).toBeGreaterThan(1)
    for (const rel of ['icon', 'stylesheet']) {
      const link = document.head.appendChild(make('link', { rel }))
      told.length = 0
      link.dispatchEvent(new Event('load'))
      expect(told).toHaveLength(rel === 'icon' ? 0 : 1)
      link.remove()
    }
    view.dispose()
    media.dispatchEvent(new Event('change'))
    expect(told).toHaveLength(1)
  })

  it('its place whether it is dark, for print', () => {
    for (const [color, isDark] of [
      ['rgb(0, 0, 0)', true],
      ['rgb(255, 255, 255)', false],
    ] as const) {
      vi.stubGlobal('getComputedStyle', () => ({ color, getPropertyValue: () => '' }))
      view.restyle()
      expect('dark' in place.dataset).toBe(isDark)
    }
  })
})

describe('layers', () => {
  it('of circles alone draw no diagram, keep the others for later, and are told once', async () => {
    const told = heard('diagram')
    const pictures: string[] = []
    for (const hasDiagram of [true, false, false, true]) {
      view.hasDiagram = hasDiagram
      pictures.push(await toSVG(view))
    }
    expect([told, pictures[2], pictures[3]]).toEqual([[false, true], pictures[1], pictures[0]])
    expect(pictures[1]?.length).toBeLessThan((pictures[0] as string).length)
    view.setIdentities([], { values: Float64Array.of(0, 0, 0), colors: ['#010203'] })
    expect(await toSVG(view)).toContain('#010203')
  })

  it('that are refused change nothing', () => {
    const told = heard('layers')
    expect(() => view.setLayers({ hull: 1 as never })).toThrow(expect.objectContaining({ code: 'badInput' }))
    expect([view.layers, told]).toEqual([DEFAULT_LAYERS, []])
    view.setLayers({ hull: true })
    expect([view.layers.hull, told.length]).toEqual([true, 1])
  })
})

describe('a picture', () => {
  const widths = () => canvases().map(({ width }) => width)

  it('has no pixels while it is not shown', async () => {
    view.isShown = false
    view.setCamera({ x: 0, y: 0, scale: 3 })
    view.setLayers({ hull: true })
    await quiet()
    expect([widths(), view.isShown]).toEqual([[0, 0], false])
    view.isShown = true
    expect([widths(), view.isShown]).toEqual([[80, 80], true])
  })

  it('follows the resolution of the screen, again and again', async () => {
    for (const ratio of [2, 3]) {
      vi.stubGlobal('devicePixelRatio', ratio)
      media.dispatchEvent(new Event('change'))
      expect(widths()).toEqual([80 * ratio, 80 * ratio])
    }
  })

  it('is busy until its pixels are there, and sharp', async () => {
    expect(place.ariaBusy).toBe('false')
    held.hold()
    view.setCamera({ x: 5, y: 4, scale: 4.1 })
    await quiet()
    expect(place.ariaBusy).toBe('true')
    await held.isFull()
    held.release()
    await soon(() => expect(place.ariaBusy).toBe('false'))
  })
})
