// SPDX-License-Identifier: GPL-3.0-or-later
// Buttons in the text show a stage of the method.
const figure = document.querySelector('#told')
for (const button of document.querySelectorAll('[data-step]')) {
  button.addEventListener('click', () => {
    const { step } = button.dataset
    if (step === '') figure.removeAttribute('step')
    else figure.setAttribute('step', step)
  })
}
