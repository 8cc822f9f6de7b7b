// SPDX-License-Identifier: GPL-3.0-or-later
// Gestures and keys on a figure with its thread: what a user does, and what is different then. The places are points of
// the plane.
// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { figureActions } from '../../web/editing/figure-actions.ts'
import type { State } from '../../web/editing/state.ts'
import { Figure } from '../../web/player/figure.ts'
import { NO_PADDING } from '../../web/view/camera.ts'
import type { Layers } from '../../web/view/layers.ts'
import { make, measure, send } from './page-document.ts'
import { quiet, surround } from './whole-page.ts'

const THREE = [0, 0, 4, 10, 0, 2, 0, 10, 1]
/** Many small circles at one place. */
const CROWD = [0, 1, 2, 3, 4, 5, 6].flatMap((k) => [0.25 * k, 0, 0.01])
/** Ten pixels per unit, with the origin in the middle. */
const CAMERA = { x: 0, y: 0, scale: 10 }
const PATH = { from: { x: -20, y: 0 }, to: { x: 20, y: 0 } }

/** Setups by their names in the tables. */
const SETUPS = {
  empty: { circles: [] },
  crowd: { circles: CROWD },
  path: { layers: { path: PATH } },
  disc: { layers: { disc: true } },
  scrolls: { scrolls: true },
  readonly: { readonly: true },
  '-': {},
} satisfies Record<string, Setup>

interface Setup {
  readonly circles?: readonly number[]
  readonly select?: readonly number[]
  readonly tool?: State['tool']
  readonly layers?: Partial<Layers>
  readonly scrolls?: boolean
  readonly readonly?: boolean
  readonly snaps?: boolean
}

let current: Figure | undefined
/** The further keys that were used. */
let used: string[] = []

surround()
beforeEach(() => {
  document.body.innerHTML = ''
  used = []
  // Presses last as long as the steps say.
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] })
})
afterEach(async () => {
  current?.dispose()
  await quiet()
  vi.useRealTimers()
})

