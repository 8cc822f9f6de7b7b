// SPDX-License-Identifier: GPL-3.0-or-later
// The worker of `FilesClient`: readers, writers and generators, loaded on demand.
import { columnsOf, NO_ATTRIBUTES } from '../../editing/attributes.ts'
import { COLOR } from '../../editing/identity.ts'
import { CircleVoronoiError, reasonOf } from '../../lib/base/errors.ts'
import { loadedOnce } from '../../lib/base/loaded-once.ts'
import type { CircleAttributes, Files, ReadCirclesOptions } from '../../lib/files.ts'
import type { Diagram, Float64s, PeriodicDiagram } from '../../lib/index.ts'
import { encodeLink, type LinkAttributes } from '../../lib/link.ts'
import { boundingBox } from '../../view/camera.ts'
import type { Domain } from '../../view/domain.ts'
import type { RemoteCall, RemoteReply } from '../../view/remote-calls.ts'
import { degreesIn } from '../earth/degrees.ts'
import { randomNumbers } from '../random-numbers.ts'
import { type ColumnNames, knownColumns } from './columns.ts'
import type { FilesCalls, HowRead, NamedCircles, NamedColumns, Read, SavedFormat } from './files-protocol.ts'
import { pixelsOf, stippled } from './stipple.ts'
import { circlesOfSvg, tableOfSvg } from './svg-scene.ts'

const port = globalThis as unknown as {
  onmessage: (event: MessageEvent<RemoteCall<keyof FilesCalls>>) => void
  postMessage(message: RemoteReply, transfer?: Transferable[]): void
}

/** A fixed seed, so that a picture always gives the same circles. */
const STIPPLED = 1

const files = loadedOnce(async () => (await import('../../lib/files.ts')).loadFiles())
const library = loadedOnce(async () => (await import('../../lib/wasm/loader.ts')).loadLibrary())
const generators = loadedOnce(async () => (await import('../generators/generators.ts')).loadGenerators())

const calls: {
  readonly [Name in keyof FilesCalls]: (
    ...args: Parameters<FilesCalls[Name]>
  ) => ReturnType<FilesCalls[Name]> | Promise<ReturnType<FilesCalls[Name]>>
} = {
  read,
  stipple: async (picture) => {
    const { circles, colors } = stippled(await pixelsOf(picture), randomNumbers(STIPPLED))
    const values = colors.map((color) => JSON.stringify(color))
    return { circles, attributes: { ...NO_ATTRIBUTES, columns: [{ name: COLOR, values }] } }
  },
  write,
  link: encodeLink,
  make: async (recipe) => (await generators()).make(recipe),
  catalogue: async () => (await generators()).catalogue(),
}

port.onmessage = async ({ data: { request, name, args } }) => {
  try {
    const value = await (calls[name] as (...args: readonly unknown[]) => unknown)(...args)
    port.postMessage({ request, value })
  } catch (error) {
    const { code, circle } =
      error instanceof CircleVoronoiError ? error : { code: 'internal' as const, circle: undefined }
    port.postMessage({ request, error: { code, circle, message: `${reasonOf(error)}.` } })
  }
}

async function read(bytes: Uint8Array<ArrayBuffer>, name: string, how: HowRead = {}): Promise<Read> {
  const { skipsInvalid: skipInvalid = false, columns } = how
  const text = new TextDecoder().decode(bytes)
  const isSvg = /^\s*(<\?xml|<!--|<!DOCTYPE svg|<svg)/i.test(text)
  const table = isSvg ? tableOfSvg(text) : undefined
  if (isSvg && table === undefined) return circlesOfSvg(text, name)
  const { holdsDiagram, readCircleFile, readDiagramFile } = await files()
  const tableBytes = table === undefined ? bytes : new TextEncoder().encode(table)
  const isDiagram = table === undefined && holdsDiagram(bytes)
  if (!isDiagram) {
    const { circles, attributes, skipped } = readCircleFile(tableBytes, { name, skipInvalid, ...optionsOf(columns) })
    const degrees = degreesIn(circles, namesOf(columns) ?? knownColumns(table ?? text), name)
    return {
      ...withColumns(withRadii(circles, columns), attributes),
      ...(degrees && { degrees }),
      ...(skipInvalid && { skipped: skipped.length }),
    }
  }
  const { diagram, attributes } = readDiagramFile(bytes, { name })
  return withColumns(diagram.circles, attributes)
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

/** Returns the circles with the radius that was chosen for all, or with half the diameters. */
function withRadii(circles: Float64s, columns: NamedColumns | undefined): Float64s {
  if (columns === undefined) return circles
  const { radius, isDiameter } = columns
  const radiusFrom = (r: number) => (typeof radius !== 'string' ? radius.all : isDiameter ? r / 2 : r)
  return circles.map((value, k) => (k % 3 === 2 ? radiusFrom(value) : value))
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
): Promise<string> {
  const { writeCircles, writeDiagram } = await files()
  const { compute, computePeriodic } = await library()
  switch (format) {
    case 'csv':
      return writeCircles(circles, { format, attributes })
    case 'geojson':
      return writeCircles(circles, { format, attributes })
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

/** Writes the cells inside a box around all circles as GeoJSON. */
function cellsInBox(diagram: Diagram, writeDiagram: Files['writeDiagram'], attributes?: LinkAttributes): string {
  const { minX, minY, maxX, maxY } = boundingBox(diagram.circles)
  const margin = Math.max(maxX - minX, maxY - minY) / 20
  const bounds = [minX - margin, minY - margin, maxX + margin, maxY + margin] as const
  return writeDiagram(diagram, { format: 'geojson', bounds, attributes })
}
