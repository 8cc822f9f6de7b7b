// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the initial pictures of the printed rules' results with the page's code.
import { readFileSync } from 'node:fs'
import { pathToFileURL } from 'node:url'
import { build } from 'esbuild'
import { ROOT } from '../run.mjs'

const SIZE = { width: 360, height: 360 }
const BUNDLE = `${ROOT}build/printed-picture.mjs`

/**
 * @returns {Promise<(circles: number[][], figure: { rules: string[], view?: number[] }) => { svg: string, sentence:
 * string }>} a function of a figure's circles
 */
export async function loadPrinted(library) {
  await build({
    entryPoints: [`${ROOT}web/tutorial/printed-picture.ts`],
    outfile: BUNDLE,
    bundle: true,
    format: 'esm',
    platform: 'node',
    logLevel: 'warning',
  })
  const { loadPrintedRules, compare, sentenceOf, lookAt, pictureOf } = await import(pathToFileURL(BUNDLE).href)
  const printed = await loadPrintedRules(readFileSync(`${ROOT}web/tutorial/generated/printed.wasm`))
  const style = ['style/tokens.css', 'tutorial/printed.css']
    .map((name) => readFileSync(`${ROOT}web/${name}`, 'utf8'))
    .join('\n')

  return (circles, { rules, view }) => {
    const coordinates = Float64Array.from(circles.flat())
    const comparison = compare(library.compute(coordinates), printed.run(coordinates, rules))
    const [x, y, span] = view ?? []
    const camera = lookAt(coordinates, view && { x, y, span }, SIZE)
    const { viewBox, content } = pictureOf(coordinates, comparison, camera, SIZE)
    const svg = `<svg xmlns="http://www.w3.org/2000/svg" class="printed" viewBox="${viewBox}"><style>
${style}</style>${content}</svg>
`
    return { svg, sentence: sentenceOf(comparison) }
  }
}
