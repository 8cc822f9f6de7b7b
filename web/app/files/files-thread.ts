// SPDX-License-Identifier: GPL-3.0-or-later
// The worker of `FilesClient`: readers, writers and generators, loaded on demand.
import { columnsOf, NO_ATTRIBUTES } from '../../editing/attributes.ts'
import type { Headings } from '../../editing/history.ts'
import { COLOR } from '../../editing/identity.ts'
import { at } from '../../lib/base/diagram-data.ts'
import { CircleVoronoiError } from '../../lib/base/errors.ts'
import { loadedOnce } from '../../lib/base/loaded-once.ts'
import type { CircleAttributes, Files, ReadCirclesOptions } from '../../lib/files.ts'
import type { Diagram, Float64s, Int32s, PeriodicDiagram } from '../../lib/index.ts'
import { encodeLink, type LinkAttributes } from '../../lib/link.ts'
import type { RegionShape } from '../../lib/regions/region-shape.ts'
import { answerRequests } from '../../lib/threads/answer-requests.ts'
import { boundingBox } from '../../view/camera.ts'
import { USUAL_NAMES } from '../../view/circle-text.ts'
import type { Domain } from '../../view/domain.ts'
import { degreesIn } from '../earth/degrees.ts'
import { randomNumbers } from '../random-numbers.ts'
import { type ColumnNames, knownColumns, type RadiusScale, scaled, UNCHANGED } from './columns.ts'
import type { FilesCalls, HowRead, NamedCircles, NamedColumns, Preview, Read, SavedFormat } from './files-protocol.ts'
import { previewFrame } from './preview-frame.ts'
import { pixelsOf, stippled } from './stipple.ts'
import { circlesOfSvg, tableOfSvg } from './svg-scene.ts'

