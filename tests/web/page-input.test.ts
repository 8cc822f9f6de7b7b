// SPDX-License-Identifier: GPL-3.0-or-later
// Clipboard, drops and fields of the page.
// @vitest-environment happy-dom
import { render } from 'lit/html.js'
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import type { FileActions } from '../../web/app/files/file-actions.ts'
import { listenToPresses } from '../../web/app/input/after-press.ts'
import { listenToClipboard } from '../../web/app/input/clipboard.ts'
import { listenToFiles } from '../../web/app/input/dropping.ts'
import { restoreInvalidNumbers } from '../../web/app/input/invalid-numbers.ts'
import { NOT_LOADED } from '../../web/app/not-loaded.ts'
import type { PageActions } from '../../web/app/page-actions.ts'
import { selectionActions } from '../../web/app/panels/group.ts'
import { mountIdentity } from '../../web/app/panels/identity.ts'
import { mountInspector } from '../../web/app/panels/inspector.ts'
import { mountToolbar } from '../../web/app/panels/toolbar.ts'
import type { Editing } from '../../web/editing/editing.ts'
import { INITIAL_STATE, type State } from '../../web/editing/state.ts'
import { createStore, type Store } from '../../web/editing/store.ts'
import { controls, element, openPage, press, send } from './page-document.ts'

const OWN = 'application/x-circle-voronoi'

beforeEach(() => void openPage())
afterEach(() => {
  vi.unstubAllGlobals()
  vi.restoreAllMocks()
})

class Data {
  readonly kinds = new Map<string, string>()
  files: unknown[] = []
  setData(kind: string, text: string) {
    this.kinds.set(kind, text)
  }
  getData(kind: string) {
    return this.kinds.get(kind) ?? ''
  }
}

describe('what may move where a pointer is pressed', () => {
  beforeEach(() => {
    vi.useFakeTimers()
  })
  afterEach(() => {
    vi.useRealTimers()
  })

  it.each(['pointerup', 'pointercancel'])('is done at once, or after the click of a press that ends with %s', (end) => {
    const afterPress = listenToPresses(document)
    const done: string[] = []
    afterPress(() => done.push('at once'))
    send(document, 'pointerdown')
    afterPress(() => done.push('after the press'))
    vi.runAllTimers()
    expect(done).toEqual(['at once'])
    send(document, end)
    expect(done).toEqual(['at once'])
    vi.runAllTimers()
    expect(done).toEqual(['at once', 'after the press'])
    afterPress(() => done.push('again at once'))
    send(document, 'pointerdown')
    send(document, end)
    vi.runAllTimers()
    expect(done).toHaveLength(3)
  })
})

describe('a number field that is left with an invalid number', () => {
  const field = (value: string) => {
    const added = Object.assign(document.createElement('input'), { type: 'number', min: '0', value })
    document.body.append(added)
    return added
  }
  beforeEach(() => restoreInvalidNumbers(document))

  it.each([
    ['the number at the start', ['focusin'], '3'],
    ['the last valid change', ['focusin', '5', 'change'], '5'],
    ['the last valid change, not an invalid one', ['focusin', '5', 'change', '-7', 'change'], '5'],
  ])('gets %s back', (_, steps, restored) => {
    const typed = field('3')
    for (const step of steps) {
      if (Number.isNaN(Number(step))) send(typed, step)
      else typed.value = step
    }
    typed.value = '-1'
    send(typed, 'focusout')
    expect(typed.value).toBe(restored)
  })

  it('keeps a valid number, and each field has its own', () => {
    const [first, second] = [field('1'), field('2')]
    for (const each of [first, second]) send(each, 'focusin')
    first.value = '4'
    second.value = '-1'
    for (const each of [first, second]) send(each, 'focusout')
    expect([first.value, second.value]).toEqual(['4', '2'])
  })
})