async function opened({ circles = THREE, select, tool, layers, scrolls = false, ...rest }: Setup = {}) {
  const page = document.body.appendChild(make('div'))
  const element = page.appendChild(make('div', { tabIndex: 0 }))
  measure(element, { clientWidth: 800, clientHeight: 600 })
  const figure = new Figure(
    { figure: element, around: page, player: make('div'), said: make('p') },
    {
      scrolls,
      actions: (parts) => figureActions(parts, () => NO_PADDING),
      onoutcome() {},
      played: () => ({ method: 'touching-disc' }),
      keys: { showHelp: () => used.push('help'), editNumbers: () => used.push('numbers') },
    },
  )
  current = figure
  const { view, actions, store, editing } = figure
  await figure.open({ circles: Float64Array.from(circles), dataSet: '', isEdited: false })
  view.setCamera(CAMERA)
  if (layers !== undefined) view.setLayers(layers)
  if (rest.readonly) actions.circles.isReadonly = true
  if (rest.snaps) actions.tools.toggleSnapping()
  if (tool !== undefined) actions.tools.useTool(tool)
  if (select !== undefined) actions.selection.select(select)
  await quiet()
  const before = { ...store.get() }

  /** Sends one event, such as `move 3,4 touch #2 alt`, `key z ctrl` or `wheel 100`, and returns it. */
  async function act(step: string): Promise<Event> {
    const [type = '', ...words] = step.trim().split(' ')
    const has = (word: string) => words.includes(word)
    const [x = 0, y = 0] =
      words
        .find((word) => word.includes(','))
        ?.split(',')
        .map(Number) ?? []
    const number = (mark: string) => Number(words.find((word) => word.startsWith(mark))?.slice(1) ?? Number.NaN)
    const more = {
      ...{ offsetX: 400 + 10 * x, offsetY: 300 - 10 * y, pointerId: number('#') || 1, button: number('b') || 0 },
      ...{ pointerType: has('touch') ? 'touch' : 'mouse', shiftKey: has('shift'), altKey: has('alt') },
      ...{ ctrlKey: has('ctrl'), metaKey: has('meta'), repeat: has('repeat'), touches: has('two') ? [1, 2] : [1] },
    }
    let event = new Event('nothing')
    if (type === 'hold' || type === 'late') vi.advanceTimersByTime(450)
    else if (type === 'key' || type === 'keyup')
      event = send(element, type === 'key' ? 'keydown' : 'keyup', {
        ...more,
        key: words[0] === 'Space' ? ' ' : words[0],
      })
    else if (type === 'wheel')
      event = send(element, type, { ...more, deltaX: 0, deltaY: Number(words[0]), deltaMode: has('lines') ? 1 : 0 })
    else
      event = send(
        element,
        { dbl: 'dblclick', cancel: 'pointercancel', lost: 'lostpointercapture' }[type] ??
          (/^(down|move|up|leave)$/.test(type) ? `pointer${type}` : type),
        more,
      )
    // A late event arrives before the next frame.
    if (type !== 'late') await quiet()
    return event
  }

  const rounded = (value: number) => Math.round(1000 * value) / 1000 + 0
  /** Returns what is different from the start: circles by id, and the rest by name. */
  function different(): string {
    const { camera, layers } = view
    const { selection, tool, hovered } = store.get()
    const found: [name: string | number, value: unknown][] = []
    for (let id = 0; id < Math.max(circles.length / 3, editing.circles.size); id++) {
      const circle = editing.circles.get(id)
      const now = circle && [circle.x, circle.y, circle.r].map(rounded)
      if (String(now ?? '') !== String(circles.slice(3 * id, 3 * id + 3))) found.push([id, now ?? 'gone'])
    }
    if (String(selection) !== String(before.selection)) found.push(['selection', selection.join() || 'none'])
    if (tool !== before.tool) found.push(['tool', tool])
    if (hovered !== undefined) found.push(['hovered', hovered])
    const seen = [camera.x, camera.y, camera.scale].map(rounded)
    if (seen.join() !== '0,0,10') found.push(['camera', seen])
    const { to } = layers.path ?? PATH
    if (to.x !== 20) found.push(['path', [to.x, to.y]])
    return found.map(([name, value]) => `${name} ${value}`).join('; ')
  }

  /** Does some steps, and returns what is different then. */
  async function perform(script: string) {
    for (const step of script.split(';')) await act(step)
    return different()
  }
  return { figure, element, page, act, perform, different, cursor: () => element.dataset.cursor }
}

/** The title, the setup, the steps, and what is different then, where `*` is any number. */
type Row = readonly [title: string, setup: Setup, script: string, different: string]

function rowsOf(table: string): Row[] {
  return table
    .trim()
    .split('\n')
    .map((line) => {
      const [title, setup, script, different] = line.split(' | ') as [string, string, string, string]
      return [title, Object.assign({}, ...setup.split('; ').map(setupOf)), script, different === '-' ? '' : different]
    })
}

function setupOf(words: string): Setup {
  const [name, value = ''] = words.split(' ')
  if (name === 'select') return { select: value.split(',').map(Number) }
  if (name === 'tool') return { tool: value as State['tool'] }
  return SETUPS[name as keyof typeof SETUPS]
}

async function isDifferentAfter(_: string, setup: Setup, script: string, expected: string): Promise<void> {
  const { perform } = await opened(setup)
  const found = await perform(script)
  const pattern = expected.replace(/[.+]/g, '\\$&').replace(/\*/g, '-?[\\d.,]+')
  expect(found).toMatch(new RegExp(`^${pattern}$`))
}

const two = { select: [0, 1] }

