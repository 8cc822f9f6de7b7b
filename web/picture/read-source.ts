// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the source of a picture: a link, or a file that holds a link or circles.
import { execFileSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { dataSetOf, sourceOf } from '../app/data-sets.ts'
import { circlesOfSvg, tableOfSvg } from '../app/files/svg-scene.ts'
import { attributesOf, NO_ATTRIBUTES } from '../editing/attributes.ts'
import { CircleVoronoiError } from '../lib/base/errors.ts'
import { loadFiles } from '../lib/files.ts'
import type { Float64s } from '../lib/index.ts'
import { decodeLink, LINK_LIMITS, type LinkAttributes, type LinkInput, type LinkState } from '../lib/link.ts'
import { circlesOfText, namedCirclesOfText } from '../view/circle-text.ts'
import { readRegion } from '../view/region-text.ts'

const LINK = /(?:^|#)(v\d+\.[\w-]*)$/
const STANDARD_INPUT = '-'
const PROGRAM_OUTPUT = 2 ** 28

/**
 * Reads the state of a link or a file.
 * @param program the path of this program, which generates families of circles
 * @throws Error
 */
export async function readSource(source: string, program: string): Promise<LinkInput> {
  const link = LINK.exec(source)?.[1]
  if (link !== undefined) return withCircles(await decodeLink(link), source, program)
  const bytes = readFileSync(source === STANDARD_INPUT ? 0 : source)
  const name = source === STANDARD_INPUT ? 'standard input' : source
  const text = new TextDecoder().decode(bytes)
  const linkWithin = LINK.exec(text.trim())
  if (linkWithin !== null) return withCircles(await decodeLink(linkWithin[1] as string), text.trim(), program)
  return circlesOfFile(bytes, text, name, program)
}

async function circlesOfFile(bytes: Uint8Array, text: string, name: string, program: string): Promise<LinkInput> {
  const { holdsDiagram, readCircleFile, readCircles, readDiagramFile } = await loadFiles()
  if (/^\s*(<\?xml|<!--|<!DOCTYPE svg|<svg)/i.test(text)) {
    const table = tableOfSvg(text)
    if (table !== undefined) return { circles: readCircles(table, { name }) }
    const read = circlesOfSvg(text, name)
    return 'link' in read ? withCircles(await decodeLink(read.link), read.link, program) : { circles: read.circles }
  }
  if (holdsDiagram(bytes)) {
    const { diagram, attributes } = readDiagramFile(bytes, { name })
    return withAttributes(diagram.circles, attributes)
  }
  const { circles, attributes } = readCircleFile(bytes, { name })
  return withAttributes(circles, attributes)
}

/** Adds names to circles, unless there are more circles than a link may have. */
function withAttributes(circles: Float64s, attributes: LinkAttributes): LinkInput {
  const isDrawn = circles.length / 3 <= LINK_LIMITS.circles && attributes.properties.length > 0
  return { circles, ...(isDrawn && { attributes }) }
}

/** Returns a state with the circles of its data set. */
async function withCircles(state: LinkState, address: string, program: string): Promise<LinkInput> {
  const { dataSet, ...rest } = state
  if (dataSet === undefined) return rest
  const source = sourceOf(dataSet)
  switch (source?.kind) {
    case 'family': {
      if (source.count > LINK_LIMITS.circles) refuse('The link is for too many circles.')
      const { family, count, seed } = source
      return { ...rest, circles: circlesOfText(generated(program, family, count, seed)) }
    }
    case 'file': {
      const { hasRegion = false } = dataSetOf(dataSet) ?? {}
      const table = await fetched(dataSet, `${dataSet}.csv`, address)
      const region = hasRegion ? readRegion(await fetched(dataSet, `${dataSet}.region.json`, address)) : undefined
      const { circles, columns } = namedCirclesOfText(table)
      const numbers = Array.from({ length: circles.length / 3 }, (_, i) => i)
      const attributes = columns.length > 0 ? attributesOf({ ...NO_ATTRIBUTES, columns }, numbers) : undefined
      return { ...(region && { region }), ...(attributes && { attributes }), ...rest, circles }
    }
    case 'figure':
      return refuse(`The link is for a figure of the paper, "${dataSet}": save it as a file in the playground.`)
    case undefined:
      return refuse(`There is no data set "${dataSet}".`)
  }
}

function generated(program: string, family: string, count: number, seed: number): string {
  const args = [program, 'generate', family, String(count), '--seed', String(seed)]
  return execFileSync(process.execPath, args, { encoding: 'utf8', maxBuffer: PROGRAM_OUTPUT })
}

/** Fetches a data set, which the playground serves next to its page. */
async function fetched(dataSet: string, file: string, address: string): Promise<string> {
  if (!/^https?:/.test(address)) {
    refuse(`The link names the data set "${dataSet}" of the playground: pass its whole address, https://.../#v1...`)
  }
  const url = new URL(`data/${file}`, address)
  const response = await fetch(url).catch((error: Error) => refuse(`${url} cannot be fetched: ${error.message}.`))
  if (!response.ok) refuse(`${url} cannot be fetched (${response.status}).`)
  return response.text()
}

function refuse(reason: string): never {
  throw new CircleVoronoiError('badInput', reason)
}