describe('the clipboard', () => {
  function listening() {
    const done: unknown[][] = []
    const held = [{ id: 3, circle: { x: 1, y: 2, r: 0.5 } }]
    listenToClipboard({
      selectedCircles: () => held,
      removeSelected: () => done.push(['remove']),
      paste: (...pasted: unknown[]) => done.push(['paste', ...pasted]),
    } as unknown as PageActions)
    return { done, held }
  }

  it('gets the selected circles, as lines of numbers too', () => {
    const { held } = listening()
    held.push({ id: 9, circle: { x: -4, y: 0, r: 1e-9 } })
    const clipboardData = new Data()
    expect(send(document, 'copy', { clipboardData }).defaultPrevented).toBe(true)
    expect([...clipboardData.kinds]).toEqual([
      [OWN, '[[1,2,0.5],[-4,0,1e-9]]'],
      ['text/plain', '1\t2\t0.5\n-4\t0\t1e-9\n'],
    ])
  })

  it('is left to the browser in a field, where text is selected, and where no circle is', () => {
    const { done, held } = listening()
    const refused = (target: EventTarget = document) => {
      const clipboardData = new Data()
      expect(send(target, 'cut', { clipboardData }).defaultPrevented).toBe(false)
      expect(clipboardData.kinds.size).toBe(0)
    }
    refused(element('field-name'))
    const selected = vi.spyOn(document, 'getSelection').mockReturnValue({ isCollapsed: false } as Selection)
    refused()
    selected.mockRestore()
    held.length = 0
    refused()
    expect(done).toEqual([])
  })

  it('keeps pasted circles from being opened as a file, and nothing else', () => {
    listening()
    const others: string[] = []
    document.addEventListener('paste', ({ clipboardData }) => others.push(clipboardData?.getData(OWN) ?? ''))
    for (const text of ['[[1,2,3]]', '[]']) {
      const clipboardData = new Data()
      clipboardData.setData(OWN, text)
      send(document, 'paste', { clipboardData })
    }
    expect(others).toEqual(['[]'])
  })

  it('gives them back each time a little farther aside, from the first place after each copy', () => {
    const { done } = listening()
    const clipboardData = new Data()
    const circles = [{ x: 1, y: 2, r: 0.5 }]
    send(document, 'cut', { clipboardData })
    send(document, 'paste', { clipboardData })
    send(document, 'paste', { clipboardData })
    send(document, 'copy', { clipboardData })
    expect(send(document, 'paste', { clipboardData }).defaultPrevented).toBe(true)
    expect(done).toEqual([['remove'], ['paste', circles, 1], ['paste', circles, 2], ['paste', circles, 1]])
  })

  it.each(['', '[]', '{}', '[[1,2]]', '[[1,2,"3"]]', '[[1,2,null]]', '[1,2,3]', 'circles'])(
    'gives nothing of %j',
    (text) => {
      const { done } = listening()
      const clipboardData = new Data()
      clipboardData.setData(OWN, text)
      expect(send(document, 'paste', { clipboardData }).defaultPrevented).toBe(false)
      expect(done).toEqual([])
    },
  )
})

describe('what is dropped', () => {
  function listening(load = () => Promise.resolve()) {
    const opened: unknown[] = []
    const open = (what: unknown) => opened.push(what)
    const actions = { openFile: open, openText: open } as unknown as FileActions
    listenToFiles(
      () => load().then(() => actions),
      (problem) => opened.push(problem),
    )
    return opened
  }

  it('is announced until it has left the page or was dropped', async () => {
    const opened = listening()
    const { classList } = document.body
    const over = () => {
      expect(send(document, 'dragover').defaultPrevented, 'else the browser would go to the file').toBe(true)
      expect([...classList]).toEqual(['dropping'])
    }
    over()
    send(document, 'dragleave', { relatedTarget: element('figure') })
    expect([...classList], 'only from one element to another').toEqual(['dropping'])
    send(document, 'dragleave', { relatedTarget: null })
    expect([...classList]).toEqual([])
    over()
    const dataTransfer = new Data()
    dataTransfer.files = ['a.csv']
    expect(send(document, 'drop', { dataTransfer }).defaultPrevented).toBe(true)
    expect([...classList]).toEqual([])
    await vi.waitFor(() => expect(opened).toEqual(['a.csv']))
  })

  it('or pasted is a file, or else text that is no blank, but not what is pasted into a field', async () => {
    const opened = listening()
    const clipboardData = new Data()
    clipboardData.setData('text/plain', ' \n')
    expect(send(document, 'paste', { clipboardData }).defaultPrevented).toBe(false)
    clipboardData.setData('text/plain', '1,2,3')
    const textarea = document.createElement('textarea')
    document.body.append(textarea)
    expect(send(textarea, 'paste', { clipboardData }).defaultPrevented).toBe(false)
    expect(opened).toEqual([])
    expect(send(document, 'paste', { clipboardData }).defaultPrevented).toBe(true)
    await vi.waitFor(() => expect(opened).toEqual(['1,2,3']))
  })

  it('cannot be opened while the part that opens it does not come, which is said', async () => {
    const opened = listening(() => Promise.reject(new Error('no network')))
    const dataTransfer = new Data()
    dataTransfer.files = ['a.csv']
    send(document, 'drop', { dataTransfer })
    await vi.waitFor(() => expect(opened).toEqual([NOT_LOADED]))
  })
})

