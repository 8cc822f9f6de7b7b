// SPDX-License-Identifier: GPL-3.0-or-later
import { encode } from 'uqr'
import type { Circle } from '../../lib/index.ts'
import type { LinkFrame } from '../../lib/link.ts'
import { toScreen } from '../../view/camera.ts'
import type { ExportView } from '../../view/export.ts'
import { parsedSvg } from '../../view/parsed-svg.ts'
import './worksheet.css'

/** Letters of an address that a code on paper can hold so that a phone reads it. */
const MOST_CODED = 1800
/** White squares around a code, as its standard asks for. */
const QUIET = 4

/** Distance from a circle to its ring, and height of letters, in pixels of the picture. */
const RING = 8
const LETTER = 20

const WORDS = {
  en: {
    name: 'Name:',
    date: 'Date:',
    draw: 'Draw the border of each cell: the points that are equally far from two circles.',
    check: 'Check your answer:',
    long: 'The figure is too large for a code.',
    key: 'Key',
  },
  de: {
    name: 'Name:',
    date: 'Datum:',
    draw: 'Zeichne die Grenze jeder Zelle: die Punkte, die von zwei Kreisen gleich weit entfernt sind.',
    check: 'Prüfe deine Antwort:',
    long: 'Die Figur ist zu groß für einen Code.',
    key: 'Lösung',
  },
} as const

/** The contents of a worksheet. */
export interface Worksheet {
  readonly frame: LinkFrame
  /** The task after the drawing; may be empty. */
  readonly task: string
  /** The diagram as SVG. */
  readonly key: string
  /** The part of the plane of both pictures. */
  readonly shot: ExportView
  readonly discs: readonly Circle[]
  /** The circles of the check, by their indices, with their values. */
  readonly marks: readonly { readonly index: number; readonly text: string }[]
  /** The address where the question is answered. */
  readonly address: string
}

/**
 * Prints two pages: circles alone, to draw on, with a code of the address where the question is answered; and the key.
 * Resolves once the dialog for printing is closed.
 */
export function printWorksheet(
  place: HTMLElement,
  { frame, task, key, shot, discs, marks, address }: Worksheet,
): Promise<void> {
  const words = WORDS[frame.lang === 'de' ? 'de' : 'en']
  const text = (name: string, content: string) => Object.assign(document.createElement(name), { textContent: content })
  const page = (...parts: readonly Node[]) => {
    const section = document.createElement('section')
    section.append(...parts)
    return section
  }
  const picture = (svg: string) => {
    const figure = document.createElement('figure')
    const drawing = parsedSvg(svg)
    if (drawing !== undefined) figure.append(drawing)
    return figure
  }
  const head = text('p', '')
  head.className = 'names'
  head.append(text('span', words.name), text('span', words.date))
  const title = frame.title ?? ''
  const tasks = document.createElement('ol')
  tasks.append(...[words.draw, task].filter((line) => line !== '').map((line) => text('li', line)))
  const foot = document.createElement('footer')
  const code = address.length > MOST_CODED ? undefined : codeOf(address)
  const where = text('p', code === undefined ? words.long : words.check)
  if (code !== undefined) where.append(text('code', address))
  foot.append(...(code === undefined ? [] : [code]), where)
  const { width, height } = shot.size
  const blank = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}">${outlines(discs, shot)}${marked(discs, shot, marks, false)}</svg>`
  place.replaceChildren(
    page(head, text('h1', title), tasks, picture(blank), foot),
    page(
      text('h1', title === '' ? words.key : `${words.key}: ${title}`),
      picture(key.replace(/<\/svg>\s*$/, `${marked(discs, shot, marks, true)}</svg>`)),
      tasks.cloneNode(true),
    ),
  )
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

/** The discs with their centers. */
function outlines(discs: readonly Circle[], shot: ExportView): string {
  const drawn = discs.map((disc) => {
    const { x, y, r } = onSheet(disc, shot)
    return `<circle cx="${x}" cy="${y}" r="${r}" fill="#eeeeee" stroke="#000000" stroke-width="2"/><circle cx="${x}" cy="${y}" r="2.5"/>`
  })
  return drawn.join('')
}

/** The rings and numbers of the circles that the task names. */
function marked(discs: readonly Circle[], shot: ExportView, marks: Worksheet['marks'], hasValues: boolean): string {
  return marks
    .filter(({ index }) => index < discs.length)
    .map(({ index, text }) => {
      const { x, y, r } = onSheet(discs[index] as Circle, shot)
      const label = hasValues && text !== '' ? `${index}: ${text}` : `${index}`
      const below = y + r + RING + LETTER
      const at = below < shot.size.height ? below : y - r - 1.5 * RING
      return (
        `<circle cx="${x}" cy="${y}" r="${r + RING}" fill="none" stroke="#000000" stroke-width="3" stroke-dasharray="9 5"/>` +
        `<text x="${x}" y="${at}" text-anchor="middle" font-family="sans-serif" font-size="${LETTER}" font-weight="700" paint-order="stroke" stroke="#ffffff" stroke-width="5">${label}</text>`
      )
    })
    .join('')
}

/** A disc in pixels of the picture. */
function onSheet({ x, y, r }: Circle, { camera, size }: ExportView): Circle {
  const round = (value: number) => Number(value.toFixed(2))
  const place = toScreen(camera, size, { x, y })
  return { x: round(place.x), y: round(place.y), r: round(r * camera.scale) }
}

/** A QR code as SVG. */
function codeOf(text: string): SVGElement {
  const { data, size } = encode(text, { border: 0, ecc: 'L' })
  const path = data.flatMap((row, y) => row.flatMap((isDark, x) => (isDark ? [`M${x} ${y}h1v1h-1z`] : []))).join('')
  const side = size + 2 * QUIET
  const svg = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="${-QUIET} ${-QUIET} ${side} ${side}"><path d="${path}" fill="#000000"/></svg>`
  return parsedSvg(svg) as SVGElement
}
