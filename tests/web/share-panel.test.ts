// SPDX-License-Identifier: GPL-3.0-or-later
// The panel for links, and its form for questions.
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import type { FileActions } from '../../web/app/files/file-actions.ts'
import { recordClip } from '../../web/app/motion/clip.ts'
import type { Motion } from '../../web/app/motion/motion.ts'
import type { PageActions } from '../../web/app/page-actions.ts'
import { mountShare } from '../../web/app/panels/share.ts'
import { KINDS } from '../../web/app/question/conditions.ts'
import type { Editing } from '../../web/editing/editing.ts'
import type { State } from '../../web/editing/state.ts'
import type { LinkFrame } from '../../web/lib/link.ts'
import { CircleTable } from '../../web/view/circle-table.ts'
import type { CellFacts, Facts } from '../../web/view/protocol.ts'
import type { View } from '../../web/view/view.ts'
import { noting, stateOf, stubPage } from './page-document.ts'

vi.mock('lit/html.js', async (load) => ({
  ...(await load<object>()),
  render: (await import('./page-document.ts')).render,
}))
vi.mock('../../web/app/motion/clip.ts', () => ({ recordClip: vi.fn() }))
const saved = vi.hoisted(() => [] as unknown[])
vi.mock('../../web/app/files/saving.ts', () => ({ save: (...what: unknown[]) => saved.push(what) }))

let stub: ReturnType<typeof stubPage>
beforeEach(() => {
  stub = stubPage()
  vi.stubGlobal('navigator', {})
  saved.length = 0
  vi.useFakeTimers()
})
afterEach(() => {
  vi.unstubAllGlobals()
  vi.useRealTimers()
})

const settled = async () => {
  for (let k = 0; k < 9; k++) await Promise.resolve()
}
const FACTS: CellFacts = {
  x: 1.25,
  y: -2,
  r: 0.5,
  hidden: false,
  bounded: true,
  edges: 4,
  neighbors: [5, 2],
  area: Number.POSITIVE_INFINITY,
  perimeter: 9,
}
const factsOf = (cell: Partial<CellFacts> = {}): Facts => ({
  circles: 3,
  hidden: 1,
  vertices: 7,
  edges: 9,
  cells: new Map([[1, { ...FACTS, ...cell }]]),
})

function mounted(frame?: LinkFrame, state: Partial<State> = {}) {
  const done: unknown[][] = []
  const { store, change } = stateOf(state)
  /** The lengths that copying resolves to. */
  const known: { length: number | undefined } = { length: 12 }
  const copy =
    (name: string) =>
    async (...values: unknown[]) => {
      done.push([name, ...values])
      return known.length
    }
  const files = noting(done, {
    copyLink: copy('copyLink'),
    copyEmbedCode: copy('copyEmbedCode'),
    copyElementCode: copy('copyElementCode'),
    copyQuestion: copy('copyQuestion'),
  })
  const answers: ((facts: Facts) => void)[] = []
  const asked: unknown[] = []
  const view = {
    ask: (_: string, ids: unknown) => {
      asked.push(ids)
      return new Promise((resolve) => answers.push(resolve))
    },
  }
  const editing = { circles: new CircleTable(Float64Array.of(0, 0, 1, 4, 0, 1, 0, 4, 1)) }
  const actions = noting(done, { frame })
  mountShare(
    files as unknown as FileActions,
    store,
    editing as unknown as Editing,
    view as unknown as View,
    actions as unknown as PageActions,
    'motion' as unknown as Motion,
    () => 8,
  )
  stub.element('share-button').click()
  const panel = stub.element('share')
  const answer = async (facts: Facts) => {
    for (const act of answers.splice(0)) act(facts)
    await settled()
  }
  const makeQuestion = () => panel.press('Make a question')
  /** The frame that is copied now. */
  const frameNow = async () => {
    panel.press('Copy question code')
    await settled()
    return done.pop()?.[2]
  }
  return { panel, done, change, known, answers, asked, answer, actions, makeQuestion, frameNow }
}

