// SPDX-License-Identifier: GPL-3.0-or-later
import { unescaped } from '../lib/drawing/escaped.ts'

const SVG = 'http://www.w3.org/2000/svg'
const TAG = /<(\/?)([a-zA-Z]+)([^>]*?)(\/?)>|([^<]+)/g
const ATTRIBUTE = /([\w:-]+)="([^"]*)"/g

/**
 * Builds the elements of an SVG that `svgOf` has written. The browser's parser would need a policy in pages that
 * require Trusted Types.
 */
export function parsedSvg(text: string): SVGElement | undefined {
  const open: SVGElement[] = []
  for (const [, end, name = '', attributes = '', isEmpty, words] of text.matchAll(TAG)) {
    const parent = open.at(-1)
    if (words !== undefined) {
      if (words.trim() !== '') parent?.append(unescaped(words))
    } else if (end) {
      const element = open.pop()
      if (open.length === 0) return element
    } else {
      const element = document.createElementNS(SVG, name)
      for (const [, key, value] of attributes.matchAll(ATTRIBUTE)) {
        if (key !== 'xmlns') element.setAttribute(key as string, unescaped(value as string))
      }
      parent?.append(element)
      if (!isEmpty) open.push(element)
    }
  }
  return undefined
}