/** Diagrams of more circles are previewed without their edges. */
const MOST_PREVIEWED = 5000
/** Number of letters in which the radius of a first point is looked for. */
const HEAD = 65_536
/** The property of the first point that has its radius. */
const GEOJSON_RADIUS = /^[^[]*"features"[\s\S]*?"properties"\s*:\s*\{[^}]*?"(r|rad|radius)"\s*:/i
/** A fixed seed, so that a picture always gives the same circles. */
const STIPPLED = 1

const files = loadedOnce(async () => (await import('../../lib/files.ts')).loadFiles())
const library = loadedOnce(async () => (await import('../../lib/wasm/loader.ts')).loadLibrary())
const generators = loadedOnce(async () => (await import('../generators/generators.ts')).loadGenerators())

answerRequests<FilesCalls>({
  read: (args) => read(...args),
  stipple: async ([picture, count]) => {
    const pixels = await pixelsOf(picture)
    const { circles, colors } = stippled(pixels, randomNumbers(STIPPLED), count)
    const values = colors.map((color) => JSON.stringify(color))
    const { width, height } = pixels
    return { circles, attributes: { ...NO_ATTRIBUTES, columns: [{ name: COLOR, values }] }, size: { width, height } }
  },
  preview: ([circles]) => preview(circles),
  write: (args) => write(...args),
  link: ([state]) => encodeLink(state),
  make: async ([recipe]) => (await generators()).make(recipe),
  thumbnail: async ([circles, name, rings]) => {
    const { thumbnail } = await import('../first-picture.ts')
    return thumbnail((await library()).compute(circles), name, rings)
  },
  catalogue: async () => (await generators()).catalogue(),
})

async function read(bytes: Uint8Array<ArrayBuffer>, name: string, how: HowRead = {}): Promise<Read> {
  const { skipsInvalid: skipInvalid = false, columns, polygons = [] } = how
  const text = new TextDecoder().decode(bytes)
  const isSvg = /^\s*(<\?xml|<!--|<!DOCTYPE svg|<svg)/i.test(text)
  const table = isSvg ? tableOfSvg(text) : undefined
  if (isSvg && table === undefined) return circlesOfSvg(text, name)
  const { holdsDiagram, readCircleFile, readDiagramFile } = await files()
  const tableBytes = table === undefined ? bytes : new TextEncoder().encode(table)
  const isDiagram = table === undefined && holdsDiagram(bytes)
  if (!isDiagram) {
    const { circles, attributes, skipped } = readCircleFile(tableBytes, {
      name,
      skipInvalid: skipInvalid || polygons.length > 0,
      ...optionsOf(columns),
    })
    const invalid = skipped.filter(({ index }) => !polygons.includes(index))
    if (!skipInvalid && invalid[0] !== undefined) throw new CircleVoronoiError('badInput', invalid[0].message)
    const names = namesOf(columns) ?? knownColumns(table ?? text)
    const read = withColumns(withRadii(circles, columns), attributes)
    const degrees = degreesIn(read.circles, names, name)
    return {
      ...(columns === undefined ? read : withGivenColumn(read, circles, columns)),
      ...(degrees && { degrees }),
      ...(table === undefined && headingsIn(names, columns, text)),
      ...(skipInvalid && { skipped: invalid.length }),
    }
  }
  const { diagram, attributes } = readDiagramFile(bytes, { name })
  return withColumns(diagram.circles, attributes)
}

async function preview(circles: Float64s): Promise<Preview> {
  const { compute } = await library()
  const hidden = Array.from(compute(circles).hidden).filter((_, k) => k % 2 === 0)
  if (circles.length / 3 > MOST_PREVIEWED) return { hidden, edges: '' }
  const { shown, bounds } = previewFrame(circles)
  const diagram = compute(shown)
  const edges = Array.from({ length: diagram.edges.length / 4 }, (_, e) => diagram.edgePath(e, { bounds }))
  return { hidden, edges: edges.join('') }
}

function optionsOf(columns: NamedColumns | undefined): ReadCirclesOptions {
  if (columns === undefined) return {}
  const { x, y, radius } = columns
  return { x, y, ...(typeof radius === 'string' ? { radius } : { points: true }) }
}

function namesOf(columns: NamedColumns | undefined): ColumnNames | undefined {
  if (columns === undefined) return undefined
  const { x, y, radius } = columns
  return { x, y, radius: typeof radius === 'string' ? radius : undefined }
}

/** The headings for saving. Radii have the name of their column only if they are its numbers. */
function headingsIn(names: ColumnNames | undefined, columns: NamedColumns | undefined, text: string) {
  if (names === undefined) {
    const radius = GEOJSON_RADIUS.exec(text.slice(0, HEAD))?.[1]
    return radius === undefined || radius === 'r' ? {} : { headings: ['x', 'y', radius] satisfies Headings }
  }
  const isGiven = columns === undefined || isUnchanged(columns)
  const headings = [names.x, names.y, (isGiven ? names.radius : undefined) ?? 'r'] as const
  return headings.join() === 'x,y,r' || headings.some((name) => name.startsWith('#')) ? {} : { headings }
}

function isUnchanged({ kind, factor }: RadiusScale): boolean {
  return kind === UNCHANGED.kind && factor === UNCHANGED.factor
}

/** Returns the circles with the radius that was chosen for all, or with the radii that follow from a column. */
function withRadii(circles: Float64s, columns: NamedColumns | undefined): Float64s {
  if (columns === undefined) return circles
  const { radius } = columns
  const radiusFrom = (value: number) => (typeof radius === 'string' ? scaled(value, columns) : radius.all)
  return circles.map((value, k) => (k % 3 === 2 ? radiusFrom(value) : value))
}

/** Keeps a column whose numbers are not the radii themselves, such as diameters. */
function withGivenColumn(read: NamedCircles, given: Float64s, columns: NamedColumns): NamedCircles {
  const { radius } = columns
  if (typeof radius !== 'string' || radius.startsWith('#') || isUnchanged(columns)) return read
  const values = Array.from({ length: given.length / 3 }, (_, i) => String(given[3 * i + 2]))
  const { attributes = NO_ATTRIBUTES } = read
  return { ...read, attributes: { ...attributes, columns: [{ name: radius, values }, ...attributes.columns] } }
}

function withColumns(circles: Float64s, given: CircleAttributes): NamedCircles {
  const attributes = columnsOf(given, circles.length / 3)
  const { columns, ids, heights, collection } = attributes
  const isAny = columns.length + ids.length + heights.length + collection.length > 0
  return isAny ? { circles, attributes } : { circles }
}

async function write(
  circles: Float64s,
  format: SavedFormat,
  { region, lattice }: Partial<Domain> = {},
  attributes?: LinkAttributes,
  headings: Headings = ['x', 'y', 'r'],
): Promise<string> {
  const { writeCircles, writeDiagram } = await files()
  const { compute, computePeriodic } = await library()
  switch (format) {
    case 'csv':
      return writeCircles(circles, { format, attributes }).replace(/^x,y,r/, () => headings.map(csvField).join())
    case 'geojson':
      return withRegion(withRadiusName(writeCircles(circles, { format, attributes }), headings[2]), region)
    case 'json':
      return writeDiagram(compute(circles), { format, attributes })
    case 'cells': {
      if (lattice !== undefined) return cellsInPeriods(computePeriodic(circles, lattice), attributes)
      if (region === undefined) return cellsInBox(compute(circles), writeDiagram, attributes)
      const { loadRegions } = await import('../../lib/regions.ts')
      const clip = (await loadRegions()).region(region)
      return writeDiagram(compute(circles), { format: 'geojson', region: clip, attributes })
    }
  }
}

/** Writes the whole cells of circles that repeat as GeoJSON, with the properties that the program writes. */
function cellsInPeriods(periodic: PeriodicDiagram, attributes?: LinkAttributes): string {
  const features = Array.from({ length: periodic.circleCount }, (_, circle) => {
    const polygon = periodic.cellPolygon(circle)
    const neighbors = periodic.neighbors(circle)
    const measured = JSON.stringify({
      circle,
      r: periodic.diagram.circles[3 * circle + 2],
      area: periodic.cellArea(circle),
      neighbors: neighbors.map((image) => image.circle),
      shifts: neighbors.map((image) => image.shift),
    })
    const geometry = JSON.stringify(polygon === undefined ? null : { type: 'Polygon', coordinates: [polygon] })
    // The text stays unparsed, because large numbers would lose digits.
    const known = (attributes?.properties[circle] ?? '').replace(/^\s*\{\s*|\s*\}\s*$/g, '')
    const properties = known === '' ? measured : `${measured.slice(0, -1)},${known}}`
    const id = attributes?.ids[circle] || undefined
    return `{"type":"Feature",${id === undefined ? '' : `"id":${id},`}"properties":${properties},"geometry":${geometry}}`
  })
  return `{"type":"FeatureCollection","features":[\n${features.join(',\n')}\n]}\n`
}

/** Writes a name of a column as a field of CSV. */
function csvField(name: string): string {
  return /[",\r\n]|^[\s#]|^$|\s$/.test(name) ? `"${name.replaceAll('"', '""')}"` : name
}

/** Gives the radii of points in GeoJSON their former name, if readers know it. */
function withRadiusName(geojson: string, name: string): string {
  if (!(USUAL_NAMES[2] as readonly string[]).includes(name.toLowerCase()) || name === 'r') return geojson
  const head = /^(\{"type":"Feature",(?:"id":(?:"(?:[^"\\]|\\.)*"|[^",]*),)?"properties":\{)"r":/gm
  return geojson.replace(head, (_, before: string) => `${before}${JSON.stringify(name)}:`)
}

/** Adds a region as the last feature. */
async function withRegion(geojson: string, shape: RegionShape | undefined): Promise<string> {
  if (shape === undefined) return geojson
  const { loadRegions } = await import('../../lib/regions.ts')
  const { points, ringOffsets, polygonOffsets } = (await loadRegions()).region(shape)
  const list = <Item>(offsets: Int32s, k: number, item: (i: number) => Item) =>
    Array.from({ length: at(offsets, k + 1) - at(offsets, k) }, (_, i) => item(at(offsets, k) + i))
  const ringAt = (ring: number) => {
    const corners = list(ringOffsets, ring, (i) => [at(points, 2 * i), at(points, 2 * i + 1)])
    return [...corners, corners[0]]
  }
  const coordinates = Array.from({ length: polygonOffsets.length - 1 }, (_, k) => list(polygonOffsets, k, ringAt))
  const feature = JSON.stringify({ type: 'Feature', properties: {}, geometry: { type: 'MultiPolygon', coordinates } })
  const isFirst = geojson.endsWith('[\n]}\n')
  return `${geojson.slice(0, -'\n]}\n'.length)}${isFirst ? '' : ','}\n${feature}\n]}\n`
}

/** Writes the cells inside a box around all circles as GeoJSON. */
function cellsInBox(diagram: Diagram, writeDiagram: Files['writeDiagram'], attributes?: LinkAttributes): string {
  const { minX, minY, maxX, maxY } = boundingBox(diagram.circles)
  const margin = Math.max(maxX - minX, maxY - minY) / 20
  const bounds = [minX - margin, minY - margin, maxX + margin, maxY + margin] as const
  return writeDiagram(diagram, { format: 'geojson', bounds, attributes })
}
