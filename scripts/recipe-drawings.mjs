// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the results of the cookbook's scripts as SVG.
import { geoMercator, geoPath } from 'd3-geo'
import { ROOT } from './run.mjs'
import { loadDrawn } from './texts/drawn.mjs'
import { loadFigureCircles } from './texts/figure-circles.mjs'
import { posterMaker } from './texts/poster.mjs'
import { readBook } from './texts/tutorial.mjs'

/** Size of the drawings, whose width the writer fills. */
const SIZE = { width: 480, height: 300 }
const COLORS = ['#3f7fbf', '#e0a030', '#3c9a7c']
const EDGE = '#2a3140'

/**
 * For each script, by its title: the names of the drawn variables, and the drawing function.
 * @returns {Promise<Record<string, { names: readonly string[], draw: (values: Record<string, any>) => string }>>}
 */
export async function recipeDrawings() {
  const { loadCircleVoronoi } = await import(`${ROOT}dist/lib/index.js`)
  const { loadFiles } = await import(`${ROOT}dist/lib/files.js`)
  const [library, files] = [await loadCircleVoronoi(), await loadFiles()]
  const [tutorial, circlesOf] = [await loadDrawn(library), await loadFigureCircles()]
  const posterOf = posterMaker(library, tutorial)
  /** `bounds` has the aspect ratio of SIZE. */
  const drawn = (diagram, bounds, layers = {}) =>
    posterOf(files.writeDiagram(diagram, { format: 'svg', bounds, digits: 4, tolerance: 0.001 }), diagram, { layers })
  return {
    'Migrate from d3-delaunay': {
      names: ['delaunay', 'diagram'],
      draw({ delaunay, diagram }) {
        const bounds = [-9, -4, 15, 11]
        const dashed = delaunay.voronoi(bounds).render()
        return above(
          drawn(diagram, bounds),
          `<path d="${dashed}" fill="none" stroke="${EDGE}" stroke-dasharray="6 5" vector-effect="non-scaling-stroke"/>`,
        )
      },
    },
    'Find the nearest of your data': { names: ['diagram'], draw: ({ diagram }) => drawn(diagram, [-11, -5, 16.2, 12]) },
    'Show cells on a MapLibre map': { names: ['data'], draw: ({ data }) => onMap(data) },
    'Draw cells with d3-geo': { names: ['svg'], draw: ({ svg }) => svg },
    'Show cells with deck.gl': { names: ['data'], draw: ({ data }) => asPolygons(data) },
    'Write a file in Node': { names: ['text'], draw: ({ text }) => text },
    'Compute in a worker, and cancel': {
      names: ['diagram'],
      draw: ({ diagram }) => above(drawn(diagram, [-1.9, -1.2, 1.94, 1.2]), centersOf(diagram, 0.02)),
    },
    'Find hidden circles': {
      names: ['diagram'],
      draw: ({ diagram }) => drawn(diagram, [-7, -6, 12.2, 6], { hidden: true }),
    },
    'Use weights': {
      names: ['diagram'],
      draw: ({ diagram }) => above(drawn(diagram, [-5, -6, 14.2, 6]), centersOf(diagram, 0.12)),
    },
    // The figure in the tutorial.
    'Compute in tiles': {
      names: [],
      draw() {
        const [{ spec }] = readBook()
          .flatMap(({ blocks }) => blocks)
          .filter(({ spec }) => spec.kind === 'final')
        return String(tutorial.draw(spec, circlesOf(spec)).picture)
      },
    },
    'Save and load a diagram': { names: ['loaded'], draw: ({ loaded }) => drawn(loaded, [-8, -3, 14.4, 11]) },
  }
}

/** Adds elements above a drawing of the writer, in units of the plane. */
function above(svg, parts) {
  return svg.replace(/<\/g>\s*<\/svg>\s*$/, `${parts}$&`)
}

/** Draws centers as dots, because some circles are too small to see. */
function centersOf({ circles }, r) {
  const dots = Array.from(
    { length: circles.length / 3 },
    (_, i) => `<circle cx="${circles[3 * i]}" cy="${circles[3 * i + 1]}" r="${r}" stroke="none" fill="${EDGE}"/>`,
  )
  return dots.join('\n')
}

/** Converts to web Mercator. d3-geo treats the outside of rings in the other direction as their inside. */
function onMap(data) {
  const features = data.features.map(({ properties, geometry }) => ({
    type: 'Feature',
    properties,
    geometry: { ...geometry, coordinates: geometry.coordinates.map((ring) => ring.toReversed()) },
  }))
  const projection = geoMercator().fitSize([SIZE.width, SIZE.height], { type: 'FeatureCollection', features })
  const path = geoPath(projection)
  const cells = features.map((feature) => {
    const [x, y] = path.centroid(feature)
    return `<path d="${path(feature)}" fill="${COLORS[0]}" fill-opacity="0.3" stroke="${EDGE}"/>
<text x="${x}" y="${y}" font-family="sans-serif" font-size="16" text-anchor="middle">${feature.properties.name}</text>`
  })
  return svgOf(cells)
}

function asPolygons(data) {
  return svgOf(
    data.map(
      ({ color, polygon }) =>
        `<polygon points="${polygon.join(' ')}" fill="rgb(${color})" fill-opacity="${60 / 255}" stroke="${EDGE}"/>`,
    ),
  )
}

function svgOf(parts) {
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${SIZE.width} ${SIZE.height}">${parts.join('\n')}</svg>`
}
