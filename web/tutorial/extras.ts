// SPDX-License-Identifier: GPL-3.0-or-later
// Extra layers of some figures: shrunken rims, and paths between two centers.
import type { CircleVoronoiElement } from '../element/index.ts'
import type { CircleVoronoi, Float64s } from '../lib/index.ts'
import { loadLibrary } from '../lib/wasm/loader.ts'
import type { DataLayer } from '../view/layers.ts'

/** Color of sampled rims and of paths, visible on light and on dark paper. */
const RIM = '#8a6f5c'
const STEPS = '#c2185b'

/** Returns the circles with their radii reduced by the smallest radius, x, y and r each. */
export function shrunkenRims(circles: Float64s): Float64Array {
  const least = circles.reduce((smallest, value, k) => (k % 3 === 2 ? Math.min(smallest, value) : smallest), Infinity)
  return Float64Array.from(circles, (value, k) => (k % 3 === 2 ? value - least : value))
}

/** The circles on a shortest path from one circle to another in the Delaunay graph of centers. */
export function stepsBetween(library: CircleVoronoi, circles: Float64s, from: number, to: number): readonly number[] {
  const centers = library.compute(Float64Array.from(circles, (value, k) => (k % 3 === 2 ? 0 : value)))
  const away = (i: number) =>
    Math.hypot(
      (circles[3 * i] as number) - (circles[3 * to] as number),
      (circles[3 * i + 1] as number) - (circles[3 * to + 1] as number),
    )
  const before = new Map<number, number>([[from, from]])
  for (const circle of before.keys()) {
    // Among all shortest paths, prefers one that hardly bends.
    const nexts = [...centers.neighbors(circle)].sort((one, other) => away(one) - away(other))
    for (const next of nexts) if (!before.has(next)) before.set(next, circle)
  }
  if (!before.has(to)) return []
  const way = [to]
  while (way[0] !== from) way.unshift(before.get(way[0] as number) as number)
  return way
}

/** The extra layers of a figure with these circles. `steps` names the circles at the ends of the path. */
export function extrasOf(
  circles: Float64s,
  { hasRims, steps }: { readonly hasRims: boolean; readonly steps: readonly number[] | undefined },
  library: CircleVoronoi | undefined,
): readonly DataLayer[] {
  const layers: DataLayer[] = []
  if (hasRims) layers.push({ id: 'rims', color: RIM, discs: shrunkenRims(circles) })
  if (steps !== undefined && library !== undefined) {
    const [from = 0, to = 0] = steps
    const way = stepsBetween(library, circles, from, to).map((i) => [...circles.slice(3 * i, 3 * i + 2)])
    const least = circles.reduce((smallest, r, k) => (k % 3 === 2 ? Math.min(smallest, r) : smallest), Infinity)
    const segments = way.slice(1).flatMap((end, k) => strong(way[k] as number[], end, least / 4))
    layers.push({
      id: 'steps',
      color: STEPS,
      points: Float64Array.from(way.flat()),
      segments: Float64Array.from(segments),
    })
  }
  return layers
}

/** Draws a thick line as several parallel ones, because layers of data have thin lines. */
function strong([x0 = 0, y0 = 0]: readonly number[], [x1 = 0, y1 = 0]: readonly number[], aside: number): number[] {
  const length = Math.hypot(x1 - x0, y1 - y0)
  return [-1, -0.5, 0, 0.5, 1].flatMap((k) => {
    const [dx, dy] = [(-k * aside * (y1 - y0)) / length, (k * aside * (x1 - x0)) / length]
    return [x0 + dx, y0 + dy, x1 + dx, y1 + dy]
  })
}

export async function showExtras(page: Document): Promise<void> {
  for (const around of page.querySelectorAll<HTMLElement>('[data-rims], [data-steps]')) {
    const figure = around.querySelector('circle-voronoi') as CircleVoronoiElement
    const steps = around.dataset.steps?.split(' ').map(Number)
    const library = steps === undefined ? undefined : await loadLibrary()
    const show = () => {
      const data = extrasOf(figure.circles, { hasRims: around.dataset.rims !== undefined, steps }, library)
      figure.layers = { ...figure.layers, data }
    }
    figure.addEventListener('circleschange', show)
    void figure.ready.then(show)
  }
}
