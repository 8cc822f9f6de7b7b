// SPDX-License-Identifier: GPL-3.0-or-later
// Provides a font for formulas on systems without one: the subset of Noto Sans Math that the pages use.
import { readFileSync, writeFileSync } from 'node:fs'
import subsetFont from 'subset-font'
import { ROOT } from '../run.mjs'

const PACKAGE = `${ROOT}node_modules/@fontsource/noto-sans-math`
/** Installed fonts take precedence. */
const STYLE = `@font-face {
  font-family: "Formulas";
  src: local("Cambria Math"), local("STIX Two Math"), local("Latin Modern Math"), url("./math.woff2") format("woff2");
  font-display: swap;
}
math {
  font-family: "Formulas", math;
}
`
/** Letters in formulas are separate italic characters. */
const ITALIC = { a: 0x1d44e, A: 0x1d434 }
const PLANCK = 'ℎ'

/** Writes the font, its style sheet and its license into a folder of the site. */
export async function writeMathFont(folder, html) {
  const characters = charactersOf(html)
  const whole = readFileSync(`${PACKAGE}/files/noto-sans-math-latin-400-normal.woff2`)
  writeFileSync(`${folder}/math.woff2`, await subsetFont(whole, characters, { targetFormat: 'woff2' }))
  writeFileSync(`${folder}/math.css`, STYLE)
  writeFileSync(`${folder}/math-license.txt`, readFileSync(`${PACKAGE}/LICENSE`))
}

/** The characters in formulas. */
function charactersOf(html) {
  const formulas = [...html.matchAll(/<math[\s\S]*?<\/math>/g)].map(([math]) => math.replace(/<[^>]*>/g, '')).join('')
  const plain = [...new Set(formulas.replaceAll('&lt;', '<').replaceAll('&gt;', '>').replaceAll('&amp;', '&'))]
  return [...plain, ...plain.map(slanted)].join('')
}

function slanted(letter) {
  if (letter === 'h') return PLANCK
  const first = /[a-z]/.test(letter) ? 'a' : /[A-Z]/.test(letter) ? 'A' : undefined
  if (first === undefined) return ''
  return String.fromCodePoint(ITALIC[first] + letter.charCodeAt(0) - first.charCodeAt(0))
}
