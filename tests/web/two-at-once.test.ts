// SPDX-License-Identifier: GPL-3.0-or-later
// Concurrent operations in parts of the page, and their cleanup, without a browser.
import type { TemplateResult } from 'lit/html.js'
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import type { FileActions } from '../../web/app/files/file-actions.ts'
import type { PageActions } from '../../web/app/page-actions.ts'
import { mountFiles } from '../../web/app/panels/files.ts'
import { mountNumbers } from '../../web/app/panels/numbers.ts'
import { QuestionForm } from '../../web/app/panels/question.ts'
import { mountTable } from '../../web/app/panels/table.ts'
import { CircleGrid } from '../../web/app/table/circle-grid.ts'
import { NO_ATTRIBUTES } from '../../web/editing/attributes.ts'
import type { Check } from '../../web/lib/link.ts'
import { aTurn, editingSession, sceneOf } from './editing-session.ts'

/** The contents of the open panel. */
let body: () => unknown = () => undefined
let onopen: () => void = () => {}
/** Draws the open panel again. */
let redraw: () => void = () => {}
vi.mock('../../web/app/panels/by-id.ts', () => ({
  byId: () => ({ querySelector: () => null, querySelectorAll: () => [] }),
}))
vi.mock('../../web/app/panels/panel.ts', () => ({
  panelOf: (_: unknown, __: string, draw: () => void, options: { onopen?: () => void } = {}) => {
    redraw = draw
    onopen = options.onopen ?? (() => {})
    return {
      isOpen: true,
      render: (made: () => unknown) => {
        body = made
      },
    }
  },
}))
vi.mock('../../web/app/panels/histogram.ts', () => ({ Histogram: class {} }))
/** The rows to which the grid has scrolled. */
let rows: number[] = []
let grids = 0
let canceled = 0
vi.mock('../../web/app/table/grid.ts', () => ({
  Grid: class {
    isEditing = false
    constructor() {
      grids += 1
    }
    render() {}
    goTo(row: number) {
      rows.push(row)
    }
    cancelEdit() {
      canceled += 1
    }
    scrollToTop() {}
    dispose() {}
  },
}))

/** All values in a template and its nested templates. */
function valuesIn(template: unknown): unknown[] {
  if (Array.isArray(template)) return template.flatMap(valuesIn)
  const { strings, values } = (template ?? {}) as Partial<TemplateResult>
  return strings === undefined
    ? [typeof template === 'symbol' ? '' : template]
    : [...strings, ...(values ?? []).flatMap(valuesIn)]
}

/** All strings and values of a template and its nested templates, in their order. */
function partsOf(template: unknown): unknown[] {
  if (Array.isArray(template)) return template.flatMap(partsOf)
  const { strings, values } = (template ?? {}) as Partial<TemplateResult>
  return strings?.flatMap((text, k) => [text, ...partsOf(values?.[k])]) ?? [template]
}

/** The listener of the button with a label. */
function clickOf(template: unknown, label: string): () => void {
  const parts = partsOf(template)
  const place = parts.findIndex((part) => typeof part === 'string' && part.includes(label))
  const isFunction = (part: unknown) => typeof part === 'function'
  const isInside = (parts[place] as string).endsWith('@click=')
  return (isInside ? parts[place + 1] : parts.slice(0, place).findLast(isFunction)) as () => void
}

let frames: (() => void)[] = []
const draw = () => {
  const due = frames
  frames = []
  for (const frame of due) frame()
}
afterEach(() => vi.useRealTimers())
beforeEach(() => {
  frames = []
  vi.stubGlobal('HTMLElement', class {})
  vi.stubGlobal('requestAnimationFrame', (frame: () => void) => frames.push(frame))
})

async function started() {
  const { store, editing, actions, view, fake } = editingSession()
  const answers: ((answer: unknown) => void)[] = []
  fake.ask = () => new Promise((resolve) => answers.push(resolve))
  await editing.open(sceneOf(Float64Array.from({ length: 30 }, (_, k) => (k % 3 === 2 ? 1 : 5 * k))))
  draw()
  return { store, editing, actions, view, answers }
}