describe('the fields of the selected circle', () => {
  function mounted() {
    const set: unknown[] = []
    const store = createStore<State>({ ...INITIAL_STATE, selected: 7, circle: { x: 1, y: 2, r: 3 } })
    const complain = (problem: string) => store.update((state) => ({ ...state, problem }))
    /** Selected circles besides that of the state. */
    const held: unknown[] = []
    const actions = {
      selectedCircles: () => {
        const { selected: id, circle } = store.get()
        return circle === undefined ? [] : [{ id, circle }, ...held]
      },
      set: (edits: unknown) => set.push(edits),
      select: (ids: unknown) => set.push(ids),
      complain,
    }
    const frames: (() => void)[] = []
    vi.stubGlobal('requestAnimationFrame', (frame: () => void) => frames.push(frame))
    const focusNumbers = mountInspector(store, actions as unknown as PageActions)
    const fields = ['x', 'y', 'r'].map((name) => element<HTMLInputElement>(`field-${name}`))
    const change = (more: Partial<State>) => {
      store.update((state) => ({ ...state, ...more }))
      for (const frame of frames.splice(0)) frame()
    }
    const type = (field: HTMLInputElement | undefined, text: string, types = ['input', 'change']) => {
      if (field === undefined) throw new Error('There is no such field.')
      field.value = text
      for (const type of types) send(field, type)
    }
    return { set, held, state: store.get, fields, change, type, focusNumbers }
  }

  it('set the number that each is for', () => {
    const { set, fields, type } = mounted()
    for (const field of fields) type(field, '9')
    expect(set).toEqual([
      [{ id: 7, circle: { x: 9, y: 2, r: 3 } }],
      [{ id: 7, circle: { x: 1, y: 9, r: 3 } }],
      [{ id: 7, circle: { x: 1, y: 2, r: 9 } }],
    ])
  })

  it('set nothing where several circles are selected', () => {
    const { set, fields, held, type } = mounted()
    held.push({ id: 8, circle: { x: 4, y: 5, r: 6 } })
    type(fields[0], '9')
    expect(set).toEqual([])
  })

  it('set nothing where no circle is selected any more', () => {
    const { set, fields, change, type } = mounted()
    change({ selected: undefined, circle: undefined })
    type(fields[0], '9')
    expect(set).toEqual([])
    expect(element('inspector').hidden).toBe(true)
  })

  it('keep what is being typed, and say that it was refused, until they are left', () => {
    const { fields, change, type, state } = mounted()
    const [x, y] = fields
    type(x, '40', ['input'])
    change({ circle: { x: 5, y: 6, r: 3 }, problem: 'no number' })
    expect([x?.value, y?.value]).toEqual(['40', '6'])
    expect([x, y].map((field) => field?.getAttribute('aria-invalid'))).toEqual(['true', 'false'])
    x?.dispatchEvent(new Event('blur'))
    // Neither the refused value nor its error remains.
    expect(x?.value).toBe('5')
    expect(state().problem).toBe('')
    change({ problem: '', circle: { x: 8, y: 6, r: 4 } })
    expect(x?.value).toBe('8')
    expect(x?.getAttribute('aria-invalid')).toBe('false')
  })

  it('take back only the error of what was refused, not one that came while the pointer was pressed', () => {
    vi.useFakeTimers()
    const { fields, change, type, state } = mounted()
    for (const problem of ['no number', 'no file']) {
      type(fields[0], '-', ['input'])
      change({ problem: 'no number' })
      send(document, 'pointerdown')
      fields[0]?.dispatchEvent(new Event('blur'))
      change({ problem })
      send(document, 'pointerup')
      vi.runAllTimers()
      expect(state().problem).toBe(problem === 'no file' ? problem : '')
    }
    vi.useRealTimers()
  })

  it('give the focus back to the figure at Escape', () => {
    const { fields, focusNumbers } = mounted()
    focusNumbers()
    expect(document.activeElement).toBe(fields[0])
    send(fields[1] as HTMLElement, 'keydown', { key: 'a' })
    expect(document.activeElement).toBe(fields[0])
    send(fields[1] as HTMLElement, 'keydown', { key: 'Escape' })
    expect(document.activeElement).toBe(element('figure'))
  })
})

