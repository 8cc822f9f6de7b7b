// SPDX-License-Identifier: GPL-3.0-or-later
import { NO_ATTRIBUTES } from '../editing/attributes.ts'
import { type OpenRequest, requestOf } from '../editing/open-request.ts'
import { isRecord } from '../lib/base/check.ts'
import { coordinatesOf } from '../lib/base/coordinates.ts'
import type { LinkInput, LinkState } from '../lib/link.ts'
import type { RegionShape } from '../lib/regions/region-shape.ts'
import type { TextCircles } from '../view/circle-text.ts'
import { checkedLayers } from '../view/layers.ts'
import type { Refusal } from '../view/refusal.ts'
import { readRegion } from '../view/region-text.ts'
import { checkedView, parseStep } from './attributes.ts'
import { circlesOfMarkdown, circlesOfTable, readCircles } from './read-circles.ts'
import { type ElementRefusals, refuse } from './refusals.ts'

const LINK = /(?:^|#)(v\d+\.[\w-]*)$/

/** Returns the request that opens circles from a text. */
export function requestOfText({ circles, columns }: TextCircles): OpenRequest {
  const request = requestOf({ circles })
  return columns.length === 0 ? request : { ...request, attributes: { ...NO_ATTRIBUTES, columns } }
}

/**
 * Returns the request that opens a state.
 * @throws Refusal if it names a data set of the page instead of circles
 */
export function requestOfState(state: LinkState): OpenRequest {
  const { circles, dataSet } = state
  if (circles === undefined && dataSet !== undefined) refuse((words) => words.dataSet(dataSet))
  return requestOf(state)
}

/**
 * Checks the parts of a state that no computation checks.
 * @throws CircleVoronoiError
 */
export function checkedState(state: LinkInput): LinkState {
  const { circles, view, layers, step } = state
  // The column of a state is a name.
  if (layers !== undefined) checkedLayers(isRecord(layers) ? { ...layers, column: undefined } : layers)
  return {
    ...state,
    circles: circles && coordinatesOf(circles),
    view: view === undefined ? undefined : checkedView(view),
    ...(step !== undefined && { step: parseStep(String(step)) }),
  }
}

/** Decodes a link. The decoder is loaded on demand. @throws CircleVoronoiError `badInput`, `notLoaded` */
export async function linkState(link: string): Promise<LinkState> {
  const { decodeLink } = await import('../lib/link.ts')
  return decodeLink(link)
}

/**
 * Loads the circles at an address: a file, or a link to the playground.
 * @throws CircleVoronoiError, or the error of `fetch`
 */
export async function requestAt(src: string, signal: AbortSignal): Promise<OpenRequest> {
  const link = LINK.exec(src)?.[1]
  if (link !== undefined) return requestOfState(await linkState(link))
  const text = await textAt(src, signal)
  const linkWithin = LINK.exec(text.trim())?.[1]
  if (linkWithin !== undefined) return requestOfState(await linkState(linkWithin))
  try {
    return requestOfText(readCircles(text))
  } catch (error) {
    const { message } = error as Error
    refuse((words) =>
      words.within(src, 'say' in (error as object) ? (error as Refusal<ElementRefusals>).say(words) : message),
    )
  }
}

/**
 * Loads the region in the file at an address.
 * @throws CircleVoronoiError, or the error of `fetch`
 */
export async function regionAt(src: string, signal: AbortSignal): Promise<RegionShape> {
  return readRegion(await textAt(src, signal))
}

/** @throws Refusal, or the error of `fetch` */
async function textAt(src: string, signal: AbortSignal): Promise<string> {
  const response = await fetch(src, { signal })
  if (!response.ok) refuse((words) => words.notLoaded(src, response.status))
  return response.text()
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
