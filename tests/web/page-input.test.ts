// SPDX-License-Identifier: GPL-3.0-or-later
// Clipboard, drops and fields of the page, on a document without a browser.
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

/** A stub of an element. */
class FakeElement extends EventTarget {
  readonly inside: string | undefined
  readonly attributes = new Map<string, string>()
  hidden = false
  textContent = ''
  title = ''
  value = ''
  focused = 0
  disabled = false
  constructor(inside?: string) {
    super()
    this.inside = inside
  }
  get valueAsNumber() {
    return this.value === '' ? Number.NaN : Number(this.value)
  }
  closest(selectors: string) {
    return this.inside !== undefined && selectors.split(', ').includes(this.inside) ? this : null
  }
  contains() {
    return false
  }
  matches() {
    return false
  }
  append() {}
  setAttribute(name: string, value: string) {
    this.attributes.set(name, value)
  }
  focus() {
    this.focused += 1
  }
}

const OWN = 'application/x-circle-voronoi'

let page: EventTarget & { body: { classList: Set<string> & { remove?: (name: string) => void } } }
let isTextSelected = false
const elements = new Map<string, FakeElement>()
beforeEach(() => {
  const classes = Object.assign(new Set<string>(), { remove: (name: string) => classes.delete(name) })
  elements.clear()
  page = Object.assign(new EventTarget(), {
    body: { classList: classes },
    activeElement: undefined,
    getSelection: () => ({ isCollapsed: !isTextSelected }),
    getElementById: (id: string) => {
      if (!elements.has(id)) elements.set(id, new FakeElement())
      return elements.get(id)
    },
  })
  isTextSelected = false
  vi.stubGlobal('document', page)
  for (const name of [
    '',
    'HTML',
    'HTMLInput',
    'HTMLButton',
    'HTMLParagraph',
    'HTMLHeading',
    'HTMLUList',
    'HTMLSelect',
  ]) {
    vi.stubGlobal(`${name}Element`, FakeElement)
  }
})
afterEach(() => vi.unstubAllGlobals())

/** Sends an event to the page and returns it. */
function send(type: string, more: object, target: EventTarget = page) {
  const event = Object.assign(new Event(type, { cancelable: true }), more)
  Object.defineProperty(event, 'target', { value: target })
  page.dispatchEvent(event)
  return event
}

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
    const afterPress = listenToPresses(page as unknown as Document)
    const done: string[] = []
    afterPress(() => done.push('at once'))
    send('pointerdown', {})
    afterPress(() => done.push('after the press'))
    vi.runAllTimers()
    expect(done).toEqual(['at once'])
    send(end, {})
    expect(done).toEqual(['at once'])
    vi.runAllTimers()
    expect(done).toEqual(['at once', 'after the press'])
    afterPress(() => done.push('again at once'))
    send('pointerdown', {})
    send(end, {})
    vi.runAllTimers()
    expect(done).toHaveLength(3)
  })
})

