// SPDX-License-Identifier: GPL-3.0-or-later
// <circle-voronoi> in a page, with its threads and its buttons. Nothing of the project is replaced.
// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { CircleVoronoiElement, defineCircleVoronoi } from '../../web/element/define.ts'
import { CircleVoronoiError } from '../../web/lib/index.ts'
import { DEFAULT_LAYERS } from '../../web/view/layers.ts'
import { held, Observer } from './element-page.ts'
import { control, controls, send } from './page-document.ts'
import { ThreadHere } from './page-threads.ts'
import { box } from './shapes.ts'
import { eventually } from './turns.ts'
import { quiet, soon, surround } from './whole-page.ts'

const THREE = [
  [0, 0, 2],
  [10, 0, 1],
  [5, 8, 1.5],
]
const FLAT = THREE.flat()
const TEXT = JSON.stringify(THREE)
const SQUARE = 'POLYGON ((-9 -9, 19 -9, 19 19, -9 19))'
const RING = box(-9, -9, 19, 19)
const EVENTS = [
  'circleschange',
  'diagramchange',
  'checkchange',
  'goalschange',
  'selectionchange',
  'stepchange',
  'input',
  'change',
  'error',
]
type Attributes = Readonly<Record<string, string>>
type Properties = Record<string, unknown>

surround()
defineCircleVoronoi()
beforeEach(() => {
  document.body.innerHTML = ''
  Observer.areNear = true
})
afterEach(async () => {
  vi.unstubAllGlobals()
  held.release()
  document.body.innerHTML = ''
  await quiet()
})

/** An element with attributes, which is in no page yet, and what it tells. */
function made(attributes: Attributes = { circles: TEXT }) {
  const element = document.createElement('circle-voronoi')
  const shadow = element.shadowRoot as ShadowRoot
  const events: CustomEvent[] = []
  for (const name of EVENTS) element.addEventListener(name, (event) => events.push(event as CustomEvent))
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value)
  const part = (name: string) => shadow.querySelector(name) as HTMLElement
  return {
    element,
    properties: element as unknown as Properties,
    part,
    figure: part('.figure'),
    problem: () => (part('.problem').hidden ? '' : part('.problem').textContent),
    circles: () => [...element.circles],
    events,
    /** The names of the events since the last call. */
    told: () => events.splice(0).map(({ type }) => type),
    /** Sends keys to the figure, and waits for what follows. */
    keys: async (...keys: (string | object)[]) => {
      for (const key of keys) send(part('.figure'), 'keydown', typeof key === 'string' ? { key } : key)
      await settled(element)
    },
    /** Presses a button by its name. */
    press: async (name: string) => {
      control(part('.controls'), name).click()
      await settled(element)
    },
    /** Lets a change pass, and returns the errors that it caused. */
    errors: async (act: () => unknown) => {
      events.length = 0
      act()
      await settled(element)
      return events.flatMap(({ type, detail }) => (type === 'error' ? [detail.error as CircleVoronoiError] : []))
    },
  }
}

async function settled(element: CircleVoronoiElement): Promise<void> {
  await element.updateComplete
  await quiet()
}

/** An element in a page that shows its circles. */
async function shown(attributes?: Attributes) {
  const all = made(attributes)
  document.body.append(all.element)
  await all.element.ready
  await settled(all.element)
  return all
}

const UNDO = { key: 'z', ctrlKey: true }

describe('a wrong attribute', () => {
  const wrong = [
    ['areas', '1 x', 'equal'],
    ['check', '{', '{"circles": 3}'],
    ['check', '{"cell": 3, "edges": 1}', '{"cell": 2, "edges": 1}'],
    ['controls', 'x', 'player'],
    ['lattice', '1 0 0', '30 0 0 30'],
    ['layers', 'x', 'hull'],
    ['method', 'x', 'flip'],
    ['region', 'POLYGON x', SQUARE],
    ['samples', '-1', '3'],
    ['step', 'x', '2'],
    ['view', '1 2', '1 2 3'],
  ] as const

  it.each(wrong)('%s="%s" is one error event, and is visible until it is right or gone', async (name, bad, good) => {
    const { element, problem, errors, circles } = await shown({
      circles: TEXT,
      ...(name === 'areas' && { region: SQUARE }),
    })
    for (const end of [() => element.setAttribute(name, good), () => element.removeAttribute(name)]) {
      const [error, ...others] = await errors(() => element.setAttribute(name, bad))
      expect(error).toBeInstanceOf(CircleVoronoiError)
      expect([error?.code, others]).toEqual([expect.stringMatching(/^bad(Input|Option)$/), []])
      expect(problem()).toBe(error?.message)
      expect(await errors(end)).toEqual([])
      expect(problem()).toBe('')
    }
    // Areas choose the radii.
    if (name !== 'areas') expect(circles()).toEqual(FLAT)
  })
})

