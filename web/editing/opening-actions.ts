// SPDX-License-Identifier: GPL-3.0-or-later

import { COORDINATE_LIMIT, SMALLEST_INPUT } from '../lib/base/coordinate-limits.ts'
import type { Point } from '../lib/index.ts'
import type { LinkInput } from '../lib/link.ts'
import { boundingBox } from '../view/camera.ts'
import { boxOf, NO_DOMAIN } from '../view/domain.ts'
import { keptLayers, type Layers, layersFrom } from '../view/layers.ts'
import { HANDLE_RADIUS } from '../view/overlay.ts'
import { fileAttributes, NO_ATTRIBUTES } from './attributes.ts'
import { isSameCamera } from './camera-actions.ts'
import type { FigureParts, SharedActions } from './figure-actions.ts'
import type { OpenRequest } from './open-request.ts'
import { circlesOfLink, regionOfLink, viewOfLink } from './scene-link.ts'
import { showStep } from './state.ts'

/** Initial length of a path, relative to the width that no panel covers. */
const PATH_SHARE = 0.6
/** The rows where an end of a path is tried, relative to the height that no panel covers. */
const PATH_ROWS = [0, 0.1, -0.1, 0.2, -0.2, 0.3, -0.3]

/** Whether the numbers are in the range of `compute`. */
function isInRange(circles: Float64Array): boolean {
  const largest = circles.reduce((most, value) => Math.max(most, Math.abs(value)), 0)
  return largest === 0 || (largest >= SMALLEST_INPUT && largest <= COORDINATE_LIMIT)
}

/** The loading stage of circles. */
export type Stage = 'loading' | 'computing' | 'clipping' | 'fitting' | 'repeating' | 'opened' | 'refused'

/** The result of an opening. `superseded` means that a later request replaced it. */
export type HowOpened = 'opened' | 'refused' | 'superseded'

/** Opening circles, and the link that opens the current ones. */
export class OpeningActions {
  readonly #figure: FigureParts
  readonly #actions: SharedActions
  /** Links to named data sets with more circles than this store only the name. */
  mostNamed = 0
  /** Called with each request that was opened. */
  onopened: (request: OpenRequest) => void = () => {}
  /** Called at each stage with the number of circles, 0 if unknown. */
  onstage: (stage: Stage, circles: number) => void = () => {}
  #lastLoad = 0
  /** Stops waiting for a download that may never finish. */
  #stopLoading: () => void = () => {}

  constructor(figure: FigureParts, actions: SharedActions) {
    this.#figure = figure
    this.#actions = actions
  }

