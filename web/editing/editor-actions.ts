// SPDX-License-Identifier: GPL-3.0-or-later
import type { Box, Circle, Edit, Point } from '../lib/index.ts'
import type { LinkInput, LinkState, LinkView } from '../lib/link.ts'
import { plainRegion } from '../lib/regions/region-shape.ts'
import { gridSpacing } from '../view/axes.ts'
import { boundingBox } from '../view/camera.ts'
import { boxOf, type Domain, NO_DOMAIN } from '../view/domain.ts'
import type { GestureTarget, IdentifiedCircle } from '../view/gestures.ts'
import { keptLayers, type Layers, layersFrom } from '../view/layers.ts'
import { roundStep } from '../view/round-step.ts'
import type { Edited } from '../view/scene-client.ts'
import { short } from '../view/short.ts'
import { middleOf, nextInDirection, scaled, snappedInPlace, snappedInSize, stepped } from './arranging.ts'
import { NO_ATTRIBUTES } from './attributes.ts'
import { CameraActions, isSameCamera, USUAL_RADIUS } from './camera-actions.ts'
import type { CircleSet } from './history.ts'
import { circlesOfLink, regionOfLink, viewOfLink } from './scene-link.ts'
import { type Tool, withSelection } from './state.ts'
import { ENGLISH_EDITING } from './words.ts'

/** Initial length of a path, relative to the view's width. */
const PATH_SHARE = 0.6
/** Offset of a copy from its original, in pixels. */
const ASIDE = 16

/** Circles to open, with the viewport, layers and step of a link. */
export interface OpenRequest extends CircleSet {
  readonly edits?: readonly Edit[] | undefined
  readonly view?: LinkView | undefined
  readonly layers?: LinkState['layers']
  /** The step of playback. If `step` is missing, a running player restarts. */
  readonly step?: number | undefined
  /** The method to play. Default: the usual one. */
  readonly method?: string | undefined
}

/** The loading stage of circles. */
export type Stage = 'loading' | 'computing' | 'clipping' | 'fitting' | 'repeating' | 'opened' | 'refused'

/** The result of an opening. `superseded` means that a later request replaced it. */
export type HowOpened = 'opened' | 'refused' | 'superseded'

/**
 * Everything that a user can do with circles. Input handlers and panels call these methods; apart from results of the
 * backend, nothing else changes the state.
 */
export class EditorActions extends CameraActions implements GestureTarget {
  /** Whether the circles can be selected but not edited. */
  isReadonly = false
  /** Links to named data sets with more circles than this store only the name. */
  protected readonly mostNamed: number = 0
  /** The texts for screen readers. */
  words = ENGLISH_EDITING
  /** A circle within a sentence: its name, or its number. */
  readonly called = (id: number): string => this.words.called(id, this.editing.nameOf(id))
  /** Called at each stage with the number of circles, 0 if unknown. */
  onstage: (stage: Stage, circles: number) => void = () => {}
  #lastLoad = 0
  /** Stops waiting for a download that may never finish. */
  #stopLoading: () => void = () => {}
  #isPanning = false
  #pending: Promise<unknown> | undefined

  get tool(): Tool {
    return this.#isPanning ? 'pan' : this.store.get().tool
  }

  get snaps(): boolean {
    return this.store.get().isSnapping
  }

  circle(id: number): Circle | undefined {
    return this.isReadonly ? undefined : this.editing.circles.get(id)
  }

  beginGesture(): number {
    return this.editing.beginGesture()
  }