describe('the name and the color of the selected circle', () => {
  const names = new Map<number, string>()
  const done: unknown[][] = []
  let frames: (() => void)[]
  const draw = () => {
    for (const frame of frames.splice(0)) frame()
  }
  const field = (name: string) => element<HTMLInputElement>(`field-${name}`)
  /** Presses a key in a field. Returns whether no other element hears of it. */
  const pressKey = (key: string) => {
    const event = Object.assign(new Event('keydown', { bubbles: true }), { key })
    const stop = vi.spyOn(event, 'stopPropagation')
    field('name').dispatchEvent(event)
    return stop.mock.calls.length > 0
  }

  function mounted() {
    names.clear()
    done.length = 0
    frames = []
    names.set(3, 'Ulm')
    vi.stubGlobal('requestAnimationFrame', (frame: () => void) => frames.push(frame))
    vi.stubGlobal(
      'OffscreenCanvas',
      class {
        getContext = () => ({ fillStyle: '' })
      },
    )
    const store = createStore<State>({ ...INITIAL_STATE, selection: [3], selected: 3 })
    const select = (selected: number | undefined, more: Partial<State> = {}) => {
      store.update((state) => ({ ...state, selected, selection: selected === undefined ? [] : [selected], ...more }))
      draw()
    }
    let gestures = 0
    const actions = {
      setName: (...args: unknown[]) => done.push(['name', ...args]),
      setColor: (...args: unknown[]) => done.push(['color', ...args]),
      ownColorOf: (id: number) => (id === 3 ? '#aa0000' : undefined),
      beginGesture: () => ++gestures,
      zoomToSelection: () => done.push(['zoom']),
    }
    const editing = { nameOf: (id: number) => names.get(id) ?? '' }
    mountIdentity(store, editing as unknown as Editing, actions as unknown as PageActions)
    return { select, actions: actions as unknown as PageActions }
  }

  it('are those of the circle', () => {
    const { select } = mounted()
    const shown = () => [
      element('inspector-title').textContent,
      field('name').value,
      field('color').value,
      field('name').placeholder,
    ]
    expect([element('inspector-title').textContent, field('name').value]).toEqual(['Ulm', 'Ulm'])
    expect(field('color').value).toBe('#aa0000')
    select(4, { described: { color: '#00bb00' } as never })
    expect([element('inspector-title').textContent, field('name').value]).toEqual(['Circle 4', ''])
    expect(field('color').value).toBe('#00bb00')
    const before = shown()
    select(undefined)
    expect(shown()).toEqual(before)
  })

  it('a name that is being written stays while the circle changes, and is for the circle it was begun for', () => {
    const { select } = mounted()
    const type = (text: string) => {
      field('name').value = text
      send(field('name'), 'input')
    }
    type(' Bonn ')
    select(3, { attributes: { ...INITIAL_STATE.attributes } })
    expect(field('name').value).toBe(' Bonn ')
    select(4)
    expect(field('name').value).toBe('')
    field('name').value = 'Bonn'
    send(field('name'), 'change')
    expect(done).toEqual([['name', 3, 'Bonn']])
    // An unchanged name is not written again.
    send(field('name'), 'change')
    select(3)
    type('Kiel')
    expect(pressKey('a')).toBe(false)
    expect(pressKey('Escape'), 'the panel stays open').toBe(true)
    expect([field('name').value, document.activeElement]).toEqual(['Ulm', element('figure')])
    send(field('name'), 'change')
    type('Ulm')
    pressKey('Enter')
    expect(done).toHaveLength(1)
  })

  it('a color that is picked is one step, however many are tried', () => {
    mounted()
    field('color').value = '#123456'
    for (const type of ['input', 'input', 'change', 'input']) send(field('color'), type)
    expect(done.map(([, , , gesture]) => gesture)).toEqual([1, 1, 2])
    expect(done[0]).toEqual(['color', [3], '#123456', 1])
  })

  it('a color that is being picked is not replaced', () => {
    const { select } = mounted()
    field('color').focus()
    select(4, { described: { color: '#00bb00' } as never })
    expect(field('color').value).toBe('#aa0000')
  })

  it('the figure has the focus again after a button of the selection', () => {
    const { actions } = mounted()
    const place = document.createElement('div')
    render(selectionActions(actions, [4]), place)
    expect(controls(place).size).toBe(3)
    press(place, 'Zoom to')
    expect([done, document.activeElement]).toEqual([[['zoom']], element('figure')])
    // A circle with a color of its own can have an automatic one.
    render(selectionActions(actions, [3, 4]), place)
    expect([...controls(place).keys()]).toContain('Automatic color')
  })
})