describe('numbers', () => {
  const distribution = (median: number, areas = [1]) => ({
    degrees: Int32Array.of(0, 1, 3),
    areas: Int32Array.from(areas),
    areaStep: 2,
    medianArea: median,
    certificate: { certified: true },
  })

  it.each([
    [[1], 'Area of the bounded cell: 1.5'],
    [[2], 'Areas of bounded cells: half are below 1.5'],
    [[2, 1, 1], 'Areas of bounded cells: half are below 1.5; the last bar: above 4'],
  ])('say how areas and neighbors are distributed: %o', async (areas, sentence) => {
    vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] })
    const { store, view, answers } = await started()
    mountNumbers(store, view)
    onopen()
    await vi.advanceTimersByTimeAsync(1000)
    answers[0]?.(distribution(1.5, areas))
    await vi.advanceTimersByTimeAsync(0)
    const shown = valuesIn(body())
    expect(shown).toContain(sentence)
    expect(shown).toContain('1.75')
    expect(shown).toContain(`Histogram of areas up to ${2 * (areas.length - 1)}; larger ones are in the last bar`)
  })

  it('of circles that have changed since they were asked for are not shown', async () => {
    // The test draws the frames with `draw`.
    vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] })
    const { store, editing, view, answers } = await started()
    mountNumbers(store, view)
    onopen()
    await vi.advanceTimersByTimeAsync(1000)
    expect(answers).toHaveLength(1)
    await editing.edit([{ kind: 'remove', id: 3 }])
    draw()
    const shown = () => valuesIn(body()).join(' ')
    expect(shown()).toContain('Circles 9')
    answers[0]?.(distribution(1234))
    await vi.advanceTimersByTimeAsync(0)
    expect(shown()).not.toContain('1230')
    expect(shown()).toContain('Counting')
    await vi.advanceTimersByTimeAsync(1000)
    expect(answers).toHaveLength(2)
    answers[1]?.(distribution(5678))
    await vi.advanceTimersByTimeAsync(0)
    expect(shown()).toContain('5680')
    await editing.edit([{ kind: 'remove', id: 4 }])
    draw()
    expect(shown()).toContain('Counting')
    expect(shown()).not.toContain('5680')
  })

  it('of a method are forgotten where the circles have changed since', async () => {
    const { store, editing, view, answers } = await started()
    mountNumbers(store, view)
    const compute = valuesIn(body()).find(
      (value) => typeof value === 'function' && value.name === 'compute',
    ) as () => void
    compute()
    await editing.edit([{ kind: 'remove', id: 3 }])
    draw()
    answers.at(-1)?.({ problem: 'It is refused.' })
    await aTurn()
    expect(valuesIn(body()).join(' ')).not.toContain('It is refused.')
    compute()
    answers.at(-1)?.({ problem: 'It is refused.' })
    await aTurn()
    expect(valuesIn(body()).join(' ')).toContain('It is refused.')
    await editing.edit([{ kind: 'remove', id: 4 }])
    draw()
    expect(valuesIn(body()).join(' ')).not.toContain('It is refused.')
  })
})

it('the same file can be chosen twice: the field forgets it', async () => {
  const opened: unknown[] = []
  mountFiles({ openFile: async (file: unknown) => opened.push(file) } as never)
  const open = valuesIn(body()).find((value) => typeof value === 'function' && value.name === 'open') as (
    event: object,
  ) => Promise<void>
  const target = { files: ['a file'], value: 'C:\\fakepath\\a.csv' }
  await open({ target })
  expect([opened, target.value]).toEqual([['a file'], ''])
})

it('a picture is saved at the last valid size', () => {
  const scales: unknown[] = []
  mountFiles({ savePicture: (_: unknown, scale: number) => scales.push(scale) } as never)
  const rescale = valuesIn(body()).find((value) => typeof value === 'function' && value.name === 'rescale') as (
    event: object,
  ) => void
  for (const [valueAsNumber, isValid, shown] of [
    [3, true, '3'],
    [-1, false, '3'],
  ] as const) {
    const target = { valueAsNumber, value: String(valueAsNumber), reportValidity: () => isValid }
    rescale({ target })
    clickOf(body(), 'Save a picture as you see it')()
    expect([target.value, scales.at(-1)]).toEqual([shown, 3])
  }
})

