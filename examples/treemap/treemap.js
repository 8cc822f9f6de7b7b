// SPDX-License-Identifier: GPL-3.0-or-later
// A treemap of cells The cell of each group is the region of its parts, so every cell is as large as its number, at
// each level.

/** Number of times that points move to the centroids of their cells, which makes cells rounder. */
const RELAX = 20
/** Largest distance between the polygons of groups and their true curves. */
const TOLERANCE = 0.002

/**
 * Returns the cells of a tree: `{ name, children }` with numbers as the `value` of leaves. Each cell has its `name`,
 * the `names` of its groups from the outermost to its own, its `value`, its `path` for SVG and its `area`. Groups come
 * before their parts. `regions` is the result of `loadRegions`; `shape` is the region of the whole tree.
 */
export function treemap(regions, tree, shape) {
  const cells = []
  addParts(regions, tree, shape, [], cells)
  return cells
}

/** The number of a leaf, or the sum of all leaves below. */
export function sumOf({ value, children }) {
  return value ?? children.reduce((sum, child) => sum + sumOf(child), 0)
}

function addParts(regions, { children }, shape, names, cells) {
  const { diagram } = regions.fitAreas(pointsIn(shape, children.length), children.map(sumOf), {
    region: shape,
    shares: true,
    relax: RELAX,
    tolerance: 1e-6,
  })
  const areas = diagram.cellAreas({ region: shape })
  const centroids = diagram.cellCentroids({ region: shape })
  children.forEach((child, i) => {
    cells.push({
      name: child.name,
      names: [...names, child.name],
      value: sumOf(child),
      isGroup: child.children !== undefined,
      area: areas[i],
      center: { x: centroids[2 * i], y: centroids[2 * i + 1] },
      path: diagram.cellPath(i, { region: shape, tolerance: TOLERANCE }),
    })
    if (child.children === undefined) return
    const coordinates = diagram.cellPolygon(i, { region: shape, tolerance: TOLERANCE })
    addParts(regions, child, regions.region({ type: 'MultiPolygon', coordinates }), [...names, child.name], cells)
  })
}

/** Returns points spread evenly over a region. They are the same each time. */
function pointsIn(shape, count) {
  const { minX, minY, maxX, maxY } = shape.box
  const points = []
  // The plastic number, the counterpart of the golden ratio in the plane.
  for (let k = 1; points.length < count; k++) {
    const x = minX + (maxX - minX) * ((0.754877666 * k) % 1)
    const y = minY + (maxY - minY) * ((0.569840291 * k) % 1)
    if (shape.contains(x, y)) points.push([x, y])
  }
  return points
}
