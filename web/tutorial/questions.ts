// SPDX-License-Identifier: GPL-3.0-or-later

const RIGHT = 'Right.'
const WRONG = 'Not quite. Think again, or look at the hint.'
const NOTHING = 'Choose an answer first.'

/** Gives feedback on the answers of multiple-choice questions. */
export function askQuestions(page: ParentNode): void {
  for (const form of page.querySelectorAll<HTMLFormElement>('form.question')) {
    const output = form.querySelector('output') as HTMLOutputElement
    form.addEventListener('submit', (event) => {
      event.preventDefault()
      const chosen = form.querySelector<HTMLInputElement>('input:checked')
      const isRight = chosen?.value === form.dataset.right
      output.value = chosen === null ? NOTHING : isRight ? RIGHT : WRONG
      form.dataset.answered = chosen === null ? '' : isRight ? 'right' : 'wrong'
      const answer = form.querySelector<HTMLDetailsElement>('details.answer')
      if (!isRight) return
      if (answer !== null) answer.open = true
      form.dispatchEvent(new Event('solved', { bubbles: true }))
    })
    form.addEventListener('change', () => {
      output.value = ''
      delete form.dataset.answered
    })
  }
}
