// SPDX-License-Identifier: GPL-3.0-or-later
// The frame of panels: opening, closing, reloads, and the sheet of phones.
// @vitest-environment happy-dom
import { html } from 'lit/html.js'
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { buttonOf, control, element, openPage, send } from './page-document.ts'

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
