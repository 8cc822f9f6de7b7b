// SPDX-License-Identifier: GPL-3.0-or-later
// Keyboard shortcuts, on elements without a browser.
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import type { EditorActions } from '../../web/editing/editor-actions.ts'
import { ENGLISH_KEYS, spokenKeys } from '../../web/editing/key-help.ts'
import { listenToKeyboard } from '../../web/editing/keyboard.ts'
import { INITIAL_STATE, type State } from '../../web/editing/state.ts'
import { createStore } from '../../web/editing/store.ts'
import type { View } from '../../web/view/view.ts'

/** A stub of an element that knows its ancestors. */
class FakeElement extends EventTarget {
  readonly inside: string
  constructor(inside: string) {
    super()
    this.inside = inside
  }
  closest(selectors: string): this | null {
    return selectors.split(', ').includes(this.inside) ? this : null
  }
}

beforeEach(() => {
  vi.stubGlobal('Element', FakeElement)
})
afterEach(() => vi.unstubAllGlobals())

function listenedTo(state: Partial<State> = {}, isPage = true) {
  const done: unknown[][] = []
  let gestures = 0
  const known: { [name: string]: unknown } = { pending: undefined, isReadonly: false }
  const actions = new Proxy(known, {
    get: (target, name: string) => {
      if (name in target) return target[name]
      return (...values: unknown[]) => {
        if (name === 'beginGesture') return ++gestures
        done.push([name, ...values])
        return true
      }
    },
  })
  const [figure, around] = [new FakeElement('figure'), Object.assign(new EventTarget(), isPage ? { body: {} } : {})]
  const listening = new AbortController()
  const store = createStore<State>({ ...INITIAL_STATE, ...state })
  listenToKeyboard(
    figure as unknown as HTMLElement,
    { camera: { x: 0, y: 0, scale: 4 } } as View,
    store,
    actions as unknown as EditorActions,
    {
      showHelp: () => done.push(['help']),
      editNumbers: () => done.push(['numbers']),
      drawRegion: () => done.push(['region']),
      drawKey: (...key) => {
        done.push(['draw', ...key])
        return key[0] === ' '
      },
    },
    { around: around as unknown as Document, signal: listening.signal },
  )
  const press = (key: string, { at = figure, ...rest }: { at?: EventTarget; [name: string]: unknown } = {}) => {
    const none = { ctrlKey: false, metaKey: false, shiftKey: false, altKey: false, repeat: false }
    const heard = (type: string, of: EventTarget) => {
      const event = Object.assign(new Event(type, { cancelable: true }), { key, ...none, ...rest })
      Object.defineProperty(event, 'target', { value: at })
      of.dispatchEvent(event)
      return event.defaultPrevented
    }
    const byFigure = at === figure && heard('keydown', figure)
    return heard('keydown', around) || byFigure
  }
  return { done, press, figure, around, actions: known, stop: () => listening.abort() }
}

describe('plus and minus', () => {
  it.each([
    ['=', 1, 1.04],
    ['+', 1, 1.04],
    ['-', -1, 1 / 1.04],
    ['_', -1, 1 / 1.04],
  ])('%s grows or shrinks what is selected, so that one undoes the other, and else zooms', (key, sign, factor) => {
    const selected = listenedTo({ selection: [3] })
    selected.press(key)
    selected.press(key, { shiftKey: true, repeat: true })
    const bigger = sign > 0 ? 1.4 : 1 / 1.4
    expect(selected.done).toEqual([
      ['growSelected', sign, expect.closeTo(factor, 10), 1],
      ['growSelected', 10 * sign, expect.closeTo(bigger, 10), 1],
    ])
    const [none, fixed] = [listenedTo(), listenedTo({ selection: [3] })]
    fixed.actions.isReadonly = true
    for (const { press, done } of [none, fixed]) {
      press(key)
      expect(done).toEqual([['zoomAtMiddle', sign]])
    }
  })
})

