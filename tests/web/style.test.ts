// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings use the colors of the pages around them.
import { readFileSync } from 'node:fs'
import { afterEach, expect, it, vi } from 'vitest'
import { readStyle } from '../../web/view/style.ts'

afterEach(() => vi.unstubAllGlobals())

function propertiesOf(file: string): ReadonlyMap<string, string> {
  const text = readFileSync(new URL(`../../web/${file}`, import.meta.url), 'utf8')
  // The general rules come first, media queries later.
  const found = [...text.matchAll(/--([\w-]+):\s*([^;]+);/g)].reverse()
  return new Map(found.map(([, name, value]) => [name as string, (value as string).replace(/\s+/g, ' ')]))
}

it('views have the colors of the style sheet of all pages', () => {
  const [tokens, theme] = [propertiesOf('style/tokens.css'), propertiesOf('view/theme.css')]
  for (const name of ['paper', 'edge', 'accent']) expect(theme.get(name), name).toBe(tokens.get(name))
  for (let k = 0; k < 6; k++) expect(theme.get(`map-${k}`)).toBe(tokens.get(`c${k}`))
  expect(theme.get('cell-opacity')).toBe(`rgb(0 0 0 / ${tokens.get('cell')})`)
  const width = readFileSync(new URL('../../web/view/painter/paint-context.ts', import.meta.url), 'utf8')
  expect(`${/THICKEST_LINE = ([\d.]+)/.exec(width)?.[1]}px`).toBe(tokens.get('edge-width'))
})

it('reading all colors makes the browser find styles once', () => {
  let isStale = false
  let recalculations = 0
  class FakeElement {
    readonly children: FakeElement[] = []
    readonly style = { color: '', setProperty() {} }
    appendChild(child: FakeElement) {
      this.append(child)
      return child
    }
    append(child: FakeElement) {
      this.children.push(child)
      isStale = true
    }
    remove() {
      isStale = true
    }
  }
  vi.stubGlobal('document', { createElement: () => new FakeElement() })
  vi.stubGlobal('getComputedStyle', ({ style }: FakeElement) => {
    if (isStale) recalculations += 1
    isStale = false
    return { color: style.color }
  })
  const { edge, selectedDisc } = readStyle(new FakeElement() as unknown as Element)
  expect([edge, selectedDisc]).toEqual([
    'var(--circle-voronoi-edge, var(--edge))',
    'var(--circle-voronoi-selected-disc, var(--selected-disc))',
  ])
  expect(recalculations).toBe(1)
})
