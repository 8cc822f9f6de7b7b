// SPDX-License-Identifier: GPL-3.0-or-later
// Market areas within a border: the cells of towns, clipped to a country. The slider sets the advantage of large towns.
import type { Region } from '../../lib/regions/region.ts'
import type { Regions } from '../../lib/wasm/regions.ts'
import { percent } from './areas.ts'
import { colorsOf, coordinatesOf, drawDiscs, type Kind, list, Pen, type Scene } from './scene.ts'

const MOST = 2

export const marketAreas: Kind = {
  hasRegions: true,
  range: () => ({ last: MOST, step: 'any' }),

  draw(scene, value, library, regions) {
    const pen = new Pen(scene)
    const country = countryOf(scene, regions)
    const towns = scene.circles.map((circle) => ({ ...circle, r: value * circle.r }))
    const diagram = library.compute(coordinatesOf(towns))
    const colors = colorsOf(diagram)
    const options = { region: country }
    for (const i of towns.keys()) pen.path(`cell c${colors[i]}`, diagram.cellPath(i, options))
    pen.path('edge', diagram.render(options)).path('coast', diagram.renderBounds(options))
    drawDiscs(pen, towns, colors)
    const shares = [...diagram.cellAreas(options)].map((area) => area / country.area)
    const largest = shares.indexOf(Math.max(...shares))
    const none = shares.flatMap((share, i) => (share === 0 ? [i] : []))
    const nobody =
      none.length === 0
        ? ''
        : ` ${none.length === 1 ? 'Town' : 'Towns'} ${list(none)} ${none.length === 1 ? 'serves' : 'serve'} nobody.`
    return {
      content: pen.content,
      told: `Town ${largest} serves the largest area: ${percent(shares[largest] as number)} of the country.${nobody}`,
    }
  },
}

let kept: { readonly shape: Scene['region']; readonly country: Region } | undefined

function countryOf({ region: shape }: Scene, regions: Regions | undefined): Region {
  if (regions === undefined || shape === undefined) throw new Error('This figure needs a region.')
  if (kept?.shape !== shape) kept = { shape, country: regions.region(shape) }
  return kept.country
}
