// SPDX-License-Identifier: GPL-3.0-or-later
/** Writes the result or the error of a promise into the page. */
export function show(promise) {
  const output = document.querySelector('output')
  promise.then(
    (text) => {
      output.textContent = text
    },
    (error) => {
      output.textContent = error.message
    },
  )
}