describe('a gesture', () => {
  it.each(
    rowsOf(`
a press on a disc selects it | - | down 1,1; move 1.3,1 | selection 0
a drag moves a disc | - | down 1,1; move 1.4,1; move 3,2; up 3,2 | 0 2,1,4; selection 0
a click on one of several selects it | select 0,1 | down 10,0; up 10,0 | selection 1
a drag moves all that are selected | select 0,1 | down 10,0; move 12,3; up 12,3 | 0 2,3,4; 1 12,3,2
a drag of a rim resizes its circle | - | down 4.2,0; move 6.2,0; up 6.2,0 | 0 0,0,6; selection 0
a rim goes no farther than the center | - | down 4.2,0; move 0.1,0; up 0.1,0 | 0 0,0,0; selection 0
a drag of a rim moves several circles | select 0,1 | down 4,0; move 5,0; up 5,0 | 0 1,0,4; 1 11,0,2
a click on a rim selects its circle | select 0,1 | down 4,0; up 4,0 | selection 0
a drag of a cell pans | - | down 5,5; move 7,4; move 8,4; up 8,4 | camera -3,1,10
a click on a cell selects its circle | - | down 5,5; up 5,5 | selection 0
a click selects what is where a pan has brought it | - | down 5,5; move 15,5; up 15,5; down 20,0; up 20,0 | selection 1; camera -10,0,10
a click where there are no circles selects none | empty | down 5,5; up 5,5 | -
a circle that may not be edited is selected, and its drag pans | readonly | down 0,0; up 0,0; down 0,0; move 1,0; up 1,0 | selection 0; camera -1,0,10
a drag snaps to a tangent while Alt is held | - | down 0,0; move 3.3,0.2 alt; up 3.3,0.2 alt | 0 4.003,0.179,4; selection 0
a finger drags a disc | - | down 0,0 touch; move 1,0 touch; up 1,0 touch | 0 1,0,4; selection 0
a finger selects nothing before it is lifted or moves | - | down 4,0 touch | -
a finger moves a circle by its rim | - | down 4,0 touch; move 6,0 touch; up 6,0 touch | 0 2,0,4; selection 0
a finger resizes a selected circle | select 0 | down 4,0 touch; move 6,0 touch; up 6,0 touch | 0 0,0,6
a finger pans where many circles are in its reach | crowd | down 0,0 touch; move 1,0 touch; up 1,0 touch | camera -1,0,10
a finger resizes the selected one of many | crowd; select 0 | down 0,0 touch; move 0.5,0 touch; up 0.5,0 touch | 0 0,0,0.51
a finger taps one of several off and on | select 0,1 | down 0,0 touch; up 0,0 touch; down 0,10 touch; up 0,10 touch | selection 2
a finger taps a cell | select 0,1 | down 20,20 touch; up 20,20 touch | selection 1
the right button does nothing | - | down 0,0 b2; move 3,0; up 3,0 | hovered 0
the middle button pans | - | down 0,0 b1; move 1,0; up 1,0; down 0,0 b1; up 0,0 | camera -1,0,10
the tool to pan pans, and clicks nothing | tool pan | down 0,0; move 0,1; up 0,1; down 0,0; up 0,0 | camera 0,-1,10
the tool to pan pans on handles | select 0,1; tool pan; path | down 20,0; move 20,1; up 20,1 | camera 0,-1,10
a canceled pointer takes a drag back | - | down 0,0; move 1,0; cancel; move 2,0; up 2,0 | selection 0; hovered 0
a lost pointer takes a drag back | - | down 0,0; move 1,0; lost | selection 0
another pointer takes no drag back | - | down 0,0; move 1,0; cancel #2; move 2,0; up 2,0 | 0 2,0,4; selection 0
Escape takes a drag back | - | down 0,0; move 1,0; key Escape; move 2,0; up 2,0 | selection 0
Shift selects within a band | - | down -6,-6 shift; move 13,5; up 13,5 shift | selection 0,1
a band that is canceled selects nothing | - | down -6,-6 shift; move 13,5; cancel 13,5 shift | -
Shift and a click add a circle to the selection | select 0 | down 10,0 shift; up 10,0 shift | selection 0,1
Shift and a click take a circle out of it | select 0,1 | down 10,0 shift; up 10,0 shift | selection 0
the tool to add makes a circle that fits | tool add | down 20,0; up 20,0 | 3 20,0,*; selection 3
the tool to add makes a circle as large as a drag | tool add | down 20,20; move 21,20; move 23,24; up 23,24 | 3 20,20,5; selection 3
a drag that adds is taken back | tool add | down 20,20; move 23,24; cancel | -
a press that adds is taken back | tool add | down 20,20; key Escape; up 20,20 | -
the handle scales what is selected about its middle | select 0,1 | down 12.7,-4.7; move 21.4,-9.4; up 21.4,-9.4 | 0 -4,0,8; 1 16,0,4
a canceled handle scales nothing | select 0,1 | down 12.7,-4.7; move 21.4,-9.4; cancel | -
an end of the path is dragged | path | down 20,0; move 21,5; up 21,5 | path 21,5
an end of the path is put back | path | down 20,0; move 21,5; cancel | -
two fingers zoom and pan | - | down -5,0 touch #1; down 5,0 touch #2; move 15,0 touch #2; up 15,0 touch #2; up -5,0 touch #1 | camera -2.5,0,20
a second finger takes back what the first one did | select 0 | down 0,0 touch #1; move 1,0 touch #1; down 9,0 touch #2; up 9,0 touch #2; up 1,0 touch #1 | -
a double click adds where no disc is | - | dbl 20,0 | 3 20,0,*; selection 3
a double click on a disc adds nothing | - | dbl 0,0 | -
the wheel zooms by pixels | - | wheel 100 | camera 0,0,8.521
the wheel zooms by lines | - | wheel 10 lines | camera 0,0,7.741
a pinch zooms | - | wheel 100 ctrl | camera 0,0,3.679
a zoom keeps the place of the pointer | - | wheel -100 10,0 ctrl | camera 6.321,0,27.183
a long press adds a circle where it is released | - | down 20,20; hold; move 22,20; up 22,20 | 3 22,20,*; selection 3
a long press with the tool to add takes its press back | tool add | down 20,20; hold; up 20,20 | 3 20,20,*; selection 3
a move in time is no long press, however late it is told | - | down 5,5; late; move 7,5; up 7,5 | camera -2,0,10
a long press on a disc drags it | - | down 0,0; hold; move 1,0; up 1,0 | 0 1,0,4; selection 0
a long press with Shift is a click | - | down 20,20 shift; hold; up 20,20 shift | selection 1
a long press of the middle button is none | - | down 20,20 b1; hold; up 20,20 | -
a long press with the tool to pan is none | tool pan | down 20,20; hold; up 20,20 | -
a long press on a handle is none | select 0,1 | down 12.7,-4.7; hold; up 12.7,-4.7 | -
a long press of a finger adds a circle | - | down 20,20 touch; hold; up 20,20 touch | 3 20,20,*; selection 3
a finger that rests shows a disc if that layer is visible | disc | down 20,20 touch; hold; move 22,20 touch; up 22,20 touch | -
a finger that rests on a circle adds it to the selection | select 1 | down 0,0 touch; hold; up 0,0 touch | selection 1,0
a finger that rests on a selected circle drags all | select 0,1 | down 0,0 touch; hold; move 1,0 touch; up 1,0 touch | 0 1,0,4; 1 11,0,2
a pointer hovers over what is under it | - | move 10,0 | hovered 1
a pointer hovers over what a drag has left it on | - | move 0,0; down 0,0; move 1,0; up 1,0; move 10,0 | 0 1,0,4; selection 0; hovered 1
a pointer that has left hovers over nothing | - | move 10,0; leave 10,0 | -
a finger does not hover | - | move 10,0 touch | -
`),
  )('%s', isDifferentAfter)

  it('is one step, and its undo leads back', async () => {
    const { figure, perform, different } = await opened()
    await perform('down 0,0; move 1,0; move 2,0; move 3,0; up 3,0')
    expect(figure.store.get().history.done).toHaveLength(1)
    await figure.actions.circles.undo()
    expect(different()).toBe('selection 0')
  })

  it('has a cursor that says what a press would do, and that it pans', async () => {
    const { act, cursor, figure } = await opened(two)
    const seen: unknown[] = []
    for (const step of ['move 10,0', 'move 5,5', 'move 12.7,-4.7', 'move 5,5', 'down 5,5', 'move 6,5', 'up 6,5']) {
      await act(step)
      seen.push(cursor())
    }
    for (const tool of ['add', 'pan'] as const) {
      figure.actions.tools.useTool(tool)
      await act('move 5,5')
      seen.push(cursor())
    }
    await act('down 5,5')
    expect([...seen, cursor()].join(' ')).toBe('disc cell scale cell panning panning cell add pan panning')
  })

  it('opens no menu, and is known until its last finger is lifted', async () => {
    const { act, figure } = await opened()
    const seen: unknown[] = []
    for (const step of ['leave 0,0', 'down 1,2 touch #1', 'down 5,2 touch #2', 'up 1,2 touch #1', 'up 5,2 touch #2']) {
      await act(step)
      seen.push([figure.isPressed, (await act('contextmenu 1,2')).defaultPrevented])
    }
    expect(seen).toEqual([false, true, true, true, false].map((isPressed) => [isPressed, isPressed]))
  })

  it('is not heard after the end', async () => {
    const { figure, act, different } = await opened()
    await act('down 20,20')
    figure.dispose()
    current = undefined
    for (const step of ['hold', 'up 20,20', 'down 0,0', 'move 1,0', 'key Delete', 'key a ctrl', 'dbl 20,20'])
      await act(step)
    expect(different()).toBe('')
  })
})