describe('a number field that is left with an invalid number', () => {
  const field = (value: string) => {
    const isValid = () => Number(added.value) >= 0
    const added = Object.assign(new FakeElement(), { type: 'number', value, checkValidity: isValid })
    return added
  }
  beforeEach(() => restoreInvalidNumbers(page as unknown as Document))

  it.each([
    ['the number at the start', ['focusin'], '3'],
    ['the last valid change', ['focusin', '5', 'change'], '5'],
    ['the last valid change, not an invalid one', ['focusin', '5', 'change', '-7', 'change'], '5'],
  ])('gets %s back', (_, steps, restored) => {
    const typed = field('3')
    for (const step of steps) {
      if (Number.isNaN(Number(step))) send(step, {}, typed)
      else typed.value = step
    }
    typed.value = '-1'
    send('focusout', {}, typed)
    expect(typed.value).toBe(restored)
  })

  it('keeps a valid number, and each field has its own', () => {
    const [first, second] = [field('1'), field('2')]
    for (const each of [first, second]) send('focusin', {}, each)
    first.value = '4'
    second.value = '-1'
    for (const each of [first, second]) send('focusout', {}, each)
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
    expect(send('copy', { clipboardData }).defaultPrevented).toBe(true)
    expect([...clipboardData.kinds]).toEqual([
      [OWN, '[[1,2,0.5],[-4,0,1e-9]]'],
      ['text/plain', '1\t2\t0.5\n-4\t0\t1e-9\n'],
    ])
  })

  it('is left to the browser in a field, where text is selected, and where no circle is', () => {
    const { done, held } = listening()
    const refused = (target?: EventTarget) => {
      const clipboardData = new Data()
      expect(send('cut', { clipboardData }, target).defaultPrevented).toBe(false)
      expect(clipboardData.kinds.size).toBe(0)
    }
    refused(new FakeElement('input'))
    isTextSelected = true
    refused()
    isTextSelected = false
    held.length = 0
    refused()
    expect(done).toEqual([])
  })

  it('keeps pasted circles from being opened as a file, and nothing else', () => {
    listening()
    const others: string[] = []
    page.addEventListener('paste', (event) => others.push((event as ClipboardEvent).clipboardData?.getData(OWN) ?? ''))
    for (const text of ['[[1,2,3]]', '[]']) {
      const clipboardData = new Data()
      clipboardData.setData(OWN, text)
      send('paste', { clipboardData })
    }
    expect(others).toEqual(['[]'])
  })

  it('gives them back each time a little farther aside, from the first place after each copy', () => {
    const { done } = listening()
    const clipboardData = new Data()
    const circles = [{ x: 1, y: 2, r: 0.5 }]
    send('cut', { clipboardData })
    send('paste', { clipboardData })
    send('paste', { clipboardData })
    send('copy', { clipboardData })
    expect(send('paste', { clipboardData }).defaultPrevented).toBe(true)
    expect(done).toEqual([['remove'], ['paste', circles, 1], ['paste', circles, 2], ['paste', circles, 1]])
  })

  it.each(['', '[]', '{}', '[[1,2]]', '[[1,2,"3"]]', '[[1,2,null]]', '[1,2,3]', 'circles'])(
    'gives nothing of %j',
    (text) => {
      const { done } = listening()
      const clipboardData = new Data()
      clipboardData.setData(OWN, text)
      expect(send('paste', { clipboardData }).defaultPrevented).toBe(false)
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
    const { classList } = page.body
    const over = () => {
      expect(send('dragover', {}).defaultPrevented, 'else the browser would go to the file').toBe(true)
      expect([...classList]).toEqual(['dropping'])
    }
    over()
    send('dragleave', { relatedTarget: new FakeElement() })
    expect([...classList], 'only from one element to another').toEqual(['dropping'])
    send('dragleave', { relatedTarget: null })
    expect([...classList]).toEqual([])
    over()
    const dataTransfer = new Data()
    dataTransfer.files = ['a.csv']
    expect(send('drop', { dataTransfer }).defaultPrevented).toBe(true)
    expect([...classList]).toEqual([])
    await vi.waitFor(() => expect(opened).toEqual(['a.csv']))
  })

  it('or pasted is a file, or else text that is no blank, but not what is pasted into a field', async () => {
    const opened = listening()
    const clipboardData = new Data()
    clipboardData.setData('text/plain', ' \n')
    expect(send('paste', { clipboardData }).defaultPrevented).toBe(false)
    clipboardData.setData('text/plain', '1,2,3')
    expect(send('paste', { clipboardData }, new FakeElement('textarea')).defaultPrevented).toBe(false)
    expect(opened).toEqual([])
    expect(send('paste', { clipboardData }).defaultPrevented).toBe(true)
    await vi.waitFor(() => expect(opened).toEqual(['1,2,3']))
  })

  it('cannot be opened while the part that opens it does not come, which is said', async () => {
    const opened = listening(() => Promise.reject(new Error('no network')))
    const dataTransfer = new Data()
    dataTransfer.files = ['a.csv']
    send('drop', { dataTransfer })
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
    const [x, y, r] = ['x', 'y', 'r'].map((name) => elements.get(`field-${name}`) as FakeElement)
    const change = (more: Partial<State>) => {
      store.update((state) => ({ ...state, ...more }))
      for (const frame of frames.splice(0)) frame()
    }
    const type = (field: FakeElement | undefined, text: string, types = ['input', 'change']) => {
      if (field === undefined) throw new Error('There is no such field.')
      field.value = text
      for (const type of types) field.dispatchEvent(new Event(type))
    }
    return { set, held, state: store.get, fields: [x, y, r] as FakeElement[], change, type, focusNumbers }
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
    expect(elements.get('inspector')?.hidden).toBe(true)
  })

  it('keep what is being typed, and say that it was refused, until they are left', () => {
    const { fields, change, type, state } = mounted()
    const [x, y] = fields
    type(x, '-', ['input'])
    change({ circle: { x: 5, y: 6, r: 3 }, problem: 'no number' })
    expect([x?.value, y?.value]).toEqual(['-', '6'])
    expect([x, y].map((field) => field?.attributes.get('aria-invalid'))).toEqual(['true', 'false'])
    x?.dispatchEvent(new Event('blur'))
    // Neither the refused value nor its error remains.
    expect(x?.value).toBe('5')
    expect(state().problem).toBe('')
    change({ problem: '', circle: { x: 8, y: 6, r: 4 } })
    expect(x?.value).toBe('8')
    expect(x?.attributes.get('aria-invalid')).toBe('false')
  })

  it('take back only the error of what was refused, not one that came while the pointer was pressed', () => {
    vi.useFakeTimers()
    const { fields, change, type, state } = mounted()
    for (const problem of ['no number', 'no file']) {
      type(fields[0], '-', ['input'])
      change({ problem: 'no number' })
      send('pointerdown', {})
      fields[0]?.dispatchEvent(new Event('blur'))
      change({ problem })
      send('pointerup', {})
      vi.runAllTimers()
      expect(state().problem).toBe(problem === 'no file' ? problem : '')
    }
    vi.useRealTimers()
  })

  it('give the focus back to the figure at Escape', () => {
    const { fields, focusNumbers } = mounted()
    focusNumbers()
    expect(fields[0]?.focused).toBe(1)
    const figure = elements.get('figure') as FakeElement
    for (const key of ['a', 'Escape']) fields[1]?.dispatchEvent(Object.assign(new Event('keydown'), { key }))
    expect(figure.focused).toBe(1)
  })
})

