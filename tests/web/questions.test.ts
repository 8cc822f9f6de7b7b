// SPDX-License-Identifier: GPL-3.0-or-later
// The questions of the tutorial, on stub nodes.
import { expect, it } from 'vitest'
import { askQuestions } from '../../web/tutorial/questions.ts'

it('an answer is right or wrong until another one is chosen', () => {
  let chosen: string | null = null
  const output = { value: '' }
  const answer = { open: false }
  const parts: Readonly<Record<string, () => unknown>> = {
    output: () => output,
    'input:checked': () => (chosen === null ? null : { value: chosen }),
    'details.answer': () => answer,
  }
  const form = Object.assign(new EventTarget(), {
    dataset: { right: 'b' } as { readonly right: string; answered?: string },
    querySelector: (selector: string) => parts[selector]?.(),
  })
  askQuestions({ querySelectorAll: () => [form] } as unknown as ParentNode)
  const submit = () => {
    form.dispatchEvent(new Event('submit'))
    return [output.value, form.dataset.answered, answer.open]
  }
  const choose = (value: string) => {
    chosen = value
    form.dispatchEvent(new Event('change'))
    expect([output.value, form.dataset.answered]).toEqual(['', undefined])
  }
  expect(submit()).toEqual(['Choose an answer first.', '', false])
  choose('a')
  expect(submit()).toEqual([expect.stringMatching(/^Not quite\./), 'wrong', false])
  choose('b')
  expect(submit()).toEqual(['Right.', 'right', true])
  choose('a')
})