describe('the panel Share', () => {
  it.each([
    ['Copy link', 'copyLink', 'The link'],
    ['Copy embed code', 'copyEmbedCode', 'The code'],
    ['Copy element', 'copyElementCode', 'The code'],
  ])('has a button that copies: %s', async (label, name, what) => {
    const { panel, done, known } = mounted()
    const toast = stub.element('toast')
    panel.press(label)
    await settled()
    expect([done, toast.text]).toEqual([[[name]], `${what} is in the clipboard.`])
    known.length = 8001
    panel.press(label)
    await settled()
    expect(toast.text).toMatch(/It has 8,001 letters, and some programs cut long ones/)
    known.length = undefined
    toast.replaceChildren()
    panel.press(label)
    await settled()
    expect(toast.text, 'nothing was copied').toBe('')
  })

  it('sends a link where the browser can, and saves a card', () => {
    expect(mounted().panel.controls.has('Send')).toBe(false)
    vi.stubGlobal('navigator', { share() {} })
    const { panel, done } = mounted()
    panel.press('Send')
    panel.press('Save a card')
    expect(done).toEqual([['shareLink'], ['saveCard']])
  })

  it('records one clip at a time, and says what went wrong', async () => {
    const { panel, done } = mounted()
    const clip = () => panel.control('Record a clip')
    const film = { film: 'film', ending: '.webm' } as never
    for (const [result, expected] of [
      [() => film, [['film', 'circles-clip.webm']]],
      [() => undefined, []],
      [() => Promise.reject(new Error('no video')), []],
    ] as const) {
      saved.length = 0
      let end = () => {}
      const waiting = new Promise<void>((resolve) => {
        end = resolve
      })
      vi.mocked(recordClip).mockImplementation(() => waiting.then(result))
      expect([clip().disabled, clip().text]).toEqual([false, 'Clip'])
      clip().click()
      expect([clip().disabled, clip().text]).toEqual([true, 'Recording …'])
      end()
      await settled()
      expect([clip().disabled, clip().text]).toEqual([false, 'Clip'])
      expect(saved).toEqual(expected)
    }
    expect(done).toEqual([['complain', 'no video']])
    expect(vi.mocked(recordClip).mock.lastCall?.slice(3)).toEqual(['motion', 8])
  })
})