  /** The current state in the form of a link; `undefined` before the first opening. */
  linkState(): LinkInput | undefined {
    const { scene, circles, domain, areas, colors } = this.#figure.editing
    if (scene === undefined) return undefined
    const { camera, size } = this.#figure.view
    const layers = keptLayers(this.#figure.view.layers)
    const { step, method } = this.#figure.store.get()
    // A data set has its own attributes, and areas are stored in the order of the circles.
    const hasOther = this.#figure.editing.attributes !== (scene.attributes ?? NO_ATTRIBUTES)
    const isWritten = Array.isArray(areas) || hasOther
    const said = isWritten ? { circles: circles.circles() } : circlesOfLink(scene, circles, this.mostNamed)
    const attributes = said.circles && fileAttributes(this.#figure.editing)
    const hasCircles = said.circles !== undefined || said.edits !== undefined
    return {
      ...said,
      ...(hasCircles && colors !== undefined && { colors }),
      ...(attributes && { attributes }),
      ...(said.circles && scene.headings && { headings: scene.headings }),
      ...regionOfLink(scene, domain),
      ...(domain.lattice && { lattice: domain.lattice }),
      ...(areas !== undefined && { areas }),
      ...(!this.#actions.camera.isWhole && { view: viewOfLink(camera, size) }),
      ...(Object.keys(layers).length > 0 && { layers }),
      ...(step !== undefined && { step, method }),
    }
  }

  /** Whether circles have been opened or are being opened. */
  get hasOpened(): boolean {
    return this.#lastLoad > 0
  }

  /** Opens circles once they are loaded, unless a later request replaces them. A refusal changes nothing. */
  async open(load: () => Promise<OpenRequest>): Promise<HowOpened> {
    this.#lastLoad += 1
    this.#stopLoading()
    const stopped = new Promise<undefined>((resolve) => {
      this.#stopLoading = () => resolve(undefined)
    })
    const turn = this.#lastLoad
    const isSuperseded = () => turn !== this.#lastLoad
    let end: Stage = 'refused'
    try {
      this.onstage('loading', 0)
      // Opening new circles clears the previous problem.
      this.#actions.messages.complain('')
      const opened = await Promise.race([load(), stopped])
      if (opened === undefined || isSuperseded()) return 'superseded'
      const { edits, view, layers, step, method, ...scene } = opened
      const before = { camera: this.#figure.view.camera, selection: this.#figure.store.get().selection }
      this.#actions.selection.select([])
      const cameraNow = () =>
        this.#actions.camera.cameraFor(view, boxOf(boundingBox(scene.circles), scene.domain ?? NO_DOMAIN))
      const camera = cameraNow()
      // The camera moves before circles are computed, so that they are painted where they are seen. Circles out of range
      // will be refused, and the former ones cannot be painted at their scale.
      if (isInRange(scene.circles)) this.#figure.view.setCamera(camera)
      this.onstage('computing', scene.circles.length / 3)
      const edited = await this.#figure.editing.open(scene, edits)
      if (isSuperseded()) return 'superseded'
      if (edited === undefined) {
        this.#figure.view.setCamera(before.camera)
        const { problem } = this.#figure.store.get()
        this.#actions.selection.select(before.selection)
        this.#actions.messages.complain(problem)
        return 'refused'
      }
      end = 'opened'
      // A panel may have opened beside the picture since, which changes the padding.
      if (this.#figure.view.camera === camera && !isSameCamera(camera, cameraNow()))
        this.#figure.view.setCamera(cameraNow())
      if (layers !== undefined) this.#figure.view.setLayers(layersFrom(layers))
      else this.#forgetPlaces()
      this.#actions.tools.useTool('select')
      const isPlayed = this.#figure.store.get().step !== undefined
      if ('step' in opened) this.#figure.store.update((state) => ({ ...state, step, method, stage: undefined }))
      else showStep(this.#figure.store, isPlayed ? 0 : undefined)
      this.onopened(opened)
      return 'opened'
    } catch (error) {
      if (isSuperseded()) return 'superseded'
      this.#actions.messages.complain((error as Error).message)
      return 'refused'
    } finally {
      if (!isSuperseded()) this.onstage(end, this.#figure.editing.circles.count)
    }
  }

  /** Cancels the current opening, fit or edit; the circles stay. */
  cancelOpening(): void {
    // Drops circles that are still loading.
    if (!this.#figure.editing.cancelFit() && !this.#figure.view.scene.cancel()) {
      this.#lastLoad += 1
      this.#stopLoading()
      this.onstage('refused', 0)
    }
  }

  /** Removes layers that refer to positions among the former circles. */
  #forgetPlaces(): void {
    const { path, nearZero, maxDistance } = this.#figure.view.layers
    if (path === undefined && nearZero === undefined && maxDistance === undefined) return
    this.#figure.view.setLayers({ path: path && this.pathAcross(), nearZero: undefined, maxDistance: undefined })
  }

  /** A path across the part of the plane that no panel covers, with its ends outside of circles. */
  pathAcross(): NonNullable<Layers['path']> {
    const { minX, minY, maxX, maxY } = this.#actions.camera.uncovered
    const margin = ((1 - PATH_SHARE) / 2) * (maxX - minX)
    const slack = HANDLE_RADIUS / this.#figure.view.camera.scale
    const endAt = (x: number): Point => {
      const places = PATH_ROWS.map((row) => ({ x, y: (minY + maxY) / 2 + row * (maxY - minY) }))
      const isFree = (place: Point) => [undefined, 'cell'].includes(this.#figure.view.hitAt(place, slack)?.part)
      return places.find(isFree) ?? (places[0] as Point)
    }
    return { from: endAt(minX + margin), to: endAt(maxX - margin) }
  }
}
