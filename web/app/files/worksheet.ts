// SPDX-License-Identifier: GPL-3.0-or-later
import { encode } from 'uqr'
import type { LinkFrame } from '../../lib/link.ts'
import { parsedSvg } from '../../view/parsed-svg.ts'
import './worksheet.css'

/** Letters of an address that a code on paper can hold so that a phone reads it. */
const MOST_CODED = 1800
/** White squares around a code, as its standard asks for. */
const QUIET = 4

const WORDS = {
  en: { name: 'Name:', date: 'Date:', try: 'Try it:', long: 'The figure is too large for a code.' },
  de: { name: 'Name:', date: 'Datum:', try: 'Probiere es aus:', long: 'Die Figur ist zu groß für einen Code.' },
} as const

/**
 * Prints a page with a title, a question, a drawing and a code of the address where the question is answered. Resolves
 * once the dialog for printing is closed.
 */
export function printWorksheet(place: HTMLElement, frame: LinkFrame, svg: string, address: string): Promise<void> {
  const words = WORDS[frame.lang === 'de' ? 'de' : 'en']
  const text = (name: string, content: string) => Object.assign(document.createElement(name), { textContent: content })
  const head = text('p', '')
  head.className = 'names'
  head.append(text('span', words.name), text('span', words.date))
  const picture = document.createElement('figure')
  const drawing = parsedSvg(svg)
  if (drawing !== undefined) picture.append(drawing)
  const foot = document.createElement('footer')
  const code = address.length > MOST_CODED ? undefined : codeOf(address)
  foot.append(code ?? text('p', words.long), text('p', code === undefined ? '' : `${words.try} ${siteOf(address)}`))
  place.replaceChildren(head, text('h1', frame.title ?? ''), text('p', frame.question ?? ''), picture, foot)
  place.lang = frame.lang ?? 'en'
  place.hidden = false
  return new Promise((resolve) => {
    addEventListener(
      'afterprint',
      () => {
        place.hidden = true
        place.replaceChildren()
        resolve()
      },
      { once: true },
    )
    print()
  })
}

/** A QR code as SVG. */
function codeOf(text: string): SVGElement {
  const { data, size } = encode(text, { border: 0, ecc: 'L' })
  const path = data.flatMap((row, y) => row.flatMap((isDark, x) => (isDark ? [`M${x} ${y}h1v1h-1z`] : []))).join('')
  const side = size + 2 * QUIET
  const svg = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="${-QUIET} ${-QUIET} ${side} ${side}"><path d="${path}" fill="#000000"/></svg>`
  return parsedSvg(svg) as SVGElement
}

function siteOf(address: string): string {
  const { host, pathname } = new URL(address)
  return `${host}${pathname}`
}