describe('the table', () => {
  async function tableOf() {
    const session = await started()
    const { store, editing, actions, view } = session
    const element = { style: { setProperty() {} }, classList: { toggle() {} } } as unknown as HTMLElement
    const grid = new CircleGrid(element, store, editing, actions as never, view)
    store.subscribe((state) => grid.update(state))
    rows = []
    return { ...session, grid }
  }

  it('selects with Shift from the circle that was selected last, also in the picture', async () => {
    const { store, actions, grid } = await tableOf()
    grid.choose(1, 'only')
    draw()
    actions.select([6])
    draw()
    grid.choose(8, 'through')
    expect(store.get().selection).toEqual([6, 7, 8])
    grid.choose(2, 'toggle')
    draw()
    grid.choose(1, 'through')
    expect(store.get().selection).toEqual([1, 2])
  })

  it('scrolls to circles that are selected in the picture, not to its own', async () => {
    const { actions, grid } = await tableOf()
    grid.choose(1, 'only')
    draw()
    expect(rows).toEqual([])
    actions.select([6])
    draw()
    expect(rows).toEqual([6])
  })

  it('shows no measures of circles that others have replaced', async () => {
    const { editing, answers, grid } = await tableOf()
    const area = grid.headings.findIndex(({ name }) => name === 'area')
    grid.seen(0, 1)
    answers.shift()?.({ ids: Int32Array.of(0, 1), columns: [[5], [6], [7]].map((column) => [...column, 1]) })
    await aTurn()
    expect(grid.cell(0, area).text).toBe('5')
    await editing.open(sceneOf(Float64Array.of(0, 0, 1, 9, 9, 1)))
    draw()
    expect(grid.cell(0, area).text).toBe('')
  })

  it('is sorted by the column that was chosen last, whichever is measured first', async () => {
    const { answers, grid } = await tableOf()
    const columnOf = (name: string) => grid.headings.findIndex((heading) => heading.name === name)
    const ids = Int32Array.from({ length: 10 }, (_, id) => id)
    const sorted = ['area', 'nbrs'].map((name) => grid.sort(columnOf(name)))
    const [byArea, byDegree] = answers.splice(-2)
    byDegree?.({ ids, columns: [Array.from(ids, (id) => 10 - id)] })
    byArea?.({ ids, columns: [Array.from(ids)] })
    await Promise.all(sorted)
    expect([grid.idOf(0), grid.sortOf(columnOf('nbrs'))]).toEqual([9, 'ascending'])
  })

  it('takes pasted lines into a column of texts, one for each row, as one step', async () => {
    const { editing, grid } = await tableOf()
    const name = grid.headings.findIndex(({ isText }) => isText)
    const names = () => Array.from({ length: 10 }, (_, id) => grid.written(id, name)).join()
    await grid.paste(8, name, 'd\ne\nf')
    expect(names()).toBe(',,,,,,,,d,e')
    await grid.paste(6, name, 'a; b\r\nc\r\n')
    expect(names()).toBe(',,,,,,a; b,c,d,e')
    await editing.undo()
    expect(names()).toBe(',,,,,,,,d,e')
  })

  it('ends the edit of a cell where other circles are opened, not where a circle is edited', async () => {
    const { editing } = await tableOf()
    canceled = 0
    await editing.edit([{ kind: 'remove', id: 3 }])
    draw()
    expect(canceled).toBe(0)
    await editing.open(sceneOf(Float64Array.of(0, 0, 1, 9, 9, 1)))
    draw()
    expect(canceled).toBe(1)
  })

  it('is made once, however often its panel is drawn, and anew for other columns', async () => {
    const { store, editing, actions, view } = await started()
    const place = { style: { setProperty() {} }, classList: { toggle() {} } }
    vi.stubGlobal('document', { getElementById: () => place })
    grids = 0
    mountTable(store, editing, actions as never, view)
    for (let k = 0; k < 3; k++) redraw()
    await vi.waitFor(() => expect(grids).toBe(1))
    await aTurn()
    redraw()
    await aTurn()
    expect(grids).toBe(1)
    const columns = [{ name: 'town', values: ['"A"'] }]
    await editing.open({ ...sceneOf(Float64Array.of(0, 0, 1)), attributes: { ...NO_ATTRIBUTES, columns } })
    draw()
    await vi.waitFor(() => expect(grids).toBe(2))
  })
})

describe('the form of a question', () => {
  const factsOf = (circles: number) => ({ circles, vertices: 0, edges: 0, hidden: 0, cells: new Map() })

  async function formOf(check: Check) {
    const session = await started()
    const { store, editing, view, actions } = session
    const page = Object.assign(actions, { frame: { question: 'Q?', check } })
    const form = new QuestionForm(store, editing, view, {} as FileActions, page as unknown as PageActions, () => {})
    form.take()
    const shown = () => valuesIn(form.body()).join(' ')
    return { ...session, form, shown }
  }

  it('says whether the circles meet the check, as soon as what it is about is known', async () => {
    const { answers, form, shown } = await formOf({ not: { circles: 5 } })
    answers[0]?.(factsOf(5))
    await aTurn()
    expect(shown()).toContain('do not meet this yet')
    clickOf(form.body(), 'Add a condition')()
    // Removes the other part of the check before the answer has come.
    clickOf(form.body(), 'Remove this condition')()
    const cells = new Map([[0, { edges: 3, neighbors: [] }]])
    for (const answer of answers.slice(1)) answer({ ...factsOf(10), cells })
    await aTurn()
    expect(shown()).toContain('meet this already')
    expect(shown()).toContain('now 3')
  })
})

it('an old problem and an old description are gone once something else is selected', async () => {
  const { store, actions } = await started()
  store.update((state) => ({ ...state, described: { id: 1 } as never }))
  actions.complain('The radius must not be negative.')
  actions.select([2])
  expect([store.get().problem, store.get().described]).toEqual(['', undefined])
})