describe('a state', () => {
  const VIEW = { x: 4, y: 3, span: 20 }
  it.each<[string, Properties]>([
    ['a view without a span', { view: { x: 1, y: 2 } }],
    ['a view that shows nothing', { view: { ...VIEW, span: 0 } }],
    ['a view that is none', { view: null }],
    ['a layer that is no flag', { layers: { hull: 1 } }],
    ['an unknown layer', { layers: { hulls: true } }],
    ['layers that are a text', { layers: 'hull' }],
    ['a negative step', { step: -1 }],
    ['a step that is no number', { step: 'first' }],
  ])('with %s is refused in one sentence, and the figure keeps the last one', async (_, wrong) => {
    const { element } = await shown({ circles: TEXT })
    for (const last of [{ view: VIEW }, { circles: THREE, view: VIEW, layers: { dual: true } }]) {
      await element.setState(last)
      await settled(element)
      const before = element.getState()
      for (const more of [{ view: { ...VIEW, span: 9 } }, { circles: [[1, 1, 1]] }]) {
        await expect(element.setState({ ...more, ...wrong } as never)).rejects.toThrow(/^[A-Z][^.]*\.( [A-Z].*\.)?$/)
        await settled(element)
        expect(element.getState()).toEqual(before)
      }
    }
  })

  it('has the column of a link, which an element leaves out', async () => {
    const { element } = await shown({ circles: TEXT })
    await element.setState({ layers: { column: 'height', hull: true } })
    expect(element.getState().layers).toEqual({ hull: true })
  })
})

describe('a check', () => {
  it('that names a circle which is missing is wrong until circles have it', async () => {
    const { element, problem, errors } = await shown({ circles: TEXT, check: '{"cell": 3, "edges": 1}' })
    expect(problem()).not.toBe('')
    expect(await errors(() => Object.assign(element, { circles: [...THREE, [20, 0, 1]] }))).toEqual([])
    expect(problem()).toBe('')
    expect(await errors(() => Object.assign(element, { circles: THREE }))).toHaveLength(1)
    expect(await errors(() => element.setState({ edits: [{ kind: 'remove', id: 0 }] }))).toEqual([])
    expect(problem()).not.toBe('')
  })

  it('is the value and the validity of the field, a state, a part of the description, and an event where it changes', async () => {
    document.body.innerHTML = '<form></form>'
    const all = made({ circles: TEXT, check: '{"circles": 4}', controls: '', name: 'a' })
    const { element, part, events } = all
    document.forms[0]?.append(element)
    await element.ready
    await settled(element)
    const { internals } = held.of(element)
    const now = () => [JSON.parse(internals.value).check, element.checkValidity(), internals.states.has('met')]
    const checked = () => events.splice(0).flatMap(({ type, detail }) => (type === 'checkchange' ? [detail.isMet] : []))
    expect(element.form).toBe(document.forms[0])
    expect(JSON.parse(internals.value).circles).toEqual(THREE)
    expect([now(), checked()]).toEqual([[false, false, false], [false]])
    const unmet = element.validationMessage
    expect(unmet).not.toBe('')
    expect(part('#about').textContent).toContain(unmet)
    expect(part('#about').textContent).toMatch(/^3 /)
    expect(internals.anchor).toBe(all.figure)
    element.selection = [0]
    await all.keys({ key: 'd', ctrlKey: true })
    expect([now(), checked(), element.validationMessage]).toEqual([[true, true, true], [true], ''])
    expect(part('#about').textContent).not.toContain(unmet)
    await all.keys(UNDO)
    await all.keys({ key: 'y', ctrlKey: true })
    expect(checked()).toEqual([false, true])
    element.removeAttribute('check')
    await settled(element)
    expect([now(), checked(), element.check]).toEqual([[undefined, true, false], [false], undefined])
  })

  it('rings its circles, tells their values in the language of the element, and closes the rings once it is met', async () => {
    const { element, part, events, keys } = await shown({
      circles: TEXT,
      check: '{"all": [{"cell": 1, "hidden": false}, {"circles": 4}]}',
    })
    await settled(element)
    const told = () => events.splice(0).flatMap(({ type, detail }) => (type === 'goalschange' ? [detail.text] : []))
    expect(told()).toEqual(['Hidden: now no, goal no; circles: now 3, goal 4'])
    expect(part('#about').textContent).toContain('circles: now 3, goal 4')
    const ring = () => part('.rings circle').getAttribute('class')
    expect(part('.rings b').textContent).toBe('1')
    element.selection = [0]
    await keys({ key: 'd', ctrlKey: true })
    expect(told()).toEqual(['Hidden: now no, goal no; circles: now 4, goal 4'])
    expect(ring()).toContain('closed')
    element.lang = 'de'
    await eventually(() => expect(told()).toEqual(['Verborgen: jetzt nein, Ziel nein; Kreise: jetzt 4, Ziel 4']))
    element.removeAttribute('check')
    await settled(element)
    expect(told()).toEqual([''])
    expect(element.shadowRoot?.querySelector('.rings circle')).toBeNull()
  })

  it('that is replaced while it is examined says nothing', async () => {
    const { element, told } = await shown()
    told()
    element.setAttribute('check', '{"circles": 3}')
    element.removeAttribute('check')
    await settled(element)
    expect(told()).toEqual([])
    expect(held.of(element).internals.states.has('met')).toBe(false)
  })
})