describe('an arrow key', () => {
  it('moves what is selected in one gesture for as long as it is held, by larger or finer steps', () => {
    const { done, press } = listenedTo({ selection: [3] })
    press('ArrowRight')
    press('ArrowRight', { repeat: true })
    press('ArrowUp', { repeat: true, shiftKey: true })
    press('ArrowLeft', { altKey: true })
    expect(done).toEqual([
      ['moveSelected', 1, 0, 1],
      ['moveSelected', 1, 0, 1],
      ['moveSelected', 0, 10, 1],
      ['moveSelected', -0.1, 0, 2],
    ])
  })

  it('pans where nothing is selected, or nothing may be edited', () => {
    const nothing = listenedTo()
    nothing.press('ArrowLeft')
    nothing.press('ArrowUp')
    expect(nothing.done).toEqual([
      ['pan', 48, 0],
      ['pan', -0, 48],
    ])
    const readonly = listenedTo({ selection: [3] })
    readonly.actions.isReadonly = true
    readonly.press('ArrowDown')
    expect(readonly.done).toEqual([['pan', -0, -48]])
  })
})

it('Space pans until it is released, or the focus goes', () => {
  const { done, press, figure } = listenedTo()
  press(' ')
  figure.dispatchEvent(Object.assign(new Event('keyup'), { key: ' ' }))
  press(' ')
  figure.dispatchEvent(new Event('blur'))
  expect(done.map(([name, isHeld]) => [name, isHeld])).toEqual([
    ['holdPanning', true],
    ['holdPanning', false],
    ['holdPanning', true],
    ['holdPanning', false],
  ])
})

it('Escape is used where a tool or a selection ends, and else left to the page', () => {
  const isUsed = (state: Partial<State>) => listenedTo(state).press('Escape')
  expect([{}, { tool: 'add' as const }, { selection: [1] }].map(isUsed)).toEqual([false, true, true])
})

describe('a key that is heard around the figure', () => {
  it.each(['input', 'textarea', 'select', 'dialog'])('is left to what is in it: %s', (inside) => {
    const { done, press } = listenedTo()
    const at = new FakeElement(inside)
    for (const key of ['v', 'Delete', '?', 'Escape']) expect(press(key, { at })).toBe(false)
    expect(press('z', { at, ctrlKey: true })).toBe(false)
    expect(done).toEqual([])
  })

  it('does what it says on a button, and not twice on the figure', () => {
    const { done, press } = listenedTo()
    const at = new FakeElement('button')
    for (const key of ['h', 'Delete', 'Escape', '?']) expect(press(key, { at })).toBe(true)
    expect(press('Z', { at, metaKey: true, shiftKey: true })).toBe(true)
    expect(press('x', { at })).toBe(false)
    expect(press('v', { at, altKey: true })).toBe(false)
    expect(done).toEqual([['useTool', 'pan'], ['removeSelected'], ['release'], ['help'], ['redo']])
    done.length = 0
    press('Delete')
    press('Escape')
    expect(done).toEqual([['removeSelected'], ['release']])
  })
})

