// SPDX-License-Identifier: GPL-3.0-or-later
/** Puts what comes out, or what is wrong, into the page. */
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
