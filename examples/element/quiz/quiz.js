// SPDX-License-Identifier: GPL-3.0-or-later
// The page shows the form data that a server would receive.
const form = document.querySelector('form')
form.addEventListener('submit', (event) => {
  event.preventDefault()
  const { circles, check } = JSON.parse(new FormData(form).get('answer'))
  form.querySelector('output').textContent = `Handed in: ${circles.length} circles, ${check ? 'right' : 'wrong'}.`
})
