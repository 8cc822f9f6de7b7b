// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings use the colors of the pages around them.
import { readFileSync } from 'node:fs'
import { expect, it } from 'vitest'
import { MAP_COLORS } from '../../web/view/style.ts'

function propertiesOf(file: string): ReadonlyMap<string, string> {
  const text = readFileSync(new URL(`../../web/${file}`, import.meta.url), 'utf8')
  // The general rules come first, media queries later.
  const found = [...text.matchAll(/--([\w-]+):\s*([^;]+);/g)].reverse()
  return new Map(found.map(([, name, value]) => [name as string, (value as string).replace(/\s+/g, ' ')]))
}

it('views have the colors of the style sheet of all pages', () => {
  const [tokens, theme] = [propertiesOf('style/tokens.css'), propertiesOf('view/theme.css')]
  for (const name of ['paper', 'edge', 'accent']) expect(theme.get(name), name).toBe(tokens.get(name))
  for (let k = 0; k < MAP_COLORS; k++) expect(theme.get(`map-${k}`)).toBe(tokens.get(`c${k}`))
  expect(theme.get('cell-opacity')).toBe(`rgb(0 0 0 / ${tokens.get('cell')})`)
  const width = readFileSync(new URL('../../web/view/painter/paint-context.ts', import.meta.url), 'utf8')
  expect(`${/THICKEST_LINE = ([\d.]+)/.exec(width)?.[1]}px`).toBe(tokens.get('edge-width'))
})