describe('the toolbar', () => {
  const button = (id: string) => element<HTMLButtonElement>(id)

  it('has undo and redo where there is something to undo and to redo, and the tool in use pressed', () => {
    let show = (_: State) => {}
    const store = {
      get: () => INITIAL_STATE,
      subscribe(listener: typeof show) {
        show = listener
      },
    }
    mountToolbar(store as unknown as Store<State>, {} as PageActions, () => {})
    const entry = { kind: 'edits' }
    for (const done of [[], [entry]]) {
      for (const undone of [[], [entry]]) {
        show({ ...INITIAL_STATE, history: { done, undone } } as unknown as State)
        expect([button('undo').disabled, button('redo').disabled]).toEqual([done.length === 0, undone.length === 0])
      }
    }
    for (const tool of ['select', 'pan', 'add', 'draw'] as const) {
      show({ ...INITIAL_STATE, tool })
      const pressed = ['select', 'pan', 'add'].filter((id) => button(id).getAttribute('aria-pressed') === 'true')
      expect(pressed).toEqual(tool === 'draw' ? [] : [tool])
    }
  })

  it('does what its buttons are for', () => {
    const done: unknown[] = []
    const actions = new Proxy(
      {},
      {
        get:
          (_, name) =>
          (...args: unknown[]) =>
            done.push([name, ...args]),
      },
    )
    const store = { get: () => INITIAL_STATE, subscribe() {} }
    mountToolbar(store as unknown as Store<State>, actions as PageActions, () => done.push(['more']))
    for (const id of ['select', 'pan', 'add', 'undo', 'redo', 'again']) button(id).click()
    const menu = element<HTMLSelectElement>('data-set')
    for (const value of ['spruces', 'more']) {
      menu.value = value
      send(menu, 'change')
    }
    expect(done).toEqual([
      ['useTool', 'select'],
      ['useTool', 'pan'],
      ['toggleAdding'],
      ['undo'],
      ['redo'],
      ['generateAgain'],
      ['load', 'spruces'],
      ['more'],
    ])
    // The menu shows the open circles again.
    expect(menu.value).toBe('')
  })
})
