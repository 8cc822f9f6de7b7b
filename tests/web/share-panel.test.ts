// SPDX-License-Identifier: GPL-3.0-or-later
// The panel for links, and its form for questions.
// @vitest-environment happy-dom
import { nothing, render } from 'lit/html.js'
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
import {
  buttonOf,
  chosenOf,
  control,
  controls,
  element,
  enter,
  limitsOf,
  noting,
  openPage,
  optionsOf,
  press,
  stateOf,
  textOf,
} from './page-document.ts'
import { settled } from './turns.ts'

vi.mock('../../web/app/motion/clip.ts', () => ({ recordClip: vi.fn() }))
const saved = vi.hoisted(() => [] as unknown[])
vi.mock('../../web/app/files/saving.ts', () => ({ save: (...what: unknown[]) => saved.push(what) }))

beforeEach(() => {
  openPage()
  vi.stubGlobal('navigator', {})
  saved.length = 0
  vi.useFakeTimers()
})
afterEach(() => {
  vi.unstubAllGlobals()
  vi.useRealTimers()
})

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
  buttonOf('share').click()
  const panel = element('share')
  const answer = async (facts: Facts) => {
    for (const act of answers.splice(0)) act(facts)
    await settled()
  }
  const makeQuestion = () => press(panel, 'Make a question')
  /** The frame that is copied now. */
  const frameNow = async () => {
    press(panel, 'Copy question code')
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
    const toast = element('toast')
    press(panel, label)
    await settled()
    expect([done, textOf(toast)]).toEqual([[[name]], `${what} is in the clipboard.`])
    known.length = 8001
    press(panel, label)
    await settled()
    expect(textOf(toast)).toMatch(/It has 8,001 letters, and some programs cut long ones/)
    known.length = undefined
    render(nothing, toast)
    press(panel, label)
    await settled()
    expect(textOf(toast), 'nothing was copied').toBe('')
  })

  it('sends a link where the browser can, and saves a card', () => {
    expect(controls(mounted().panel).has('Send')).toBe(false)
    vi.stubGlobal('navigator', { share() {} })
    const { panel, done } = mounted()
    press(panel, 'Send')
    press(panel, 'Save a card')
    expect(done).toEqual([['shareLink'], ['saveCard']])
  })

  it('records one clip at a time, and says what went wrong', async () => {
    const { panel, done } = mounted()
    const clip = () => control(panel, 'Record a clip')
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
      expect([clip().disabled, textOf(clip())]).toEqual([false, 'Clip'])
      clip().click()
      expect([clip().disabled, textOf(clip())]).toEqual([true, 'Recording …'])
      end()
      await settled()
      expect([clip().disabled, textOf(clip())]).toEqual([false, 'Clip'])
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
      expect([...controls(panel).keys()].some((label) => label.startsWith('Circle of'))).toBe(false)
      makeQuestion()
      expect(control(panel, 'Circle of condition 1').value).toBe(circle)
      expect(asked.at(-1)).toEqual([Number(circle)])
      expect(control(panel, 'Make a question').getAttribute('aria-expanded')).toBe('true')
      makeQuestion()
      expect(control(panel, 'Make a question').getAttribute('aria-expanded')).toBe('false')
      expect(element('make-question').hidden).toBe(true)
      makeQuestion()
      expect(controls(panel).has('Circle of condition 2'), 'it has one already').toBe(false)
    }
  })

  it('sets what a link says of the frame, without what is empty', async () => {
    const { panel, makeQuestion, frameNow } = mounted(undefined, { selected: 1 })
    makeQuestion()
    const longest = ['Question', 'Title', 'Description for screen readers'].map((label) =>
      control(panel, label).getAttribute('maxlength'),
    )
    expect(longest).toEqual(['2000', '200', '200'])
    const check = { cell: 1, edges: 3 }
    expect(await frameNow()).toEqual({ question: 'Move the circles until the cell of circle 1 has 3 edges.', check })
    enter(panel, 'Question', ' Which? ', ['input'])
    enter(panel, 'Title', ' A title ', ['input'])
    enter(panel, 'Description for screen readers', ' alt ', ['input'])
    enter(panel, 'Readers may', 'look', ['change'])
    enter(panel, 'Language', 'de', ['change'])
    expect(await frameNow()).toEqual({
      title: 'A title',
      question: 'Which?',
      check,
      readonly: true,
      alt: 'alt',
      lang: 'de',
    })
    expect(chosenOf(control(panel, 'Readers may'))).toBe('only look')
    expect(chosenOf(control(panel, 'Language'))).toBe('German')
    expect(control(panel, 'Question').placeholder).toBe('Bewege die Kreise, bis die Zelle von Kreis 1 3 Kanten hat.')
    for (const label of ['Question', 'Title', 'Description for screen readers']) enter(panel, label, ' ', ['input'])
    enter(panel, 'Readers may', 'edit', ['change'])
    enter(panel, 'Language', 'en', ['change'])
    expect(Object.keys((await frameNow()) as object)).toEqual(['question', 'check'])
    expect(chosenOf(control(panel, 'Language'))).toBe('English')
    expect(chosenOf(control(panel, 'Readers may'))).toBe('edit circles')
    press(panel, 'Remove condition 1')
    expect(await frameNow()).toEqual({})
  })

  it('does with the question what its buttons say', async () => {
    const { panel, done, makeQuestion, known } = mounted()
    makeQuestion()
    const frame = { check: { cell: 0, edges: 3 }, question: expect.any(String) }
    const toast = element('toast')
    for (const [label, said, ...call] of [
      ['Copy question code', 'The code of the question is in the clipboard.', 'copyQuestion', 'code'],
      ['Copy question link', 'The link of the question is in the clipboard.', 'copyQuestion', 'link'],
      ['SCORM file', '', 'saveCourse'],
      ['Worksheet', '', 'printWorksheet'],
      ['Try it', '', 'openQuestion'],
    ] as const) {
      render(nothing, toast)
      press(panel, label)
      await settled()
      expect([done.pop(), textOf(toast)]).toEqual([[...call, frame], said])
    }
    known.length = undefined
    press(panel, 'Copy question link')
    await settled()
    expect(textOf(toast)).toBe('')
  })

  it('adds conditions, of which all or one must be met, and changes and removes each alone', async () => {
    const { panel, makeQuestion, frameNow } = mounted(undefined, { selected: 1 })
    makeQuestion()
    expect(controls(panel).has('How many conditions are needed')).toBe(false)
    press(panel, 'Add a condition')
    enter(panel, 'Circle of condition 2', '2', ['change'])
    const parts = [
      { cell: 1, edges: 3 },
      { cell: 2, edges: 3 },
    ]
    expect(await frameNow()).toMatchObject({ check: { all: parts } })
    enter(panel, 'How many conditions are needed', 'any', ['change'])
    expect(await frameNow()).toMatchObject({ check: { any: parts } })
    expect(chosenOf(control(panel, 'How many conditions are needed'))).toBe('one of these is met')
    enter(panel, 'How many conditions are needed', 'all', ['change'])
    expect(chosenOf(control(panel, 'How many conditions are needed'))).toBe('all of these are met')
    press(panel, 'Remove condition 1')
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
      enter(panel, 'What condition 1 is about', key, ['change'])
      await answer(factsOf())
      const kinds = control(panel, 'What condition 1 is about')
      expect([chosenOf(kinds), optionsOf(kinds)]).toEqual([label, KINDS.map(({ label }) => label)])
      expect(panel.querySelector('.condition')?.getAttribute('aria-label')).toBe('Condition 1')
      expect([key, textOf(panel.querySelector('.condition small'))]).toEqual([key, now[key]])
      expect(controls(panel).has('Circle of condition 1')).toBe(of === 'cell')
      const at = of === 'cell' ? { cell: 1 } : {}
      if (type === 'flag') {
        enter(panel, 'Value of condition 1', 'no', ['change'])
        expect(await frameNow()).toMatchObject({ check: { ...at, [name]: false } })
        expect(chosenOf(control(panel, 'Value of condition 1'))).toBe('no')
        enter(panel, 'Value of condition 1', 'yes', ['change'])
        expect(await frameNow()).toMatchObject({ check: { ...at, [name]: true } })
        expect(chosenOf(control(panel, 'Value of condition 1'))).toBe('yes')
      } else if (type === 'circle') {
        enter(panel, 'Neighbor of condition 1', '2', ['change'])
        expect(await frameNow()).toMatchObject({ check: { ...at, [name]: 2 } })
      } else {
        const comparisons = type === 'measure' ? [] : ['exactly']
        expect(optionsOf(control(panel, 'Comparison of condition 1'))).toEqual([
          ...comparisons,
          'at least',
          'at most',
          'between',
        ])
        expect(limitsOf(control(panel, 'Value of condition 1'))[2]).toBe(type === 'count' ? '1' : 'any')
        enter(panel, 'Comparison of condition 1', 'between', ['change'])
        enter(panel, 'Value of condition 1', '6', ['change'])
        enter(panel, 'Upper value of condition 1', '8', ['change'])
        expect(await frameNow()).toMatchObject({ check: { ...at, [name]: { min: 6, max: 8 } } })
        expect(chosenOf(control(panel, 'Comparison of condition 1'))).toBe('between')
        enter(panel, 'Comparison of condition 1', 'max', ['change'])
        expect(await frameNow()).toMatchObject({ check: { ...at, [name]: { max: 6 } } })
        enter(panel, 'Comparison of condition 1', type === 'measure' ? 'min' : 'is', ['change'])
      }
    }
    // A measure cannot be compared exactly.
    enter(panel, 'What condition 1 is about', 'cell.area', ['change'])
    expect(chosenOf(control(panel, 'Comparison of condition 1'))).toBe('at least')
  })

  it('says the value of a cell without neighbors or of a circle that is hidden, and that there is no such circle', async () => {
    const { panel, makeQuestion, answer } = mounted(undefined, { selected: 1 })
    makeQuestion()
    const nowOf = async (kind: string, facts: Facts) => {
      enter(panel, 'What condition 1 is about', kind, ['change'])
      await answer(facts)
      return textOf(panel.querySelector('.condition small'))
    }
    expect(await nowOf('cell.neighbor', factsOf({ neighbors: [] }))).toBe('now none')
    expect(await nowOf('cell.bounded', factsOf({ bounded: false }))).toBe('now no')
    expect(await nowOf('cell.hidden', factsOf({ hidden: true }))).toBe('now yes')
    expect(await nowOf('cell.edges', { ...factsOf(), cells: new Map() })).toBe('no such circle')
  })

  it('gives a field its number again where an invalid one was entered', async () => {
    const { panel, makeQuestion, frameNow } = mounted(undefined, { selected: 1 })
    makeQuestion()
    enter(panel, 'Comparison of condition 1', 'between', ['change'])
    const before = await frameNow()
    for (const label of ['Circle of condition 1', 'Value of condition 1', 'Upper value of condition 1']) {
      const field = control(panel, label)
      const { value } = field
      enter(panel, label, '', ['change'])
      expect([label, field.value]).toEqual([label, value])
    }
    expect(await frameNow()).toEqual(before)
    expect(limitsOf(control(panel, 'Circle of condition 1'))).toEqual(['0', null, '1'])
  })

  it('says whether there is something to do', async () => {
    const { panel, makeQuestion, answer, frameNow } = mounted(undefined, { selected: 1 })
    makeQuestion()
    const now = () => [textOf(element('question-now')), [...element('question-now').classList].join()]
    expect(now()).toEqual(['', 'quiet'])
    await answer(factsOf())
    expect(now()).toEqual(['The circles do not meet this yet, so there is something to do.', 'quiet'])
    enter(panel, 'Value of condition 1', '4', ['change'])
    await answer(factsOf())
    expect(now()).toEqual(['The circles meet this already. Move them, so that there is something to do.', 'wrong'])
    enter(panel, 'Value of condition 1', '5', ['change'])
    await answer(factsOf())
    enter(panel, 'Readers may', 'look', ['change'])
    expect(now()).toEqual(['Readers who may only look cannot solve this.', 'wrong'])
    enter(panel, 'Circle of condition 1', '9', ['change'])
    expect(now()).toEqual(['There is no circle 9.', 'wrong'])
    press(panel, 'Remove condition 1')
    expect(now()).toEqual(['Without a condition, the frame shows the text alone.', 'quiet'])
    expect(await frameNow()).toEqual({ readonly: true })
  })

  it('drops an answer about former conditions', async () => {
    const { panel, makeQuestion, answers } = mounted(undefined, { selected: 1 })
    makeQuestion()
    const [late, ...others] = answers.splice(0)
    expect(others).toHaveLength(1)
    enter(panel, 'Value of condition 1', '4', ['change'])
    late?.(factsOf())
    await settled()
    expect(textOf(panel.querySelector('.condition small'))).toBe('')
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
    expect(textOf(panel.querySelector('code'))).toBe(JSON.stringify(check))
    expect(asked.at(-1)).toEqual([1])
    const chosen = (...labels: string[]) => labels.map((label) => chosenOf(control(panel, label)))
    expect(chosen('Readers may', 'Language')).toEqual(['only look', 'German'])
    const fields = ['Question', 'Title', 'Description for screen readers']
    expect(fields.map((label) => control(panel, label).value)).toEqual(['Q?', 'T', 'A'])
    expect(await frameNow()).toEqual({ ...frame, lang: 'de' })
    press(panel, 'Add a condition')
    expect(await frameNow()).toMatchObject({ check: { all: [check, { cell: 0, edges: 3 }] } })
    press(panel, 'Remove this condition')
    expect(await frameNow()).toMatchObject({ check: { cell: 0, edges: 3 } })
    const again = () => {
      buttonOf('share').click()
      buttonOf('share').click()
    }
    again()
    expect(await frameNow(), 'kept').toMatchObject({ check: { cell: 0, edges: 3 }, title: 'T' })
    actions.frame = {
      title: 'Other',
      check: {
        any: [
          { cell: 1, x: { max: 2 } },
          { cell: 1, bounded: false },
        ],
      },
    }
    again()
    expect(await frameNow()).toEqual({ ...actions.frame, question: expect.stringMatching(/ or /) })
    await answer(factsOf())
    const kinds = [1, 2].map((k) => `What condition ${k} is about`)
    expect(chosen('Readers may', 'Language', 'How many conditions are needed', ...kinds)).toEqual([
      'edit circles',
      'English',
      'one of these is met',
      ...['x', 'bounded'].map((kind) => KINDS.find(({ name }) => name === kind)?.label),
    ])
    expect(chosen('Comparison of condition 1', 'Value of condition 2')).toEqual(['at most', 'no'])
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
    expect(element('make-question').hidden).toBe(isClosed)
  })
})
