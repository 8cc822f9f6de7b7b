// SPDX-License-Identifier: GPL-3.0-or-later
import { Editing } from '../editing/editing.ts'
import { namesOf, ownColorsOf } from '../editing/identity.ts'
import { requestOf } from '../editing/open-request.ts'
import { cameraShowing } from '../editing/scene-link.ts'
import { initialState } from '../editing/state.ts'
import { checkOptionNames, isRecord, refuseInput, refuseOption, shown } from '../lib/base/check.ts'
import { coordinatesOf } from '../lib/base/coordinates.ts'
import { METHODS, type Method } from '../lib/base/types.ts'
import { Diagram } from '../lib/diagram/diagram.ts'
import { decodeLink, encodeLinkAtOnce, type LinkInput, type LinkState } from '../lib/link.ts'
import { loadMetrics } from '../lib/metrics.ts'
import { circleVoronoiOf } from '../lib/wasm/library.ts'
import { compileCircleVoronoi, type LoadOptions } from '../lib/wasm/load-options.ts'
import { Trace } from '../lib/wasm/trace.ts'
import { testedAt } from '../player/discs.ts'
import { circlesAt, overlayOf } from '../player/step-overlay.ts'
import { type Step, stepsOf } from '../player/steps.ts'
import { boundingBox } from '../view/camera.ts'
import { boxOf, NO_DOMAIN } from '../view/domain.ts'
import { layersFrom, type OverlayLayer, withoutDiagram } from '../view/layers.ts'
import { traced } from '../view/painter/traced.ts'
import { createStore } from '../view/store.ts'
import { svgPicture, titlesOf } from '../view/svg-picture.ts'
import { isCssColor } from './css-color.ts'
import { SceneBackend } from './scene-backend.ts'
import type { Scheme } from './scheme.ts'
import { playerColors, themeStyle } from './theme.ts'

/**
 * Options of `renderSVG`.
 *
 * @category Pictures
 */
export interface PictureOptions extends LoadOptions {
  /** The width in pixels. Default: 720. */
  readonly width?: number | undefined
  /** The height in pixels. Default: 480. */
  readonly height?: number | undefined
  /** The colors. Default: `light`. */
  readonly scheme?: Scheme | undefined
}

/** Margin around the circles if all are visible, in pixels, the same as in an element without buttons. */
const MARGIN = { top: 16, right: 16, bottom: 16, left: 16 }
const LONGEST_SIDE = 100_000

/**
 * Draws a state like an element or the playground, and returns the text of an SVG. An element of this size returns the
 * same bytes from `toSVG`. Without a view, all circles are visible.
 *
 * @param state a state as `getState` returns it, or a link with circles as text. A link to a data set of the playground
 *   does not work, because it contains no circles
 * @throws CircleVoronoiError as `decodeLink` and `compute`; `badInput`, `badOption`
 *
 * @category Pictures
 * @example
 * import { renderSVG } from 'circle-voronoi/picture'
 *
 * const svg = await renderSVG({ circles: [[0, 0, 2], [10, 0, 1], [5, 8, 1.5]], layers: { hull: true } })
 */
export async function renderSVG(state: LinkInput | string, options: PictureOptions = {}): Promise<string> {
  checkOptionNames(options, 'renderSVG', ['width', 'height', 'scheme', 'wasm'])
  const { width = 720, height = 480, scheme = 'light' } = options
  for (const [name, side] of Object.entries({ width, height })) {
    const isRight = typeof side === 'number' && side >= 1 && side <= LONGEST_SIDE
    if (!isRight) refuseOption(`The option ${name} is a number from 1 to ${LONGEST_SIDE}, not ${shown(side)}.`)
  }
  if (scheme !== 'light' && scheme !== 'dark')
    refuseOption(`The option scheme is "light" or "dark", not ${shown(scheme)}.`)
  const said = await checked(state)
  const { edits, view, layers: given, step, method, ...request } = requestOf(said)
  const { circles, domain = NO_DOMAIN } = request

  const computer = new SceneBackend(await circleVoronoiOf(await compileCircleVoronoi(options)))
  const { scene } = computer
  try {
    let problem: Error | undefined
    const editing = new Editing(
      createStore(initialState()),
      computer,
      () => {},
      (error) => {
        problem ??= error
      },
    )
    await editing.open(request, edits)
    if (problem !== undefined) throw problem
    const size = { width, height }
    const box = boxOf(boundingBox(circles), domain)
    const frame = { ...cameraShowing(view, box, size, MARGIN), ...size }
    const style = themeStyle(scheme)
    const played = step === undefined ? undefined : playedAt(computer, step, method, scheme)
    const layers = played === undefined ? layersFrom(given) : withoutDiagram(layersFrom(given))
    scene.setLayers({ ...layers, ownColors: ownColorsOf(editing, isCssColor) })
    if (scene.isMethodMissing) scene.addMethod()
    if (scene.isPowerMissing) scene.addPower(await loadMetrics({ library: scene.library }))
    const drawn = { lattice: domain.lattice, areSites: domain.areas !== undefined }
    const names = { list: namesOf(editing), circles: editing.circles, domain: drawn }
    const above = played ?? []
    return svgPicture(frame, scene.svg(frame, style, titlesOf(names, above)), style, layers, names, above)
  } finally {
    scene.dispose()
  }
}

/** Checks all fields of a state like the fields of a link. */
async function checked(state: LinkInput | string): Promise<LinkState & { circles: Float64Array }> {
  if (typeof state !== 'string' && !isRecord(state)) {
    refuseInput(`renderSVG takes a state or a link, not ${shown(state)}.`)
  }
  const said =
    typeof state === 'string'
      ? await decodeLink(state.replace(/^.*#/s, ''))
      : {
          // A picture may have more circles than a link.
          ...(await decodeLink(encodeLinkAtOnce(hasData(state) ? state : { ...state, circles: undefined }))),
          ...((state.circles ?? undefined) !== undefined && { circles: coordinatesOf(state.circles as never) }),
        }
  const { circles, dataSet } = said
  if (circles === undefined) {
    const reason = dataSet === undefined ? 'has no circles' : `names the data set "${dataSet}" of the playground`
    refuseInput(`The state ${reason}: renderSVG needs the circles themselves.`)
  }
  return { ...said, circles }
}

/** Whether a state has data about each circle, which is checked together with the circles. */
function hasData({ names, attributes }: LinkInput): boolean {
  return names !== undefined || attributes !== undefined
}

/** Returns the overlay after a step; `undefined` for the last step, which shows the diagram. */
function playedAt(
  { scene, circles: table }: SceneBackend,
  step: number,
  method: string | undefined,
  scheme: Scheme,
): readonly OverlayLayer[] | undefined {
  const known = METHODS.find((name) => name === method) ?? ('touching-disc' satisfies Method)
  const [given, ids] = [table.circles(), table.ids()]
  const { diagram, events } = traced(scene.library, given, ids, { method: known })
  const trace = new Trace(new Diagram(diagram), events)
  const steps = stepsOf(trace)
  if (step >= steps.length - 1) return undefined
  const current = steps[step] as Step
  const state = trace.at(current.end)
  const circles = circlesAt(trace, given, state, ids)
  const tested = testedAt(trace, current, state, (id) => circles.get(id))
  return overlayOf(trace, current, state, tested, circles, playerColors(scheme))
}