describe('a field of a form', () => {
  it('is reset to the circles of its attributes, restored to those that the browser kept, and disabled', async () => {
    const { element, circles, part } = await shown({ circles: TEXT, controls: '' })
    element.formStateRestoreCallback('{"circles": [[1, 1, 1]]}')
    await settled(element)
    expect(circles()).toEqual([1, 1, 1])
    element.formResetCallback()
    await settled(element)
    expect(circles()).toEqual(FLAT)
    for (const isDisabled of [true, false]) {
      element.formDisabledCallback(isDisabled)
      expect(controls(part('.controls')).has('Undo')).toBe(!isDisabled)
    }
  })
})

describe('attributes and properties', () => {
  it.each([
    ['alt', 'Trees', 'Trees', ''],
    ['check', { circles: 3 }, '{"circles":3}', undefined],
    ['check', '{"circles": 3}', '{"circles": 3}', undefined],
    ['controls', 'player', 'player', null],
    ['controls', true, '', null],
    ['lang', 'de', 'de', ''],
    ['method', 'flip', 'flip', 'auto'],
    ['name', 'a', 'a', ''],
    ['samples', 3, '3', undefined],
    ['src', 'a.csv', 'a.csv', ''],
    ['step', 0, '0', undefined],
    ['areas', '1 2', '1 2', undefined],
    ['lattice', '9 0 0 9', '9 0 0 9', undefined],
    ['layers', 'hull', 'hull', DEFAULT_LAYERS],
    ['region', SQUARE, SQUARE, undefined],
    ['view', '1 2 3', '1 2 3', undefined],
    ['readonly', true, '', false],
    ['dissolve', true, '', false],
  ] as const)('the property %s of %j is the attribute "%s", and without it %j', (name, value, attribute, none) => {
    const { element, properties, told } = made({})
    for (const nothing of [undefined, null, ...(typeof value === 'boolean' ? [false] : [])]) {
      properties[name] = value
      expect(element.getAttribute(name)).toBe(attribute)
      properties[name] = nothing
      // The attribute of a text stays if the property has other forms, too.
      if (['areas', 'lattice', 'layers', 'region', 'view'].includes(name)) element.removeAttribute(name)
      expect(element.hasAttribute(name)).toBe(false)
      expect(properties[name]).toEqual(none)
    }
    expect(told()).toEqual([])
  })

  it.each(['readonly', 'dissolve'])('%s is set by true alone', (name) => {
    const { element, properties } = made({})
    for (const value of [0, '', 'false', Number.NaN]) {
      properties[name] = true
      properties[name] = value
      expect([value, element.hasAttribute(name)]).toEqual([value, false])
    }
  })

  it('layers and a view are seen at once in a figure that runs, with the data of clients', async () => {
    const data = [{ id: 'a', color: 'rgb(1, 2, 3)', points: Float64Array.of(1, 2) }]
    const early = made({ circles: TEXT })
    early.element.layers = { data }
    document.body.append(early.element)
    expect(await early.element.toSVG()).toContain('rgb(1, 2, 3)')
    const { element } = await shown({ circles: TEXT, layers: 'hull' })
    const state = () => element.getState()
    const seen: unknown[] = []
    for (const act of [
      () => Object.assign(element, { layers: { dual: true } }),
      () => Object.assign(element, { layers: undefined }),
      () => element.setAttribute('layers', 'dual'),
      () => element.removeAttribute('layers'),
    ]) {
      act()
      seen.push(state().layers)
    }
    expect(seen).toEqual([{ dual: true }, { hull: true }, { dual: true }, {}])
    element.view = { x: 1, y: 2, span: 9 }
    await settled(element)
    expect(state().view).toMatchObject({ x: 1, y: 2 })
    element.setAttribute('view', '3 4 9')
    await settled(element)
    expect(state().view).toMatchObject({ x: 3, y: 4 })
  })

  it.each([
    ['areas', [1, -1]],
    ['areas', []],
    ['circles', [[0, 0]]],
    ['value', [[0, 0]]],
    ['lattice', { a: [1, 0] }],
    ['layers', { x: true }],
    ['region', 7],
    ['selection', 7],
    ['view', { x: 1, y: 2, span: 0 }],
  ])('the property %s of %j is one error, and leaves the former value', async (name, value) => {
    const { element, properties, problem, errors } = await shown()
    const former = structuredClone(properties[name])
    const [error, ...others] = await errors(() => Object.assign(element, { [name]: value }))
    expect([error?.code, others]).toEqual([expect.stringMatching(/^bad(Input|Option)$/), []])
    expect(problem()).toBe(error?.message)
    expect(properties[name]).toEqual(former)
    expect(await errors(() => Object.assign(element, { [name]: undefined }))).toEqual([])
    expect(problem()).toBe('')
  })
})

