// SPDX-License-Identifier: GPL-3.0-or-later
// The buttons of an element, on stub nodes that know only their parents.
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { INITIAL_STATE, type State } from '../../web/editing/state.ts'
import { createStore } from '../../web/editing/store.ts'
import { mountControls } from '../../web/element/controls.ts'
import { loadWords, wordsOf } from '../../web/element/language.ts'
import type { Shell } from '../../web/element/shell.ts'
import type { Figure } from '../../web/player/figure.ts'

class FakeElement {
  parentElement: FakeElement | undefined
  children: FakeElement[] = []
  disabled = false
  changes = 0
  title = ''
  set ariaPressed(_: string) {
    this.changes += 1
  }
  append(): void {}
  appendChild(child: FakeElement): FakeElement {
    return child
  }
  addEventListener(): void {}
  setAttribute(): void {}
  matches(): boolean {
    return false
  }
  replaceChildren(...children: FakeElement[]): void {
    for (const child of this.children) child.parentElement = undefined
    for (const child of children) child.parentElement = this
    this.children = children
  }
}

let showFrame = () => {}

beforeEach(() => {
  vi.stubGlobal('document', { createElement: () => new FakeElement(), createElementNS: () => new FakeElement() })
  vi.stubGlobal('requestAnimationFrame', (frame: () => void) => {
    showFrame = frame
  })
})
afterEach(() => vi.unstubAllGlobals())

it('buttons that others have taken the place of hear of nothing more', async () => {
  await loadWords('de')
  const store = createStore<State>(INITIAL_STATE)
  const controls = new FakeElement()
  const mount = (lang: string, isReadonly: boolean) =>
    mountControls({ controls } as unknown as Shell, { store } as unknown as Figure, wordsOf(lang), isReadonly)
  const change = (tool: State['tool']) => {
    store.update((state) => ({ ...state, tool }))
    showFrame()
  }
  mount('en', false)
  const [before] = controls.children as [FakeElement]
  change('add')
  expect(before.changes).toBe(2)
  mount('de', false)
  const [after] = controls.children as [FakeElement]
  expect(after.title).toBe('Kreis hinzufügen')
  change('select')
  change('add')
  expect([before.changes, after.changes]).toEqual([2, 3])
  controls.replaceChildren()
  change('select')
  expect(after.changes).toBe(3)
})