describe('the form for a question', () => {
  it('begins with a condition about the selected circle, or else about the first', async () => {
    for (const [selected, circle] of [
      [2, '2'],
      [undefined, '0'],
    ] as const) {
      const { panel, makeQuestion, asked } = mounted(undefined, { selected })
      expect([...panel.controls.keys()].some((label) => label.startsWith('Circle of'))).toBe(false)
      makeQuestion()
      expect(panel.control('Circle of condition 1').value).toBe(circle)
      expect(asked.at(-1)).toEqual([Number(circle)])
      expect(panel.control('Make a question').getAttribute('aria-expanded')).toBe('true')
      makeQuestion()
      expect(panel.control('Make a question').getAttribute('aria-expanded')).toBe('false')
      expect(stub.element('make-question').hidden).toBe(true)
      makeQuestion()
      expect(panel.controls.has('Circle of condition 2'), 'it has one already').toBe(false)
    }
  })

  it('sets what a link says of the frame, without what is empty', async () => {
    const { panel, makeQuestion, frameNow } = mounted(undefined, { selected: 1 })
    makeQuestion()
    const longest = ['Question', 'Title', 'Description for screen readers'].map((label) =>
      panel.control(label).getAttribute('maxlength'),
    )
    expect(longest).toEqual(['2000', '200', '200'])
    const check = { cell: 1, edges: 3 }
    expect(await frameNow()).toEqual({ question: 'Move the circles until the cell of circle 1 has 3 edges.', check })
    panel.enter('Question', ' Which? ', ['input'])
    panel.enter('Title', ' A title ', ['input'])
    panel.enter('Description for screen readers', ' alt ', ['input'])
    panel.enter('Readers may', 'look', ['change'])
    panel.enter('Language', 'de', ['change'])
    expect(await frameNow()).toEqual({
      title: 'A title',
      question: 'Which?',
      check,
      readonly: true,
      alt: 'alt',
      lang: 'de',
    })
    expect(panel.control('Readers may').chosen).toBe('only look')
    expect(panel.control('Language').chosen).toBe('German')
    expect(panel.control('Question').placeholder).toBe('Bewege die Kreise, bis die Zelle von Kreis 1 3 Kanten hat.')
    for (const label of ['Question', 'Title', 'Description for screen readers']) panel.enter(label, ' ', ['input'])
    panel.enter('Readers may', 'edit', ['change'])
    panel.enter('Language', 'en', ['change'])
    expect(Object.keys((await frameNow()) as object)).toEqual(['question', 'check'])
    expect(panel.control('Language').chosen).toBe('English')
    expect(panel.control('Readers may').chosen).toBe('edit circles')
    panel.press('Remove condition 1')
    expect(await frameNow()).toEqual({})
  })

  it('does with the question what its buttons say', async () => {
    const { panel, done, makeQuestion, known } = mounted()
    makeQuestion()
    const frame = { check: { cell: 0, edges: 3 }, question: expect.any(String) }
    const toast = stub.element('toast')
    for (const [label, said, ...call] of [
      ['Copy question code', 'The code of the question is in the clipboard.', 'copyQuestion', 'code'],
      ['Copy question link', 'The link of the question is in the clipboard.', 'copyQuestion', 'link'],
      ['SCORM file', '', 'saveCourse'],
      ['Worksheet', '', 'printWorksheet'],
      ['Try it', '', 'openQuestion'],
    ] as const) {
      toast.replaceChildren()
      panel.press(label)
      await settled()
      expect([done.pop(), toast.text]).toEqual([[...call, frame], said])
    }
    known.length = undefined
    panel.press('Copy question link')
    await settled()
    expect(toast.text).toBe('')
  })

  it('adds conditions, of which all or one must be met, and changes and removes each alone', async () => {
    const { panel, makeQuestion, frameNow } = mounted(undefined, { selected: 1 })
    makeQuestion()
    expect(panel.controls.has('How many conditions are needed')).toBe(false)
    panel.press('Add a condition')
    panel.enter('Circle of condition 2', '2', ['change'])
    const parts = [
      { cell: 1, edges: 3 },
      { cell: 2, edges: 3 },
    ]
    expect(await frameNow()).toMatchObject({ check: { all: parts } })
    panel.enter('How many conditions are needed', 'any', ['change'])
    expect(await frameNow()).toMatchObject({ check: { any: parts } })
    expect(panel.control('How many conditions are needed').chosen).toBe('one of these is met')
    panel.enter('How many conditions are needed', 'all', ['change'])
    expect(panel.control('How many conditions are needed').chosen).toBe('all of these are met')
    panel.press('Remove condition 1')
    expect(await frameNow()).toMatchObject({ check: parts[1] })
  })

  it('has the fields of each kind of condition, and says its value now', async () => {
    const { panel, makeQuestion, frameNow, answer } = mounted(undefined, { selected: 1 })
    makeQuestion()
    const now: Record<string, string> = {
      'cell.edges': 'now 4',
      'cell.neighbors': 'now 2',
      'cell.neighbor': 'now 2, 5',
      'cell.area': 'now infinite',
      'cell.bounded': 'now yes',
      'cell.hidden': 'now no',
      'cell.x': 'now 1.25',
      'cell.y': 'now -2',
      'cell.r': 'now 0.5',
      circles: 'now 3',
      hidden: 'now 1',
      vertices: 'now 7',
      edges: 'now 9',
    }
    for (const { key, label, type, of, name } of KINDS) {
      panel.enter('What condition 1 is about', key, ['change'])
      await answer(factsOf())
      const kinds = panel.control('What condition 1 is about')
      expect([kinds.chosen, kinds.options]).toEqual([label, KINDS.map(({ label }) => label)])
      expect(panel.querySelector('.condition')?.getAttribute('aria-label')).toBe('Condition 1')
      expect([key, panel.querySelector('.condition small')?.text]).toEqual([key, now[key]])
      expect(panel.controls.has('Circle of condition 1')).toBe(of === 'cell')
      const at = of === 'cell' ? { cell: 1 } : {}
      if (type === 'flag') {
        panel.enter('Value of condition 1', 'no', ['change'])
        expect(await frameNow()).toMatchObject({ check: { ...at, [name]: false } })
        expect(panel.control('Value of condition 1').chosen).toBe('no')
        panel.enter('Value of condition 1', 'yes', ['change'])
        expect(await frameNow()).toMatchObject({ check: { ...at, [name]: true } })
        expect(panel.control('Value of condition 1').chosen).toBe('yes')
      } else if (type === 'circle') {
        panel.enter('Neighbor of condition 1', '2', ['change'])
        expect(await frameNow()).toMatchObject({ check: { ...at, [name]: 2 } })
      } else {
        const comparisons = type === 'measure' ? [] : ['exactly']
        expect(panel.control('Comparison of condition 1').options).toEqual([
          ...comparisons,
          'at least',
          'at most',
          'between',
        ])
        expect(panel.control('Value of condition 1').limits[2]).toBe(type === 'count' ? '1' : 'any')
        panel.enter('Comparison of condition 1', 'between', ['change'])
        panel.enter('Value of condition 1', '6', ['change'])
        panel.enter('Upper value of condition 1', '8', ['change'])
        expect(await frameNow()).toMatchObject({ check: { ...at, [name]: { min: 6, max: 8 } } })
        expect(panel.control('Comparison of condition 1').chosen).toBe('between')
        panel.enter('Comparison of condition 1', 'max', ['change'])
        expect(await frameNow()).toMatchObject({ check: { ...at, [name]: { max: 6 } } })
        panel.enter('Comparison of condition 1', type === 'measure' ? 'min' : 'is', ['change'])
      }
    }
    // A measure cannot be compared exactly.
    panel.enter('What condition 1 is about', 'cell.area', ['change'])
    expect(panel.control('Comparison of condition 1').chosen).toBe('at least')
  })

  it('says the value of a cell without neighbors or of a circle that is hidden, and that there is no such circle', async () => {
    const { panel, makeQuestion, answer } = mounted(undefined, { selected: 1 })
    makeQuestion()
    const nowOf = async (kind: string, facts: Facts) => {
      panel.enter('What condition 1 is about', kind, ['change'])
      await answer(facts)
      return panel.querySelector('.condition small')?.text
    }
    expect(await nowOf('cell.neighbor', factsOf({ neighbors: [] }))).toBe('now none')
    expect(await nowOf('cell.bounded', factsOf({ bounded: false }))).toBe('now no')
    expect(await nowOf('cell.hidden', factsOf({ hidden: true }))).toBe('now yes')
    expect(await nowOf('cell.edges', { ...factsOf(), cells: new Map() })).toBe('no such circle')
  })

  it('gives a field its number again where an invalid one was entered', async () => {
    const { panel, makeQuestion, frameNow } = mounted(undefined, { selected: 1 })
    makeQuestion()
    panel.enter('Comparison of condition 1', 'between', ['change'])
    const before = await frameNow()
    for (const label of ['Circle of condition 1', 'Value of condition 1', 'Upper value of condition 1']) {
      const field = panel.control(label)
      const { value } = field
      field.isValid = false
      panel.enter(label, '-1', ['change'])
      expect([label, field.value]).toEqual([label, value])
    }
    expect(await frameNow()).toEqual(before)
    expect(panel.control('Circle of condition 1').limits).toEqual(['0', null, '1'])
  })

  it('says whether there is something to do', async () => {
    const { panel, makeQuestion, answer, frameNow } = mounted(undefined, { selected: 1 })
    makeQuestion()
    const now = () => [stub.element('question-now').text, [...stub.element('question-now').classList].join()]
    expect(now()).toEqual(['', 'quiet'])
    await answer(factsOf())
    expect(now()).toEqual(['The circles do not meet this yet, so there is something to do.', 'quiet'])
    panel.enter('Value of condition 1', '4', ['change'])
    await answer(factsOf())
    expect(now()).toEqual(['The circles meet this already. Move them, so that there is something to do.', 'wrong'])
    panel.enter('Value of condition 1', '5', ['change'])
    await answer(factsOf())
    panel.enter('Readers may', 'look', ['change'])
    expect(now()).toEqual(['Readers who may only look cannot solve this.', 'wrong'])
    panel.enter('Circle of condition 1', '9', ['change'])
    expect(now()).toEqual(['There is no circle 9.', 'wrong'])
    panel.press('Remove condition 1')
    expect(now()).toEqual(['Without a condition, the frame shows the text alone.', 'quiet'])
    expect(await frameNow()).toEqual({ readonly: true })
  })

  it('drops an answer about former conditions', async () => {
    const { panel, makeQuestion, answers } = mounted(undefined, { selected: 1 })
    makeQuestion()
    const [late, ...others] = answers.splice(0)
    expect(others).toHaveLength(1)
    panel.enter('Value of condition 1', '4', ['change'])
    late?.(factsOf())
    await settled()
    expect(panel.querySelector('.condition small')?.text).toBe('')
  })

  it('measures again after an edit while it is open', () => {
    const { makeQuestion, asked, change } = mounted(undefined, { selected: 1 })
    const edited = () => ({}) as State['edited']
    change({ edited: edited() })
    expect(asked).toEqual([])
    makeQuestion()
    const { length } = asked
    change({ selection: [1] })
    change({ edited: edited() })
    change({ selection: [] })
    expect(asked).toHaveLength(length + 2)
  })

  it('has the question of the opened link, also a check that it has no fields for, until another link is opened', async () => {
    const check = { not: { cell: 1, edges: 3 } }
    const frame: LinkFrame = { title: 'T', question: 'Q?', check, readonly: true, alt: 'A', lang: 'de-AT' }
    const { panel, actions, frameNow, asked, answer } = mounted(frame)
    await answer(factsOf())
    expect(panel.querySelector('code')?.text).toBe(JSON.stringify(check))
    expect(asked.at(-1)).toEqual([1])
    expect(await frameNow()).toEqual({ ...frame, lang: 'de' })
    panel.press('Add a condition')
    expect(await frameNow()).toMatchObject({ check: { all: [check, { cell: 0, edges: 3 }] } })
    panel.press('Remove this condition')
    expect(await frameNow()).toMatchObject({ check: { cell: 0, edges: 3 } })
    const again = () => {
      stub.element('share-button').click()
      stub.element('share-button').click()
    }
    again()
    expect(await frameNow(), 'kept').toMatchObject({ check: { cell: 0, edges: 3 }, title: 'T' })
    actions.frame = { title: 'Other', check: { any: [{ cell: 1, x: { min: 2 } }, { circles: 3 }] } }
    again()
    expect(await frameNow()).toEqual({ ...actions.frame, question: expect.stringMatching(/ or /) })
    actions.frame = undefined
    again()
    expect(await frameNow(), 'kept').toMatchObject({ title: 'Other' })
  })

  it.each([
    [{ title: 'T' }, true],
    [{ question: 'Q?' }, false],
    [{ check: { circles: 3 } }, false],
  ])('of %j is closed: %s', async (frame, isClosed) => {
    const { answer } = mounted(frame)
    await answer(factsOf())
    expect(stub.element('make-question').hidden).toBe(isClosed)
  })
})