describe('circles', () => {
  it('are those of the newest request, however late others are', async () => {
    const { element, circles } = await shown()
    held.hold()
    element.circles = [[1, 1, 1]]
    await held.isFull()
    element.circles = [[2, 2, 2]]
    held.release()
    await settled(element)
    expect(circles()).toEqual([2, 2, 2])
  })

  it.each([
    ['[[1, 2]]', 'badInput'],
    ['[[0, 0, 1e-30]]', 'coordinateTooSmall'],
  ])('%s are an error, and the content stays where there were none before', async (text, code) => {
    const all = await shown({ circles: text })
    expect(all.events.flatMap(({ detail }) => detail?.error?.code ?? [])).toEqual([code])
    const isRunning = () => all.part('.frame').dataset.running
    expect([all.part('slot[name=poster]'), isRunning(), all.problem()]).toEqual([null, 'false', expect.any(String)])
    expect(await all.errors(() => all.element.setAttribute('circles', TEXT))).toEqual([])
    expect([all.problem(), isRunning()]).toEqual(['', 'true'])
    const good = await shown()
    expect(await good.errors(() => good.element.setAttribute('circles', '[[1, 2]]'))).toHaveLength(1)
    expect([good.part('slot[name=poster]'), good.circles()]).toEqual([expect.anything(), FLAT])
  })

  it('between the tags are read once the page has them all', async () => {
    const state = vi.spyOn(document, 'readyState', 'get').mockReturnValue('loading')
    const { element, circles } = made({})
    document.body.append(element)
    await quiet()
    element.textContent = '|1|2|3|'
    await quiet()
    expect(circles()).toEqual([])
    state.mockRestore()
    for (const type of ['DOMContentLoaded', 'load']) window.dispatchEvent(new Event(type))
    await element.ready
    expect(circles()).toEqual([1, 2, 3])
  })

  it('of an address replace those of properties, and are not waited for once there are others', async () => {
    const { element, circles } = await shown()
    element.circles = [[1, 1, 1]]
    await settled(element)
    const asked: [src: string, signal: AbortSignal][] = []
    vi.stubGlobal('fetch', (src: string, { signal }: { signal: AbortSignal }) => {
      asked.push([src, signal])
      return src.endsWith('a.csv') ? Promise.resolve(new Response('9,9,9\n')) : new Promise(() => {})
    })
    element.removeAttribute('circles')
    element.src = 'a.csv'
    await settled(element)
    expect([asked.at(-1)?.[0], circles()]).toEqual([new URL('a.csv', document.baseURI).href, [9, 9, 9]])
    for (const end of [() => Object.assign(element, { circles: THREE }), () => element.remove()]) {
      element.src = 'b.csv'
      await quiet()
      expect(asked.at(-1)?.[1].aborted).toBe(false)
      end()
      await quiet()
      expect(asked.at(-1)?.[1].aborted).toBe(true)
    }
  })
})