describe('the keys of the figure', () => {
  it.each([
    ['0', {}, ['fit'], true],
    ['f', {}, ['zoomToSelection'], false],
    ['n', {}, ['addInRoom'], true],
    ['Enter', {}, ['selectNearMiddle'], true],
    ['Tab', {}, undefined, false],
    ['f', { selection: [3] }, ['zoomToSelection'], true],
    ['Enter', { selection: [3] }, ['numbers'], true],
    ['Backspace', { selection: [3] }, ['removeSelected'], true],
    ['Tab', { selection: [3] }, ['selectNext', 1], true],
    ['v', {}, ['useTool', 'select'], true],
    ['h', {}, ['useTool', 'pan'], true],
    ['A', {}, ['useTool', 'add'], true],
    ['s', {}, ['toggleSnapping'], true],
    ['p', {}, ['region'], true],
    ['x', {}, undefined, false],
  ])('%s with the state %j does %j', (key, state, action, isUsed) => {
    const { done, press } = listenedTo(state)
    expect([press(key), done]).toEqual([isUsed, action === undefined ? [] : [action]])
  })

  it('go back with Shift, and leave the figure where there is no next circle', () => {
    const { done, press, actions } = listenedTo({ selection: [3] })
    press('Tab', { shiftKey: true })
    expect(done).toEqual([['selectNext', -1]])
    Object.assign(actions, { selectNext: () => false })
    expect(press('Tab')).toBe(false)
  })

  it.each(['ctrlKey', 'metaKey'])('with %s are commands', (modifier) => {
    for (const [key, more, action] of [
      ['z', {}, ['undo']],
      ['Z', { shiftKey: true }, ['redo']],
      ['y', {}, ['redo']],
      ['a', {}, ['selectAll']],
      ['d', {}, ['duplicateSelected']],
      ['ArrowLeft', {}, ['selectNeighbor', [-1, 0]]],
      ['ArrowRight', {}, ['selectNeighbor', [1, 0]]],
      ['ArrowUp', {}, ['selectNeighbor', [0, 1]]],
      ['ArrowDown', {}, ['selectNeighbor', [0, -1]]],
    ] as const) {
      const { done, press } = listenedTo({ selection: [3] })
      expect([press(key, { [modifier]: true, ...more }), done]).toEqual([true, [action]])
    }
    const { done, press } = listenedTo()
    expect([press('c', { [modifier]: true }), done]).toEqual([false, []])
    expect([press('ArrowUp', { [modifier]: true, at: new FakeElement('button') }), done]).toEqual([false, []])
  })

  it('draw a region while that is the tool, unless the pen has no use for them', () => {
    const { done, press } = listenedTo({ tool: 'draw', selection: [3] })
    press(' ')
    press('0')
    expect(done).toEqual([['draw', ' ', 1], ['draw', '0', 1], ['fit']])
    const other = listenedTo({ tool: 'add' })
    other.press(' ')
    expect(other.done).toEqual([['holdPanning', true]])
  })

  it('wait for edits that select circles', async () => {
    const { done, press, actions } = listenedTo({ selection: [3] })
    let end = () => {}
    actions.pending = new Promise<void>((resolve) => {
      end = resolve
    })
    expect([press('Delete'), press('x'), press('z', { ctrlKey: true })], 'their effect is not known').toEqual([
      true,
      true,
      true,
    ])
    expect(done).toEqual([])
    end()
    await actions.pending
    await Promise.resolve()
    expect(done).toEqual([['removeSelected'], ['undo']])
  })

  it('are not heard any more once the signal is aborted', () => {
    const { done, press, figure, stop } = listenedTo({ selection: [3] })
    stop()
    press('Delete')
    press('v')
    figure.dispatchEvent(Object.assign(new Event('keyup'), { key: ' ' }))
    figure.dispatchEvent(new Event('blur'))
    expect(done).toEqual([])
  })

  it('that an element in a page uses are hidden from the page, as are those that press its buttons', () => {
    for (const [isPage, key, inside, isUsed, isHidden] of [
      [false, 'x', 'figure', false, false],
      [false, 'x', 'figure', true, true],
      [true, 'x', 'figure', true, false],
      [false, 'Enter', 'button', false, true],
      [false, ' ', 'button', false, true],
      [false, 'Enter', 'div', false, false],
      [false, 'x', 'button', false, false],
    ] as const) {
      const { around } = listenedTo({}, isPage)
      const event = Object.assign(new Event('keydown', { cancelable: true }), { key })
      const target = Object.assign(new FakeElement(inside), { localName: inside })
      Object.defineProperty(event, 'target', { value: target })
      const stop = vi.spyOn(event, 'stopPropagation')
      if (isUsed) event.preventDefault()
      around.dispatchEvent(event)
      expect([isPage, key, inside, isUsed, stop.mock.calls.length > 0]).toEqual([isPage, key, inside, isUsed, isHidden])
    }
  })
})

it('the shortcuts for screen readers are those of a figure, of the page, and without a selection', () => {
  const rows = (part: object) => Object.values(part).map(([keys, action]) => `${keys}: ${action}.`)
  const { select, edit, look, withoutSelection } = ENGLISH_KEYS
  const more = [['P', 'draw']] as const
  expect(spokenKeys(ENGLISH_KEYS, false, more)).toBe(
    [...rows(select), ...rows(edit), 'P: draw.', withoutSelection, ...rows(look)].join(' '),
  )
  expect(spokenKeys(ENGLISH_KEYS, false)).toBe(
    [...rows(select), ...rows(edit), withoutSelection, ...rows(look)].join(' '),
  )
  expect(spokenKeys(ENGLISH_KEYS, true, more)).toBe([...rows(select), ...rows(look)].join(' '))
})
