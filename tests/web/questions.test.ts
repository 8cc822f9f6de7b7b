// SPDX-License-Identifier: GPL-3.0-or-later
// The questions of the tutorial.
// @vitest-environment happy-dom
import { expect, it } from 'vitest'
import { askQuestions } from '../../web/tutorial/questions.ts'
import { make, send } from './page-document.ts'

it('an answer is right or wrong until another one is chosen', () => {
  const choices = ['a', 'b'].map((value) => make('input', { type: 'radio', name: 'q', value }))
  const output = make('output')
  const answer = make('details', { className: 'answer' })
  const form = make('form', { className: 'question' }, ...choices, output, answer)
  form.dataset.right = 'b'
  document.body.replaceChildren(form)
  askQuestions(document)
  let solved = 0
  document.body.addEventListener('solved', () => {
    solved += 1
  })
  const submit = () => {
    send(form, 'submit')
    return [output.value, form.dataset.answered, answer.open]
  }
  const choose = (value: string) => {
    for (const choice of choices) choice.checked = choice.value === value
    send(form, 'change')
    expect([output.value, form.dataset.answered]).toEqual(['', undefined])
  }
  expect(submit()).toEqual(['Choose an answer first.', '', false])
  choose('a')
  expect(submit()).toEqual([expect.stringMatching(/^Not quite\./), 'wrong', false])
  choose('b')
  expect(solved).toBe(0)
  expect(submit()).toEqual(['Right.', 'right', true])
  expect(solved).toBe(1)
  choose('a')
})