describe('readers', () => {
  /** Presses the pointer on circle 0, or moves or releases it, some pixels beside the middle. */
  const point = (figure: HTMLElement, type: string, aside = 0) =>
    send(figure, type, { pointerId: 1, button: 0, pointerType: 'mouse', offsetX: 150 + aside, offsetY: 100 })

  it('release circles once all their edits are made', async () => {
    const { element, figure, told } = await shown({ circles: TEXT, view: '0 0 40' })
    point(figure, 'pointerdown')
    point(figure, 'pointermove', 30)
    await settled(element)
    held.hold()
    point(figure, 'pointermove', 60)
    await held.isFull()
    told()
    point(figure, 'pointerup', 60)
    expect(told()).toEqual([])
    held.release()
    await settled(element)
    expect(told().filter((name) => ['input', 'change'].includes(name))).toEqual(['input', 'change'])
  })
})

describe('buttons', () => {
  it('do what they say, and are disabled where there is nothing to do', async () => {
    const { element, part, circles, press } = await shown({ circles: TEXT, controls: '' })
    const button = (name: string) => control(part('.controls'), name)
    for (const [name, each] of controls(part('.controls')))
      expect(each.querySelector('svg > path')?.getAttribute('d'), name).toMatch(/^m/i)
    const enabled = () => ['Delete what is selected', 'Undo', 'Redo'].map((name) => !button(name).disabled)
    expect(enabled()).toEqual([false, false, false])
    element.selection = [1]
    await settled(element)
    expect(enabled()).toEqual([true, false, false])
    await press('Delete what is selected')
    expect([circles().length, enabled()]).toEqual([6, [false, true, false]])
    await press('Undo')
    expect([circles().length, enabled()]).toEqual([9, [true, false, true]])
    await press('Redo')
    expect(circles()).toHaveLength(6)
    for (const isPressed of ['true', 'false']) {
      await press('Add a circle')
      expect(button('Add a circle').ariaPressed).toBe(isPressed)
    }
    const spanAfter = async (name: string) => {
      await press(name)
      return element.getState().view?.span
    }
    const near = (await spanAfter('Zoom in')) as number
    expect(await spanAfter('Zoom in')).toBeLessThan(near)
    expect(await spanAfter('Zoom out')).toBeCloseTo(near, 6)
    expect(await spanAfter('Fit')).toBeUndefined()
  })
})

describe('an element that leaves its page', () => {
  it('ends its figure, and has no history of circles that were replaced meanwhile', async () => {
    const { element, figure, part, keys } = await shown({ circles: TEXT, controls: '' })
    element.selection = [1]
    await keys('Delete')
    expect(control(part('.controls'), 'Undo').disabled).toBe(false)
    element.remove()
    await quiet()
    expect([figure.children.length, part('.frame').dataset.running]).toEqual([0, 'false'])
    element.circles = THREE
    document.body.append(element)
    await element.ready
    await settled(element)
    expect(control(part('.controls'), 'Undo').disabled).toBe(true)
  })

  it('selects nothing once it is back, and says so', async () => {
    const { element, events } = await shown()
    element.selection = [1]
    await settled(element)
    events.length = 0
    element.remove()
    await quiet()
    document.body.append(element)
    await element.ready
    await settled(element)
    const selections = events.flatMap(({ type, detail }) => (type === 'selectionchange' ? [detail.selection] : []))
    expect([element.selection, selections]).toEqual([[], [[]]])
  })

  it('reports no circles that arrive afterwards', async () => {
    const { element, told } = await shown()
    held.hold()
    element.circles = [[0, 0, -1]]
    await held.isFull()
    told()
    element.remove()
    await Promise.resolve()
    held.release()
    await quiet()
    expect(told()).not.toContain('error')
  })
})

