// SPDX-License-Identifier: GPL-3.0-or-later
// The buttons of an element.
// @vitest-environment happy-dom
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { INITIAL_STATE, type State } from '../../web/editing/state.ts'
import { createStore } from '../../web/editing/store.ts'
import { mountControls, paddingBelow } from '../../web/element/controls.ts'
import { loadWords, wordsOf } from '../../web/element/language.ts'
import type { Shell } from '../../web/element/shell.ts'
import type { Figure } from '../../web/player/figure.ts'
import { ADD, FIT, MINUS, PLUS, REDO, REMOVE, UNDO } from '../../web/view/icons.ts'
import { make, openPage } from './page-document.ts'

let showFrame = () => {}

beforeEach(() => {
  openPage('')
  vi.stubGlobal('requestAnimationFrame', (frame: () => void) => {
    showFrame = frame
  })
})
afterEach(() => vi.unstubAllGlobals())

function mounted() {
  const store = createStore<State>(INITIAL_STATE)
  const controls = make('div')
  const calls: unknown[][] = []
  const names = ['toggleAdding', 'removeSelected', 'undo', 'redo', 'zoomAtMiddle', 'fit']
  const actions = Object.fromEntries(names.map((name) => [name, (...args: unknown[]) => calls.push([name, ...args])]))
  const figure = make('div', { tabIndex: 0 })
  document.body.append(controls, figure)
  const mount = (lang = 'en', isReadonly = false) =>
    mountControls({ controls, figure } as Shell, { store, actions } as unknown as Figure, wordsOf(lang), isReadonly)
  const change = (state: Partial<State>) => {
    store.update((before) => ({ ...before, ...state }))
    showFrame()
  }
  return { controls, figure, calls, mount, change, buttons: () => [...controls.children] as HTMLButtonElement[] }
}

it('buttons have a name and an icon, and do what they say; readers who may only look have those that move the view', () => {
  const { mount, buttons, calls, change } = mounted()
  mount()
  const entry = {} as never
  change({ selection: [1], history: { done: [entry], undone: [entry] } })
  for (const button of buttons()) {
    expect([button.type, button.ariaLabel]).toEqual(['button', button.title])
    button.click()
  }
  expect(buttons().map(({ title }) => title)).toEqual([
    'Add a circle',
    'Delete what is selected',
    'Undo',
    'Redo',
    'Zoom out',
    'Zoom in',
    'Fit',
  ])
  const icons = buttons().map((button) => button.querySelector('path')?.getAttribute('d'))
  expect(icons).toEqual([ADD, REMOVE, UNDO, REDO, MINUS, PLUS, FIT])
  expect(calls).toEqual([
    ['toggleAdding'],
    ['removeSelected'],
    ['undo'],
    ['redo'],
    ['zoomAtMiddle', -1],
    ['zoomAtMiddle', 1],
    ['fit'],
  ])
  mount('en', true)
  expect(buttons().map(({ title }) => title)).toEqual(['Zoom out', 'Zoom in', 'Fit'])
})

it('buttons are disabled where there is nothing to do, and then give the focus to the figure', () => {
  const { mount, buttons, change, figure } = mounted()
  mount()
  const [add, remove, undo, redo] = buttons()
  const now = () => [add?.ariaPressed, remove?.disabled, undo?.disabled, redo?.disabled]
  expect(now()).toEqual(['false', true, true, true])
  const entry = {} as never
  change({ tool: 'add' })
  expect(now()).toEqual(['true', true, true, true])
  change({ tool: 'pan', selection: [1] })
  expect(now()).toEqual(['false', false, true, true])
  change({ history: { done: [entry], undone: [] } })
  expect(now()).toEqual(['false', false, false, true])
  change({ history: { done: [], undone: [entry] } })
  expect(now()).toEqual(['false', false, true, false])
  remove?.focus()
  expect(document.activeElement).toBe(remove)
  change({ selection: [] })
  expect(document.activeElement).toBe(figure)
})

it('buttons that others have taken the place of hear of nothing more', async () => {
  await loadWords('de')
  const { mount, buttons, change, controls } = mounted()
  mount()
  const [before] = buttons() as [HTMLButtonElement]
  change({ tool: 'add' })
  expect(before.ariaPressed).toBe('true')
  mount('de')
  const [after] = buttons() as [HTMLButtonElement]
  expect(after.title).toBe('Kreis hinzufügen')
  change({ tool: 'select' })
  expect([before.ariaPressed, after.ariaPressed]).toEqual(['true', 'false'])
  change({ tool: 'add' })
  controls.replaceChildren()
  change({ tool: 'select' })
  expect(after.ariaPressed).toBe('true')
})

it('the picture leaves room for buttons that are above it, and a margin without', () => {
  let position = 'absolute'
  vi.stubGlobal('getComputedStyle', () => ({ position }))
  const padding = (clientHeight: number) => paddingBelow({ clientHeight } as HTMLElement)
  expect(padding(40)).toEqual({ top: 52, right: 16, bottom: 16, left: 16 })
  expect(padding(0)).toEqual({ top: 16, right: 16, bottom: 16, left: 16 })
  position = 'static'
  expect(padding(40).top).toBe(16)
})