describe('the name and the color of the selected circle', () => {
  const names = new Map<number, string>()
  const done: unknown[][] = []
  let frames: (() => void)[]
  const draw = () => {
    for (const frame of frames.splice(0)) frame()
  }
  const element = (id: string) => elements.get(id) as FakeElement
  const send = (id: string, type: string, more: object = {}) => {
    const event = Object.assign(new Event(type, { bubbles: true }), more)
    Object.defineProperty(event, 'target', { value: element(id) })
    const stop = vi.spyOn(event, 'stopPropagation')
    element(id).dispatchEvent(event)
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
    const shown = () => ['inspector-title', 'field-name', 'field-color'].map((id) => Object.values(element(id)))
    expect([element('inspector-title').textContent, element('field-name').value]).toEqual(['Ulm', 'Ulm'])
    expect(element('field-color').value).toBe('#aa0000')
    select(4, { described: { color: '#00bb00' } as never })
    expect([element('inspector-title').textContent, element('field-name').value]).toEqual(['Circle 4', ''])
    expect(element('field-color').value).toBe('#00bb00')
    const before = shown()
    select(undefined)
    expect(shown()).toEqual(before)
  })

  it('a name that is being written stays while the circle changes, and is for the circle it was begun for', () => {
    const { select } = mounted()
    const type = (text: string) => {
      element('field-name').value = text
      send('field-name', 'input')
    }
    type(' Bonn ')
    select(3, { attributes: { ...INITIAL_STATE.attributes } })
    expect(element('field-name').value).toBe(' Bonn ')
    select(4)
    expect(element('field-name').value).toBe('')
    element('field-name').value = 'Bonn'
    send('field-name', 'change')
    expect(done).toEqual([['name', 3, 'Bonn']])
    // An unchanged name is not written again.
    send('field-name', 'change')
    select(3)
    type('Kiel')
    expect(send('field-name', 'keydown', { key: 'a' })).toBe(false)
    expect(send('field-name', 'keydown', { key: 'Escape' }), 'the panel stays open').toBe(true)
    expect([element('field-name').value, element('figure').focused]).toEqual(['Ulm', 1])
    send('field-name', 'change')
    type('Ulm')
    send('field-name', 'keydown', { key: 'Enter' })
    expect(done).toHaveLength(1)
  })

  it('a color that is picked is one step, however many are tried', () => {
    mounted()
    element('field-color').value = '#123456'
    for (const type of ['input', 'input', 'change', 'input']) send('field-color', type)
    expect(done.map(([, , , gesture]) => gesture)).toEqual([1, 1, 2])
    expect(done[0]).toEqual(['color', [3], '#123456', 1])
  })

  it('a color that is being picked is not replaced', () => {
    const { select } = mounted()
    Object.assign(page, { activeElement: element('field-color') })
    select(4, { described: { color: '#00bb00' } as never })
    expect(element('field-color').value).toBe('#aa0000')
  })

  it('the figure has the focus again after a button of the selection', () => {
    const { actions } = mounted()
    const buttons = selectionActions(actions, [4]).values.filter((value) => typeof value === 'function')
    expect(buttons).toHaveLength(3)
    ;(buttons[0] as () => void)()
    expect([done, element('figure').focused]).toEqual([[['zoom']], 1])
    // A circle with a color of its own can have an automatic one.
    expect(selectionActions(actions, [3, 4]).values[0]).not.toBe(selectionActions(actions, [4]).values[0])
  })
})

describe('the toolbar', () => {
  beforeEach(() => vi.stubGlobal('Option', FakeElement))
  const button = (id: string) => elements.get(id) as FakeElement

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
      const pressed = ['select', 'pan', 'add'].filter((id) => button(id).attributes.get('aria-pressed') === 'true')
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
    for (const id of ['select', 'pan', 'add', 'undo', 'redo', 'again']) button(id).dispatchEvent(new Event('click'))
    for (const value of ['spruces', 'more']) {
      Object.assign(button('data-set'), { value }).dispatchEvent(new Event('change'))
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
    expect(button('data-set').value).toBe('')
  })
})
