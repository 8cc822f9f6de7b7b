// SPDX-License-Identifier: GPL-3.0-or-later
// What runs in the worker of `FilesClient`: readers, writers and generators, loaded when they are needed for the first time.
import { CircleVoronoiError, reasonOf } from '../../lib/base/errors.ts'
import { loadedOnce } from '../../lib/base/loaded-once.ts'
import { circleAt, type Diagram } from '../../lib/index.ts'
import { encodeLink } from '../../lib/link.ts'
import type { RegionShape } from '../../lib/regions/region-shape.ts'
import { randomNumbers } from '../random-circles.ts'
import type { FilesReply, FilesRequest, Read } from './files-protocol.ts'
import { attributesIn } from './names.ts'
import { stippled, tonesOf } from './stipple.ts'
import { circlesOfSvg, tableOfSvg } from './svg-scene.ts'

const port = globalThis as unknown as {
  onmessage: (event: MessageEvent<FilesRequest>) => void
  postMessage(message: FilesReply, transfer?: Transferable[]): void
}

/** The same picture becomes the same circles. */
const STIPPLED = 1

const files = loadedOnce(async () => (await import('../../lib/files.ts')).loadFiles())
const library = loadedOnce(async () => (await import('../../lib/wasm/loader.ts')).loadCircleVoronoi())
const generators = loadedOnce(async () => (await import('../generators/generators.ts')).loadGenerators())

port.onmessage = async ({ data }) => {
  const { request } = data
  try {
    port.postMessage({ request, result: await resultOf(data) })
  } catch (error) {
    const { code, circle } =
      error instanceof CircleVoronoiError ? error : { code: 'internal' as const, circle: undefined }
    port.postMessage({ request, error: { code, circle, message: `${reasonOf(error)}.` } })
  }
}

async function resultOf(data: FilesRequest): Promise<unknown> {
  switch (data.kind) {
    case 'read':
      return read(data)
    case 'stipple':
      return { circles: stippled(await tonesOf(data.picture), randomNumbers(STIPPLED)) } satisfies Read
    case 'write':
      return write(data)
    case 'link':
      return encodeLink(data.state)
    case 'make':
      return (await generators()).make(data.recipe)
    case 'catalogue':
      return (await generators()).catalogue()
  }
}

async function read({ bytes, name }: Extract<FilesRequest, { kind: 'read' }>): Promise<Read> {
  const text = new TextDecoder().decode(bytes)
  const isSvg = /^\s*(<\?xml|<!--|<!DOCTYPE svg|<svg)/i.test(text)
  const table = isSvg ? tableOfSvg(text) : undefined
  if (isSvg && table === undefined) return circlesOfSvg(text, name)
  const { holdsDiagram, readCircles, readDiagram } = await files()
  if (table !== undefined) return { circles: readCircles(new TextEncoder().encode(table), { name }) }
  if (holdsDiagram(bytes)) return { circles: readDiagram(bytes, { name }).circles }
  const circles = readCircles(bytes, { name })
  return { circles, ...attributesIn(text, circles.length / 3) }
}

async function write({ circles, format, region }: Extract<FilesRequest, { kind: 'write' }>): Promise<string> {
  const { writeCircles, writeDiagram } = await files()
  const { compute } = await library()
  switch (format) {
    case 'csv':
      return writeCircles(circles, { format })
    case 'geojson':
      return writeCircles(circles, { format })
    case 'json':
      return writeDiagram(compute(circles), { format })
    case 'cells':
      if (region !== undefined) return clippedCells(compute(circles), region)
      return writeDiagram(compute(circles), { format: 'geojson' })
  }
}

/** The cells inside a region as GeoJSON: a feature for each circle, without a geometry where there is no part. */
async function clippedCells(diagram: Diagram, shape: RegionShape): Promise<string> {
  const region = (await (await library()).loadRegions()).region(shape)
  const areas = diagram.cellAreas({ region })
  const features = Array.from(areas, (area, i) => {
    const coordinates = diagram.cellPolygon(i, { region }) ?? []
    const neighbors = [...diagram.neighbors(i, { region })]
    const geometry = coordinates.length === 0 ? null : { type: 'MultiPolygon', coordinates }
    return { type: 'Feature', properties: { circle: i, r: circleAt(diagram.circles, i).r, area, neighbors }, geometry }
  })
  return JSON.stringify({ type: 'FeatureCollection', features })
}
