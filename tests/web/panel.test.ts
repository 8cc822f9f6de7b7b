// SPDX-License-Identifier: GPL-3.0-or-later
// The frame of panels: opening, closing, reloads, and the sheet of phones.
// @vitest-environment happy-dom
import { html } from 'lit/html.js'
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { NOT_LOADED } from '../../web/app/not-loaded.ts'
import { buttonOf, control, element, openPage, send } from './page-document.ts'
import { settled } from './turns.ts'

const STORED = 'circle-voronoi:open-panel'
let panels: typeof import('../../web/app/panels/panel.ts')
beforeEach(async () => {
  const panelHtml = (id: string) => `<section id="${id}" hidden></section><button aria-controls="${id}"></button>`
  openPage(`${panelHtml('a')}${panelHtml('b')}`)
  // The open panel is a variable of the module.
  vi.resetModules()
  panels = await import('../../web/app/panels/panel.ts')
})
afterEach(() => vi.unstubAllGlobals())

function firstPanel() {
  const place = element('a')
  const panel = panels.panelOf(place, 'Title', () => panel.render(() => html`<p></p>`), { onopen() {}, isKept: true })
  return { panel, place }
}

it('a panel opens without storage', () => {
  const forbidden = () => {
    throw new Error('forbidden')
  }
  vi.stubGlobal('localStorage', { getItem: forbidden, setItem: forbidden })
  const { panel } = firstPanel()
  buttonOf('a').click()
  expect(panel.isOpen).toBe(true)
})

describe('the handle of a sheet', () => {
  function pulled() {
    const { panel, place } = firstPanel()
    panel.open()
    const captured: number[] = []
    const handle = Object.assign(control(place, 'Larger or smaller'), {
      setPointerCapture: (id: number) => captured.push(id),
    })
    const move = (type: string, clientY = 0) => send(handle, type, { clientY, pointerId: 7 })
    const isLarge = () => document.body.classList.contains('large-sheet')
    return { panel, handle, move, isLarge, captured }
  }

  it('enlarges it when pulled up, reduces it when pulled down, and closes it when pulled down again', () => {
    const { panel, move, isLarge, captured } = pulled()
    const pull = (to: number) => {
      move('pointerdown', 100)
      move('pointermove', 100 + to)
      move('pointerup')
      move('click')
      return [isLarge(), panel.isOpen]
    }
    // The click after a pull is ignored.
    expect(pull(-24)).toEqual([true, true])
    expect(captured).toEqual([7])
    expect(pull(24)).toEqual([false, true])
    expect(pull(24)).toEqual([false, false])
  })

  it('toggles its size when clicked, also after a short pull', () => {
    const { move, isLarge } = pulled()
    const sizes = [0, 23].map((to) => {
      move('pointerdown', 100)
      move('pointermove', 100 + to)
      move('pointerup')
      move('click')
      return isLarge()
    })
    expect(sizes).toEqual([true, false])
  })

  it.each(['pointerup', 'pointercancel'])('is followed once, and until %s', (end) => {
    const { panel, move, isLarge } = pulled()
    move('pointerdown', 100)
    move(end)
    move('pointermove', 0)
    expect(isLarge()).toBe(false)
    move('pointerdown', 100)
    move('pointermove', 0)
    move('pointermove', 200)
    expect([isLarge(), panel.isOpen]).toEqual([true, true])
  })
})

describe('a panel that is loaded later', () => {
  it('is loaded at once if it was open before a reload, and is not pressed', async () => {
    localStorage.setItem(STORED, 'a')
    const mounted: string[] = []
    const button = buttonOf('a')
    button.addEventListener('click', () => mounted.push('pressed'))
    for (const id of ['a', 'b']) panels.panelLater(id, expect.unreachable, async () => void mounted.push(id))
    await settled()
    expect(mounted).toEqual(['a'])
  })

  it('says that it was not loaded, and is asked for again by the next press', async () => {
    const problems: string[] = []
    let asked = 0
    panels.panelLater(
      'a',
      (problem) => problems.push(problem),
      async () => {
        asked += 1
        throw new Error('no network')
      },
    )
    for (let k = 1; k <= 2; k++) {
      buttonOf('a').click()
      await settled()
      expect([asked, problems]).toEqual([k, Array(k).fill(NOT_LOADED)])
    }
  })
})