describe('in a page that scrolls', () => {
  const scrolls = true
  it.each(
    rowsOf(`
a finger on a cell leaves scrolling to the page | scrolls | down 5,5 touch; move 9,5 touch; up 9,5 touch | -
a finger on a circle that may not be edited, too | scrolls; readonly | down 0,0 touch; move 5,0 touch; up 5,0 touch | -
a finger selects what it taps | scrolls; readonly | down 1,0 touch; up 1,0 touch | selection 0
a finger adds to several circles | select 0,1; scrolls | down 0,10 touch; up 0,10 touch | selection 0,1,2
a finger drags a circle at once, however small | scrolls | down 0,10 touch; move 1,10 touch; up 1,10 touch | 2 1,10,1; selection 2
a mouse drags as elsewhere | scrolls | down 0,0; move 1,0; up 1,0 | 0 1,0,4; selection 0
the wheel scrolls the page | scrolls | wheel 100 | -
the wheel zooms with Ctrl | scrolls | wheel 100 ctrl | camera 0,0,*
the wheel zooms after a press | scrolls | down 20,20 b1; up 20,20; wheel 100 | camera 0,0,*
the wheel scrolls once the pointer has left | scrolls | down 20,20 b1; up 20,20; leave 0,0; wheel 100 | -
`),
  )('%s', isDifferentAfter)

  it.each([
    ['one finger on a disc', {}, 'down 0,0 touch', true],
    ['one finger on a cell', {}, 'down 5,5 touch', false],
    ['two fingers', {}, 'down 5,5 touch #1; down 6,5 touch #2', true],
    ['a finger with the tool to add', { tool: 'add' }, 'down 5,5 touch', true],
    ['a finger on the end of a path', { layers: { path: PATH } }, 'down 20,0 touch', true],
    ['a finger on a handle', two, 'down 12.7,-4.7 touch', true],
  ] as const)('%s keeps the page from scrolling if it drags something', async (_, setup, script, isKept) => {
    const { act, perform } = await opened({ scrolls, ...setup })
    await perform(script)
    expect((await act(`touchstart 0,0 touch ${script.includes('#2') && 'two'}`)).defaultPrevented).toBe(isKept)
  })
})