describe('a figure', () => {
  it('begins when the browser is idle, unless readers save data', async () => {
    Observer.areNear = false
    const [saving, other] = [true, false].map((saveData) => {
      Object.defineProperty(navigator, 'connection', { value: { saveData }, configurable: true })
      const { element, figure } = made()
      document.body.append(element)
      return figure
    })
    Object.defineProperty(navigator, 'connection', { value: undefined, configurable: true })
    await soon(() => expect(other?.children).toHaveLength(2))
    expect(saving?.children).toHaveLength(0)
  })

  it('is complete once all is computed, checked and painted', async () => {
    const { element, figure } = await shown()
    const isComplete = async () => {
      let isDone = false
      void element.updateComplete.then(() => {
        isDone = true
      })
      for (let k = 0; k < 5; k++) await new Promise((resolve) => requestAnimationFrame(resolve))
      return isDone
    }
    for (const change of [{ circles: [[1, 1, 1]] }, { check: { circles: 1 } }]) {
      held.hold()
      Object.assign(element, change)
      await held.isFull()
      expect(await isComplete()).toBe(false)
      held.release()
      await settled(element)
    }
    figure.ariaBusy = 'true'
    expect(await isComplete()).toBe(false)
    figure.ariaBusy = 'false'
    await settled(element)
    // Without circles, nothing is painted.
    const empty = await shown({})
    empty.figure.ariaBusy = 'true'
    await empty.element.updateComplete
  })

  it('tells what went wrong, also while it shows circles, and goes on', async () => {
    const { element, problem, errors, circles, keys } = await shown()
    const [error] = await errors(() => {
      for (const { onerror } of [...ThreadHere.running]) onerror?.({ message: 'out of memory' })
    })
    expect(error?.message).toContain('out of memory')
    expect(problem()).toContain(error?.message.replace(/\.$/, ''))
    element.selection = [1]
    await keys('Delete')
    await soon(() => expect(circles()).toHaveLength(6))
  })
})

describe('a domain', () => {
  it('that is changed in several parts at once is changed once, after what is opened', async () => {
    const { element, told, circles } = await shown()
    told()
    Object.assign(element, { region: [RING], areas: [3, 2, 1] })
    await settled(element)
    expect(told()).toEqual(['circleschange', 'diagramchange'])
    expect([element.areas, element.region]).toEqual([[3, 2, 1], expect.anything()])
    Object.assign(element, { areas: undefined, region: undefined })
    await settled(element)
    expect(told()).toEqual(['circleschange', 'diagramchange'])
    expect([element.areas, element.region]).toEqual([undefined, undefined])
    Object.assign(element, { circles: THREE.slice(1), region: [RING] })
    await settled(element)
    expect([element.region, circles()]).toEqual([expect.anything(), FLAT.slice(3)])
  })

  // Areas without a region, areas of four circles, parallel periods, and rings that cross.
  const CROSSED = 'POLYGON ((0 0, 9 9, 9 0, 0 9))'
  it.each([
    [{ areas: '1 2 3' }, { areas: undefined }, 1],
    [{ region: SQUARE, areas: '1 2 3 4' }, { areas: undefined, region: expect.anything() }, 1],
    [{ lattice: '9 0 18 0' }, { lattice: undefined }, 1],
    [{ lattice: '9 0 18 0', region: SQUARE }, { lattice: undefined, region: expect.anything() }, 1],
    [{ region: CROSSED }, { region: undefined }, 1],
    [{ region: CROSSED, areas: '1 2 3' }, { region: undefined, areas: undefined }, 2],
  ])('%j is shown without the parts that are refused', async (given: Attributes, rest, count) => {
    const { element, circles, told, problem } = await shown({ circles: TEXT, ...given })
    expect(element).toMatchObject(rest)
    expect(circles()).toEqual(FLAT)
    expect(told().filter((name) => name === 'error')).toHaveLength(count)
    expect(problem()).not.toBe('')
    for (const name of ['lattice', 'areas', 'region']) element.removeAttribute(name)
    await settled(element)
    expect(problem()).toBe('')
  })

  it('follows each attribute and each property of an element that runs', async () => {
    const { element, properties } = await shown({ circles: TEXT, region: SQUARE })
    const square = (size: number) => ({ a: [size, 0], b: [0, size] })
    const read = (name: string) =>
      name === 'region' ? JSON.stringify(properties[name])?.match(/1[79]/)?.[0] : properties[name]
    for (const [name, attribute, property, said, own] of [
      ['areas', '1 2 3', [3, 2, 1], [1, 2, 3], [3, 2, 1]],
      ['region', SQUARE, [box(-9, -9, 17, 17)], '19', '17'],
      ['lattice', '30 0 0 30', square(40), square(30), square(40)],
    ] as const) {
      const seen: unknown[] = []
      for (const act of [
        () => element.setAttribute(name, attribute),
        () => Object.assign(element, { [name]: property }),
        () => Object.assign(element, { [name]: undefined }),
        () => Object.assign(element, { [name]: property }),
        () => element.setAttribute(name, attribute),
        () => element.removeAttribute(name),
      ]) {
        act()
        await settled(element)
        seen.push(read(name))
      }
      expect(seen, name).toEqual([said, own, said, own, said, undefined])
    }
  })
})

