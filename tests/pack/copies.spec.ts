// SPDX-License-Identifier: GPL-3.0-or-later
// The properties and methods of <circle-voronoi> return copies: writing into one changes nothing.
import { expect, test } from '@playwright/test'
import { ownPages } from './own-pages.ts'

const { visit } = ownPages('copies')

const FIGURES = {
  attributes: `circles="[[1,1,.2],[3,1,.3],[2,3,.2]]" view="2 2 6" layers="hull" areas="1 2 3"
    region="[[[0,0],[4,0],[4,4],[0,4]]]" check='{"circles":3}'`,
  'a lattice': 'circles="[[1,1,.2],[3,1,.3],[2,3,.2]]" lattice="4 0 0 4" layers="dual"',
}

for (const [name, attributes] of Object.entries(FIGURES)) {
  for (const isShown of [true, false]) {
    test(`a figure of ${name} that is ${isShown ? 'shown' : 'not in the page'} returns copies`, async ({ page }) => {
      await visit(page, '<body></body>')
      const [before, after] = await page.evaluate(
        async ({ attributes, isShown }) => {
          await customElements.whenDefined('circle-voronoi')
          const holder = isShown ? document.body : document.createElement('div')
          holder.innerHTML = `<circle-voronoi ${attributes}></circle-voronoi>`
          const element = holder.firstElementChild as HTMLElementTagNameMap['circle-voronoi']
          if (isShown) await element.ready
          element.layers = { ...element.layers, column: { name: 'n', values: new Float64Array(3) } }
          element.selection = [1]
          if (isShown) await element.updateComplete
          const all = () => {
            const { circles, ids, view, layers, region, lattice, areas, check, selection } = element
            return { circles, ids, view, layers, region, lattice, areas, check, selection, state: element.getState() }
          }
          const scribble = (value: unknown): void => {
            if (typeof value !== 'object' || value === null) return
            const target = value as Record<string, unknown>
            for (const key of Object.keys(target)) {
              scribble(target[key])
              if (typeof target[key] !== 'object') target[key] = 99
            }
          }
          const before = JSON.stringify(all())
          scribble(all())
          return [before, JSON.stringify(all())]
        },
        { attributes, isShown },
      )
      expect(after).toBe(before)
      expect(JSON.parse(before)).toMatchObject({ selection: { length: 1 } })
    })
  }
}
