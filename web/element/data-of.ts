// SPDX-License-Identifier: GPL-3.0-or-later
import { attributesOfLink, NO_ATTRIBUTES } from '../editing/attributes.ts'
import type { OpenRequest } from '../editing/opening-actions.ts'
import type { Float64s } from '../lib/index.ts'
import type { LinkState } from '../lib/link.ts'
import type { RegionShape } from '../lib/regions/region-shape.ts'
import type { TextCircles } from '../view/circle-text.ts'
import type { Refusal } from '../view/refusal.ts'
import { isRegionText, readRegion } from '../view/region-text.ts'
import { circlesOfMarkdown, circlesOfTable, readCircles } from './read-circles.ts'
import { type ElementRefusals, refuse } from './refusals.ts'

const LINK = /(?:^|#)(v\d+\.[\w-]*)$/

/** Converts circles to a request to open them. */
export function opened(circles: Float64s, rest: Omit<LinkState, 'circles' | 'dataSet'> = {}): OpenRequest {
  const { region, lattice, areas, attributes: _, names: __, ...others } = rest
  const attributes = attributesOfLink(rest, circles.length / 3)
  const hasDomain = region !== undefined || lattice !== undefined || areas !== undefined
  const domain = hasDomain ? { region: region ?? undefined, lattice: lattice ?? undefined, areas } : undefined
  return { circles, dataSet: '', isEdited: false, ...others, ...(attributes && { attributes }), domain }
}

/** Converts circles from a text to a request to open them. */
export function openedText({ circles, columns }: TextCircles): OpenRequest {
  const request = opened(circles)
  return columns.length === 0 ? request : { ...request, attributes: { ...NO_ATTRIBUTES, columns } }
}

/**
 * Converts a state.
 * @throws Refusal if it names a data set of the page instead of circles
 */
export function openedState({ circles, dataSet, ...rest }: LinkState): OpenRequest {
  if (circles === undefined && dataSet !== undefined) {
    refuse((words) => words.dataSet(dataSet))
  }
  return opened(circles ?? new Float64Array(), rest)
}

/** Decodes a link. The decoder is loaded on demand. @throws CircleVoronoiError `badInput`, `notLoaded` */
export async function linkState(link: string): Promise<LinkState> {
  const { decodeLink } = await import('../lib/link.ts')
  return decodeLink(link)
}

async function openedLink(link: string): Promise<OpenRequest> {
  return openedState(await linkState(link))
}

/**
 * Loads an address: a file, or a link to the playground.
 * @throws CircleVoronoiError, or the error of `fetch`
 */
export async function openedFrom(src: string, signal: AbortSignal): Promise<OpenRequest> {
  const link = LINK.exec(src)?.[1]
  if (link !== undefined) return openedLink(link)
  const response = await fetch(src, { signal })
  if (!response.ok) refuse((words) => words.notLoaded(src, response.status))
  const text = await response.text()
  const linkWithin = LINK.exec(text.trim())?.[1]
  if (linkWithin !== undefined) return openedLink(linkWithin)
  try {
    return openedText(readCircles(text))
  } catch (error) {
    const { message } = error as Error
    refuse((words) =>
      words.within(src, 'say' in (error as object) ? (error as Refusal<ElementRefusals>).say(words) : message),
    )
  }
}

/**
 * Reads a region from text, or from the file at an address.
 * @throws CircleVoronoiError, or the error of `fetch`
 */
export async function regionFrom(text: string, base: string, signal: AbortSignal): Promise<RegionShape> {
  if (isRegionText(text)) return readRegion(text)
  const src = new URL(text, base).href
  const response = await fetch(src, { signal })
  if (!response.ok) refuse((words) => words.notLoaded(src, response.status))
  return readRegion(await response.text())
}

/** Returns the circles between an element's tags, if any. */
export function circlesWithin(element: Element): TextCircles | undefined {
  const script = element.querySelector(':scope > script[type="application/json"]')
  if (script !== null) return readCircles(script.textContent ?? '')
  const table = element.querySelector('table') ?? tableAfter(element)
  if (table !== null) return circlesOfTable(table)
  // The content may be a Markdown table that was not converted to HTML.
  const text = Array.from(element.childNodes, (node) =>
    node.nodeType === Node.TEXT_NODE ? node.textContent : '',
  ).join('')
  return /^\s*\|/.test(text) ? circlesOfMarkdown(text) : undefined
}

/**
 * Returns the table that an author has written between the tags. Some Markdown converters close the paragraph of the
 * first tag after it (`<p><circle-voronoi></p><table>...</table><p></circle-voronoi></p>`). A browser then closes the
 * element before the table, and leaves an empty paragraph behind it.
 */
function tableAfter(element: Element): HTMLTableElement | null {
  const paragraph = element.parentElement
  const isAlone =
    paragraph?.localName === 'p' && paragraph.children.length === 1 && paragraph.textContent?.trim() === ''
  const after = isAlone ? paragraph.nextElementSibling : null
  const end = after?.nextElementSibling
  if (end?.localName !== 'p' || end.childNodes.length > 0) return null
  return after instanceof HTMLTableElement ? after : (after?.querySelector('table') ?? null)
}