describe('the method', () => {
  it('follows the attribute, the property and the controls', async () => {
    const { element } = await shown()
    const seen: unknown[] = []
    for (const act of [
      () => element.setAttribute('step', '3'),
      () => element.removeAttribute('step'),
      () => Object.assign(element, { step: 5 }),
      () => element.setAttribute('controls', 'player'),
      () => Object.assign(element, { step: null }),
      () => element.removeAttribute('controls'),
      () => element.setAttribute('controls', 'player'),
      () => element.setAttribute('step', '2'),
      () => element.removeAttribute('controls'),
      () => Object.assign(element, { step: undefined }),
    ]) {
      act()
      seen.push(element.step)
    }
    expect(seen).toEqual([3, undefined, 5, 5, 0, undefined, 0, 2, 2, undefined])
    // Without a player, an attribute that is missing already takes a step of a reader away.
    await element.stepTo(7)
    element.step = undefined
    expect(element.step).toBeUndefined()
  })

  it('computes from scratch by the attributes, which must be right', async () => {
    const { element } = await shown()
    expect((await element.compute()).stats.method).toBe('auto')
    Object.assign(element, { method: 'touching-disc', samples: 7 })
    const { stats, certificate } = await element.compute()
    expect([stats.method, certificate.certified]).toEqual(['touching-disc', true])
    element.samples = 2000
    await expect(element.compute()).rejects.toMatchObject({ code: 'badOption', message: expect.stringMatching(/2000/) })
    for (const name of ['method', 'samples'] as const) {
      element.setAttribute(name, 'x')
      await expect(element.compute()).rejects.toMatchObject({ code: 'badInput' })
      element.removeAttribute(name)
    }
  })
})

describe('texts', () => {
  it('are in the language around the element, also across shadow roots, once it is in its page', () => {
    const { element, part } = made({})
    const host = document.createElement('div')
    host.lang = 'de-AT'
    const inside = document.createElement('section')
    host.attachShadow({ mode: 'open' }).append(inside)
    document.body.append(host)
    expect(part('.controls').lang).toBe('en')
    inside.append(element)
    expect(part('.controls').lang).toBe('de-AT')
    document.body.append(element)
    expect(part('.controls').lang).toBe('en')
  })
})

it('a page defines the element once, by each name with its own modules, and Node defines none', () => {
  const defined = new Map<string, typeof CircleVoronoiElement>()
  vi.stubGlobal('customElements', undefined)
  expect(() => defineCircleVoronoi()).not.toThrow()
  vi.stubGlobal('customElements', {
    get: (name: string) => defined.get(name),
    define: (name: string, element: typeof CircleVoronoiElement) => {
      expect(defined.has(name)).toBe(false)
      defined.set(name, element)
    },
  })
  const wasm = new Uint8Array()
  defineCircleVoronoi({ wasm })
  defineCircleVoronoi({ name: 'other-figure' })
  defineCircleVoronoi()
  expect([...defined].map(([name, { load }]) => [name, load])).toEqual([
    ['circle-voronoi', { wasm }],
    ['other-figure', {}],
  ])
  expect(new Set([...defined.values(), CircleVoronoiElement]).size).toBe(3)
})
