// SPDX-License-Identifier: GPL-3.0-or-later
// The panel Share on the whole page: what is copied, sent, saved and asked.
// @vitest-environment happy-dom
import { beforeAll, beforeEach, describe, expect, it } from 'vitest'
import { KINDS } from '../../web/app/question/conditions.ts'
import { decodeLink } from '../../web/lib/link.ts'
import { DEFAULT_LAYERS } from '../../web/view/layers.ts'
import { all, chosenOf, control, controls, element, limitsOf, optionsOf, textOf } from './page-document.ts'
import { outputs } from './page-outputs.ts'
import { entered, FIVE, pressed, quiet, soon, wholePage } from './whole-page.ts'

let page: Awaited<ReturnType<typeof wholePage>>
let out: ReturnType<typeof outputs>
let panel: HTMLElement
const toast = () => (element('toast').hidden ? '' : textOf(element('toast')))

beforeAll(async () => {
  out = outputs()
  page = await wholePage()
  panel = await page.panel('share')
})
beforeEach(async () => {
  page.view.setLayers(DEFAULT_LAYERS)
  await page.open(FIVE)
  element('toast').hidden = true
})

/** The address in a text, and the state that its link opens. */
async function stateIn(text: string) {
  const [, address = '', link = ''] = /(?:"|^)([^"#\s]*)#(v1\.[\w-]+)/.exec(text) ?? []
  return { address, state: await decodeLink(link) }
}

describe('the panel Share', () => {
  it('warns of long texts, and refuses too many circles', async () => {
    const many = (count: number) =>
      Float64Array.from({ length: 3 * count }, (_, k) => (k % 3 === 2 ? 0.01 : (k * k) % 1009) + k / 7)
    await page.open(many(900))
    await pressed(panel, 'Copy link')
    expect((await out.text()).length).toBeGreaterThan(8000)
    await soon(() => expect(toast()).toMatch(/It has \d+,\d+ letters, and some programs cut long ones/))
  })

  it('says why there is no clip in a browser that records none', async () => {
    await pressed(panel, 'Record a video')
    await soon(() => expect(page.store.get().problem).not.toBe(''))
    expect(control(panel, 'Record a video').disabled).toBe(false)
    expect(page.editing.circles.circles()).toEqual(FIVE)
  })

  it('leaves circles and undo as they were where the browser stops recording', async () => {
    class Recorder {
      static isTypeSupported = () => true
      onerror = () => {}
      start() {
        setTimeout(() => this.onerror(), 100)
      }
      stop() {}
    }
    Object.assign(globalThis, { MediaRecorder: Recorder })
    await page.actions.circles.edit([{ kind: 'replace', id: 0, circle: [0, 0, 1] }])
    const { done } = page.store.get().history
    await pressed(panel, 'Record a video')
    await soon(() => expect(control(panel, 'Record a video').disabled).toBe(false))
    await quiet()
    expect([page.circle(0), page.circle(1)?.r]).toEqual([{ x: 0, y: 0, r: 1 }, 3])
    expect(page.store.get().history.done).toHaveLength(done.length)
    Reflect.deleteProperty(globalThis, 'MediaRecorder')
  })
})

describe('the form for a question', () => {
  const toggle = () => pressed(panel, 'Make a question')
  /** The frame that is copied now. */
  const frameNow = async () => {
    await pressed(panel, 'Copy question link')
    const { title, question, check, readonly, alt, lang } = (await stateIn(await out.text())).state
    return Object.fromEntries(
      Object.entries({ title, question, check, readonly, alt, lang }).filter(([, value]) => value !== undefined),
    )
  }
  const conditions = () => all(panel, '.condition')
  const now = () => [textOf(element('question-now')), element('question-now').className]

  beforeEach(async () => {
    if (controls(panel).has('Question')) await toggle()
    page.actions.selection.select([3])
    await quiet()
    await toggle()
    for (const label of ['Question', 'Title', 'Description for screen readers']) await entered(panel, label, '')
    await entered(panel, 'Readers may', 'edit')
    await entered(panel, 'Language', 'en')
    while (conditions().length > 0) await pressed(panel, 'Remove condition 1')
    await pressed(panel, 'Add a condition')
  })

  it('begins with a condition about the selected circle, or else about the first', async () => {
    expect([conditions().length, control(panel, 'Circle of condition 1').value]).toEqual([1, '3'])
    await pressed(panel, 'Remove condition 1')
    expect(now()).toEqual(['Without a condition, the frame shows the text alone.', 'quiet'])
    expect(await frameNow()).toEqual({})
    page.actions.selection.select([])
    await quiet()
    await toggle()
    expect(element('make-question').hidden).toBe(true)
    await toggle()
    expect(control(panel, 'Circle of condition 1').value).toBe('0')
  })

  it('takes a circle by a click, and rings the circles of its conditions as long as it is open', async () => {
    const choose = 'Choose the circle for condition 1 in the picture'
    const rings = () => all(document.body, '.rings > span:not(.gone)').map(textOf)
    expect(rings()).toEqual(['34 edges'])
    await pressed(panel, choose)
    expect(control(panel, choose).ariaPressed).toBe('true')
    expect(page.store.get().selection).toEqual([])
    page.actions.selection.select([2])
    await quiet()
    expect(control(panel, 'Circle of condition 1').value).toBe('2')
    expect(control(panel, choose).ariaPressed).toBe('false')
    expect(rings()).toEqual([expect.stringMatching(/^2\d edges$/)])
    // The next click selects as usual.
    page.actions.selection.select([1])
    await quiet()
    expect(control(panel, 'Circle of condition 1').value).toBe('2')
    await pressed(panel, choose)
    await pressed(panel, choose)
    page.actions.selection.select([0])
    await quiet()
    expect(control(panel, 'Circle of condition 1').value).toBe('2')
    await toggle()
    expect(rings()).toEqual([])
    await toggle()
  })

  it('asks for circles by the numbers that the frame gives them', async () => {
    await page.actions.circles.edit([{ kind: 'remove', id: 1 }])
    await quiet()
    expect(await frameNow()).toMatchObject({
      question: 'Move the circles until the cell of circle 2 has 3 edges.',
      check: { cell: 2, edges: 3 },
    })
  })

  it('has the fields of each kind of condition, and says its value now', async () => {
    const values: Record<string, string> = {
      'cell.edges': 'now 4',
      'cell.neighbors': 'now 4',
      'cell.neighbor': 'now 0, 1, 2, 4',
      'cell.bounded': 'now yes',
      'cell.hidden': 'now no',
      'cell.x': 'now 10',
      'cell.y': 'now 9',
      'cell.r': 'now 2',
      circles: 'now 5',
      hidden: 'now 0',
    }
    for (const { key, type, of, name } of KINDS) {
      await entered(panel, 'What condition 1 is about', key)
      const value = textOf(conditions()[0]?.querySelector('small'))
      expect([key, value]).toEqual([key, values[key] ?? expect.stringMatching(/^now [\d.]+$/)])
      expect(controls(panel).has('Circle of condition 1')).toBe(of === 'cell')
      const at = of === 'cell' ? { cell: 3 } : {}
      const expectCheck = async (expected: unknown) =>
        expect(await frameNow()).toMatchObject({ check: { ...at, [name]: expected } })
      if (type === 'flag') {
        await entered(panel, 'Value of condition 1', 'no')
        await expectCheck(false)
      } else if (type === 'circle') {
        await entered(panel, 'Neighbor of condition 1', '2')
        await expectCheck(2)
      } else {
        const comparisons = [...(type === 'measure' ? [] : ['exactly']), 'at least', 'at most', 'between']
        expect(optionsOf(control(panel, 'Comparison of condition 1'))).toEqual(comparisons)
        expect(limitsOf(control(panel, 'Value of condition 1'))[2]).toBe(type === 'count' ? '1' : 'any')
        await entered(panel, 'Comparison of condition 1', 'between')
        await entered(panel, 'Value of condition 1', '6')
        await entered(panel, 'Upper value of condition 1', '8', '')
        await expectCheck({ min: 6, max: 8 })
        await entered(panel, 'Comparison of condition 1', 'max')
        await expectCheck({ max: 6 })
        if (type !== 'measure') await entered(panel, 'Comparison of condition 1', 'is')
      }
    }
    await entered(panel, 'What condition 1 is about', 'cell.area')
    expect(chosenOf(control(panel, 'Comparison of condition 1')), 'areas are not compared exactly').toBe('at least')
    await entered(panel, 'Circle of condition 1', '0')
    expect(textOf(conditions()[0]?.querySelector('small'))).toBe('now infinite')
  })
})
