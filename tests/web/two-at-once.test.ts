// SPDX-License-Identifier: GPL-3.0-or-later
// Concurrent operations in parts of the page, and their cleanup, without a browser.
import type { TemplateResult } from 'lit/html.js'
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { mountFiles } from '../../web/app/panels/files.ts'
import { mountNumbers } from '../../web/app/panels/numbers.ts'
import { CircleGrid } from '../../web/app/table/circle-grid.ts'
import { aTurn, editingSession, sceneOf } from './editing-session.ts'

/** The contents of the open panel. */
let body: () => unknown = () => undefined
let onopen: () => void = () => {}
vi.mock('../../web/app/panels/by-id.ts', () => ({
  byId: () => ({ querySelector: () => null, querySelectorAll: () => [] }),
}))
vi.mock('../../web/app/panels/panel.ts', () => ({
  panelOf: (_: unknown, __: string, ___: () => void, options: { onopen?: () => void } = {}) => {
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
vi.mock('../../web/app/table/grid.ts', () => ({
  Grid: class {
    isEditing = false
    render() {}
    goTo(row: number) {
      rows.push(row)
    }
    cancelEdit() {}
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
  const distribution = (median: number) => ({
    degrees: Int32Array.of(0, 1),
    areas: Int32Array.of(1),
    areaStep: 1,
    medianArea: median,
    certificate: { certified: true },
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
})

it('an old problem and an old description are gone once something else is selected', async () => {
  const { store, actions } = await started()
  store.update((state) => ({ ...state, described: { id: 1 } as never }))
  actions.complain('The radius must not be negative.')
  actions.select([2])
  expect([store.get().problem, store.get().described]).toEqual(['', undefined])
})