  /** The current state in the form of a link; `undefined` before the first opening. */
  linkState(): LinkInput | undefined {
    const { scene, circles, domain, areas, colors } = this.editing
    if (scene === undefined) return undefined
    const { camera, size } = this.view
    const layers = keptLayers(this.view.layers)
    const { step, method } = this.store.get()
    // A data set has its own attributes, and areas are stored in the order of the circles.
    const hasOther = this.editing.attributes !== (scene.attributes ?? NO_ATTRIBUTES)
    const isWritten = Array.isArray(areas) || hasOther
    const said = isWritten ? { circles: circles.circles() } : circlesOfLink(scene, circles, this.mostNamed)
    const attributes = said.circles && this.editing.fileAttributes
    const hasCircles = said.circles !== undefined || said.edits !== undefined
    return {
      ...said,
      ...(hasCircles && colors !== undefined && { colors }),
      ...(attributes && { attributes }),
      ...regionOfLink(scene, domain),
      ...(domain.lattice && { lattice: domain.lattice }),
      ...(areas !== undefined && { areas }),
      ...(!this.isWhole && { view: viewOfLink(camera, size) }),
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
      this.complain('')
      const opened = await Promise.race([load(), stopped])
      if (opened === undefined || isSuperseded()) return 'superseded'
      const { edits, view, layers, step, method, ...scene } = opened
      const before = { camera: this.view.camera, selection: this.store.get().selection }
      this.select([])
      const cameraNow = () => this.looking(view, boxOf(boundingBox(scene.circles), scene.domain ?? NO_DOMAIN))
      const camera = cameraNow()
      this.view.setCamera(camera)
      this.onstage('computing', scene.circles.length / 3)
      const edited = await this.editing.open(scene, edits)
      if (isSuperseded()) return 'superseded'
      if (edited === undefined) {
        this.view.setCamera(before.camera)
        const { problem } = this.store.get()
        this.select(before.selection)
        this.complain(problem)
        return 'refused'
      }
      end = 'opened'
      // A panel may have opened beside the picture since, which changes the padding.
      if (this.view.camera === camera && !isSameCamera(camera, cameraNow())) this.view.setCamera(cameraNow())
      if (layers !== undefined) this.view.setLayers(layersFrom(layers))
      else this.#forgetPlaces()
      this.useTool('select')
      this.select([])
      const isPlayed = this.store.get().step !== undefined
      if ('step' in opened) this.store.update((state) => ({ ...state, step, method, stage: undefined }))
      else this.showStep(isPlayed ? 0 : undefined)
      return 'opened'
    } catch (error) {
      if (isSuperseded()) return 'superseded'
      this.complain((error as Error).message)
      return 'refused'
    } finally {
      if (!isSuperseded()) this.onstage(end, this.editing.circles.count)
    }
  }

  /** Cancels the current opening; the circles stay. */
  cancelOpening(): void {
    // Drops circles that are still loading.
    if (!this.view.cancel()) {
      this.#lastLoad += 1
      this.#stopLoading()
      this.onstage('refused', 0)
    }
  }

