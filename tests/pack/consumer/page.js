// SPDX-License-Identifier: GPL-3.0-or-later
import { use } from './main.js'

const output = document.querySelector('output')
use().then(
  (text) => {
    output.textContent = text
  },
  (error) => {
    output.textContent = error.message
  },
)