describe('a key', () => {
  const one = { select: [0] }
  it.each(
    rowsOf(`
+ makes what is selected larger | select 0 | key + | 0 0,0,4.5
- takes back what + did | select 0 | key +; key - | -
Shift makes steps of ten | select 0 | key + shift | 0 0,0,9
+ zooms without a selection | - | key + | camera 0,0,*
- zooms where nothing may be edited | select 0; readonly | key - | camera 0,0,*
an arrow moves what is selected by five pixels | select 0 | key ArrowRight; key ArrowUp shift; key ArrowLeft alt | 0 0.45,5,4
an arrow pans without a selection | - | key ArrowLeft; key ArrowUp | camera -4.8,4.8,10
Space pans until it is released | - | key Space; down 0,0; move 1,0; up 1,0; keyup Space | camera -1,0,10
Space pans until the focus goes | - | key Space; blur; down 0,0; move 1,0; up 1,0 | 0 1,0,4; selection 0
Escape ends the selection | select 0 | key Escape | selection none
Escape ends a tool | tool add | key Escape | tool select
Delete and Backspace delete what is selected | select 0 | key Delete; down 10,0; up 10,0; key Backspace | 0 gone; 1 gone; selection none
Tab selects the next circle | select 0 | key Tab | selection 1
Shift and Tab select the previous one | select 1 | key Tab shift | selection 0
Tab goes on from the circle that was selected last | select 2,0 | key Tab | selection 1
Shift and Tab go back from there | select 0,2 | key Tab shift | selection 1
Enter selects the circle in the middle | - | key Enter | selection 0
v, h and a choose tools | tool pan | key v; key A | tool add
h chooses the tool to pan | - | key h | tool pan
n adds a circle where there is room | - | key n | 3 *; selection 3
f zooms to the selection | select 0 | key f | camera 0,0,*
0 shows all circles | - | key 0 | camera *
Ctrl and a select all | - | key a ctrl | selection 0,1,2
Meta and d duplicate | select 0 | key d meta | 3 *,*,4; selection 3
Ctrl and arrows select neighbors | select 0 | key ArrowRight ctrl | selection 1
Ctrl and arrows stay where no neighbor is | select 0 | key ArrowLeft ctrl | -
nothing is edited where nothing may be | readonly; select 0 | key Delete; key n; key d ctrl; dbl 20,20 | -
Ctrl and z, y go back and forth | select 0 | key Delete; key z ctrl; key y ctrl; key z ctrl; key Z ctrl shift | 0 gone; selection none
keys wait for edits that select circles | select 0 | key d ctrl; key Delete | selection none
`),
  )('%s', isDifferentAfter)

  it.each([
    ['Escape', {}, false],
    ['Tab', {}, false],
    ['x', {}, false],
    ['f', {}, false],
    ['c ctrl', one, false],
    ['Escape', one, true],
    ['Tab', { select: [2] }, false],
    ['Tab', one, true],
    ['Enter', one, true],
  ] as const)('%s with the setup %j is left to the page unless it is used', async (key, setup, isUsed) => {
    const { act } = await opened(setup)
    expect((await act(`key ${key}`)).defaultPrevented).toBe(isUsed)
  })

  it('is one step for as long as an arrow is held', async () => {
    const { figure, perform } = await opened(one)
    await perform('key ArrowRight; key ArrowRight repeat; key ArrowUp repeat shift')
    expect(figure.store.get().history.done).toHaveLength(1)
    await perform('key ArrowLeft')
    expect(figure.store.get().history.done).toHaveLength(2)
    await perform('key Enter; key ?')
    expect(used).toEqual(['numbers', 'help'])
  })

  it('is left to fields around the figure, and on its buttons no letter is a shortcut', async () => {
    const { page, different } = await opened(one)
    const press = async (
      name: 'input' | 'textarea' | 'select' | 'dialog' | 'button',
      key: string,
      more: object = {},
    ) => {
      const event = send(page.appendChild(make(name)), 'keydown', { key, ...more })
      await quiet()
      return event.defaultPrevented
    }
    for (const name of ['input', 'textarea', 'select', 'dialog'] as const) {
      for (const key of ['v', 'Delete', '?', 'Escape']) expect(await press(name, key)).toBe(false)
      expect(await press(name, 'z', { ctrlKey: true })).toBe(false)
    }
    expect(different()).toBe('')
    for (const key of ['v', 'h', 'a', 's', 'p', '?', 'Backspace']) expect(await press('button', key)).toBe(false)
    expect([different(), used]).toEqual(['', []])
    expect(await press('button', 'Delete')).toBe(true)
    expect(different()).toBe('0 gone; selection none')
  })
})