  /** Removes layers that refer to positions among the former circles. */
  #forgetPlaces(): void {
    const { path, nearZero, maxDistance } = this.view.layers
    if (path === undefined && nearZero === undefined && maxDistance === undefined) return
    this.view.setLayers({ path: path && this.pathAcross(), nearZero: undefined, maxDistance: undefined })
  }

  /** A path across the visible part of the plane. */
  pathAcross(): NonNullable<Layers['path']> {
    const { camera, size } = this.view
    const half = (PATH_SHARE * size.width) / camera.scale / 2
    return { from: { x: camera.x - half, y: camera.y }, to: { x: camera.x + half, y: camera.y } }
  }

  /** The selected circles, with pending edits applied. */
  selectedCircles(): IdentifiedCircle[] {
    if (this.isReadonly) return []
    return this.store.get().selection.flatMap((id) => {
      const circle = this.editing.latest(id)
      return circle === undefined ? [] : [{ id, circle }]
    })
  }

  set(changes: readonly IdentifiedCircle[], gesture = this.beginGesture()): void {
    // A drag may continue after the keyboard removed one of its circles.
    const there = changes.filter(({ id }) => this.editing.latest(id) !== undefined)
    if (there.length > 0)
      this.editing.edit(
        there.map(({ id, circle }) => ({ kind: 'replace', id, circle })),
        gesture,
      )
  }

  /**
   * Changes the region or the areas (in the order of the circles), and edits circles, in one undo step. Resolves to
   * `undefined` if refused.
   * @throws CircleVoronoiError `badOption` if the region is invalid
   */
  setDomain(change: Partial<Domain>, gesture?: number, edits: readonly Edit[] = []): Promise<Edited | undefined> {
    const { region } = change
    const plain = region === undefined ? change : { ...change, region: plainRegion(region) }
    return this.editing.edit(edits, gesture, plain)
  }

  /** Applies all edits or none as one undo step. Resolves to `undefined` if refused. */
  edit(edits: readonly Edit[]): Promise<Edited | undefined> {
    return this.editing.edit(edits)
  }

  /** Shows a problem in one sentence. An empty text clears it. */
  complain(problem: string): void {
    this.store.update((state) => ({ ...state, problem }))
  }

  /** Adds circles and selects them. Returns their ids, or none if they were refused. */
  add(circles: readonly Circle[], gesture = this.beginGesture()): Promise<readonly number[]> {
    return this.#selecting(() => this.#add(circles, gesture))
  }

  async #add(circles: readonly Circle[], gesture: number): Promise<readonly number[]> {
    if (this.isReadonly) return []
    const edited = await this.editing.edit(
      circles.map((circle) => ({ kind: 'insert', circle })),
      gesture,
    )
    if (edited === undefined) return []
    const ids = [...edited.inserted]
    this.select(ids)
    this.#say(ids.length === 1 ? this.words.added(this.called(ids[0] as number)) : this.words.addedMany(ids.length))
    return ids
  }

  async addFitting(center: Point): Promise<void> {
    const circle = this.fitted(center)
    if (circle !== undefined) await this.add([circle])
  }

  /** Adds a circle where there is room for it, as near as possible to the middle of the view. */
  async addInRoom(): Promise<void> {
    if (this.isReadonly) return
    const gesture = this.beginGesture()
    const { x, y, scale } = this.view.camera
    const usual = USUAL_RADIUS / scale
    const room = await this.view.ask('room', x, y)
    const circle = room === undefined ? { x, y, r: usual } : { ...room, r: Math.min(room.r, usual) }
    const ids = await this.add([circle], gesture)
    if (ids[0] !== undefined) this.revealCircle(ids[0])
  }

  /** A new circle at a point, with some room to the nearest circle; `undefined` where none fits. */
  fitted({ x, y }: Point): Circle | undefined {
    if (this.isReadonly) return undefined
    const usual = USUAL_RADIUS / this.view.camera.scale
    const nearest = this.view.hitAt({ x, y }, 0)
    const other = nearest === undefined ? undefined : this.circle(nearest.id)
    const room = other === undefined ? 2 * usual : Math.hypot(x - other.x, y - other.y) - other.r
    return { x, y, r: room > 0 ? Math.min(usual, room / 2) : usual }
  }

  /** Adds copies of the selected circles at an offset. */
  async duplicateSelected(): Promise<void> {
    const aside = roundStep(ASIDE / this.view.camera.scale)
    const circles = this.selectedCircles().map(({ circle: { x, y, r } }) => ({
      x: stepped(x, aside),
      y: stepped(y, -aside),
      r,
    }))
    const { length } = circles.length > 0 ? await this.add(circles) : []
    if (length > 0) this.#say(this.words.duplicated(length))
  }

  /** Adds copies of circles: at an offset, or in the middle of the view if they are outside. */
  async paste(circles: readonly Circle[], times: number): Promise<void> {
    const { x, y } = middleOf(circles)
    const { camera } = this.view
    const aside = times * roundStep(ASIDE / camera.scale)
    const [dx, dy] = this.shows({ x, y }) ? [aside, -aside] : [camera.x + aside - x, camera.y - aside - y]
    await this.add(circles.map((circle) => ({ x: stepped(circle.x, dx), y: stepped(circle.y, dy), r: circle.r })))
  }

  cancel(gesture: number): void {
    this.editing.cancel(gesture)
  }

  /** Shows a step of a method; `undefined` ends playback. `stage` is that of the state. */
  showStep(step: number | undefined, method = this.store.get().method, stage?: string): void {
    this.store.update((state) => {
      const isSame = state.step === step && state.method === method && state.stage === stage
      return isSame ? state : { ...state, step, method, stage }
    })
  }

  useTool(tool: Tool): void {
    this.store.update((state) => (state.tool === tool ? state : { ...state, tool }))
  }

  /** Switches the tool for adding circles on or off. */
  toggleAdding(): void {
    this.useTool(this.store.get().tool === 'add' ? 'select' : 'add')
  }

  /** Lets drags pan while a key is held. */
  holdPanning(isHeld: boolean): void {
    this.#isPanning = isHeld
  }

  toggleSnapping(): void {
    const isSnapping = !this.snaps
    this.store.update((state) => ({ ...state, isSnapping }))
    this.#say(isSnapping ? this.words.snaps : this.words.snapsNot)
  }

  async removeSelected(): Promise<void> {
    const ids = this.selectedCircles().map(({ id }) => id)
    if (ids.length === 0) return
    this.select([])
    const edited = await this.editing.edit(ids.map((id) => ({ kind: 'remove', id })))
    if (edited === undefined) return
    this.#say(ids.length === 1 ? this.words.deleted(this.called(ids[0] as number)) : this.words.deletedMany(ids.length))
  }

  /** Moves the selected circles in steps that keep their coordinates short. */
  moveSelected(dx: number, dy: number, gesture: number): void {
    this.#changeSelected(({ x, y, r }) => ({ x: stepped(x, dx), y: stepped(y, dy), r }), gesture)
  }

  /** Changes a single radius by a step, not below zero, or scales several circles by a factor. */
  growSelected(dr: number, factor: number, gesture: number): void {
    const held = this.selectedCircles()
    if (held.length === 1) this.#changeSelected(({ x, y, r }) => ({ x, y, r: Math.max(stepped(r, dr), 0) }), gesture)
    else this.#scale(held, factor, gesture)
  }

  #scale(held: readonly IdentifiedCircle[], factor: number, gesture: number): void {
    const middle = middleOf(held.map(({ circle }) => circle))
    this.set(
      held.map(({ id, circle }) => ({ id, circle: scaled(circle, middle, factor) })),
      gesture,
    )
  }

  #changeSelected(change: (circle: Circle) => Circle, gesture: number): void {
    const changed = this.selectedCircles().map(({ id, circle }) => ({ id, circle: change(circle) }))
    this.set(changed, gesture)
    const [only, ...others] = changed
    if (only === undefined) return
    const { x, y, r } = only.circle
    const numbers = () => this.words.numbers(this.called(only.id), short(x), short(y), short(r))
    this.#say(others.length === 0 ? numbers() : this.words.moved(changed.length))
  }

  select(ids: readonly number[]): void {
    this.store.update((state) => {
      if (ids.length === state.selection.length && ids.every((id, k) => id === state.selection[k])) return state
      return { ...withSelection(state, ids, this.editing.circles), described: undefined, problem: '' }
    })
  }

  isSelected(id: number): boolean {
    return this.store.get().selection.includes(id)
  }

  /** Adds a circle to the selection, or removes it. */
  toggle(id: number): void {
    const { selection } = this.store.get()
    this.select(selection.includes(id) ? selection.filter((other) => other !== id) : [...selection, id])
  }

  /** Adds the circles with centers in a box to the selection. */
  selectWithin(box: Box): void {
    const { selection } = this.store.get()
    this.select([...new Set([...selection, ...this.editing.circles.within(box)])])
    this.#saySelected()
  }

  selectAll(): void {
    this.select([...this.editing.circles.ids()])
    this.#saySelected()
  }

  /** Selects a circle and brings it into view. */
  goTo(id: number): void {
    this.select([id])
    this.revealCircle(id)
  }

  /** Selects the circle nearest to the middle of the view. */
  selectNearMiddle(): void {
    const hit = this.view.hitAt(this.view.camera, 0)
    if (hit !== undefined) this.select([hit.id])
  }

  /** Selects the next or previous circle by number. Returns whether there is one. */
  selectNext(step: 1 | -1): boolean {
    const last = this.store.get().selection.at(-1)
    const next = last === undefined ? undefined : this.editing.circles.next(last + step, step)
    if (next !== undefined) this.goTo(next)
    return next !== undefined
  }

  /** Selects the neighbor in a direction of length 1. */
  selectNeighbor(direction: readonly [number, number]): void {
    const { circle } = this.store.get()
    const next = circle === undefined ? undefined : nextInDirection(circle, this.#neighbors(), direction)
    if (next !== undefined) this.goTo(next.id)
  }

  /**
   * Snaps a dragged circle to its neighbors or the grid if they are within a distance. `sizes` means that the drag
   * changes its radius.
   */
  snapped(circle: Circle, within: number, sizes: boolean): Circle {
    const grid = gridSpacing(this.view.camera.scale)
    // Circles on a visible grid always have its coordinates, and do not touch their neighbors instead.
    const snapping = this.view.layers.grid
      ? { others: [], grid, within: grid }
      : { others: this.#neighbors(), grid, within }
    return sizes ? snappedInSize(circle, snapping) : snappedInPlace(circle, snapping)
  }

  /** The neighbors of the selected circles that are not selected. */
  #neighbors(): (Circle & { id: number })[] {
    const ids = this.store.get().described?.neighbors ?? []
    return [...ids].flatMap((id) => {
      const circle = this.editing.circles.get(id)
      return circle === undefined ? [] : [{ ...circle, id }]
    })
  }

  #say(text: string): void {
    this.store.update((state) => ({ ...state, said: { text } }))
  }

  #saySelected(): void {
    const count = this.store.get().selection.length
    if (count !== 1) this.#say(this.words.selected(count))
  }

  hover(id: number | undefined): void {
    this.store.update((state) => (state.hovered === id ? state : { ...state, hovered: id }))
  }

  /** Ends the current tool; without one, clears the selection. */
  release(): void {
    if (this.store.get().tool !== 'select') this.useTool('select')
    else this.select([])
  }

  /** Changes some of the layers. */
  setLayers(change: Partial<Layers>): void {
    this.view.setLayers(change)
  }

  undo(): Promise<void> {
    return this.#selecting(() => this.#go(() => this.editing.undo()))
  }

  redo(): Promise<void> {
    return this.#selecting(() => this.#go(() => this.editing.redo()))
  }

  /** Settles once all edits that select circles are done; `undefined` if none are pending. */
  get pending(): Promise<unknown> | undefined {
    return this.#pending
  }

  #selecting<Result>(edit: () => Promise<Result>): Promise<Result> {
    const edited = edit()
    const all = Promise.allSettled([this.#pending, edited]).then(() => {
      if (this.#pending === all) this.#pending = undefined
    })
    this.#pending = all
    return edited
  }

  async #go(go: () => Promise<Edited | undefined>): Promise<void> {
    if (this.isReadonly) return
    const { scene } = this.editing
    const { lattice } = this.editing.domain
    const edited = await go()
    const ids = [...(edited?.inserted ?? [])]
    if (ids.length > 0) this.select(ids)
    if (ids.length === 1) this.revealCircle(ids[0] as number)
    if (this.editing.scene !== scene) this.view.setCamera(this.fittedTo(this.editing.circles.box()))
    // Circles may have moved into the box, or back.
    else if (this.editing.domain.lattice !== lattice) this.look(undefined)
  }
}
