// SPDX-License-Identifier: GPL-3.0-or-later
import type { Box, Circle, Edit, Point } from '../lib/index.ts'
import { decodeLink, type LinkInput, type LinkState, type LinkView } from '../lib/link.ts'
import { boundingBox, type Camera, fitted, type Padding, panned, toScreen, zoomed } from '../view/camera.ts'
import { keptLayers, type Layers, layersFrom } from '../view/layers.ts'
import type { Edited } from '../view/painter.ts'
import type { Hands } from '../view/pointer.ts'
import type { View } from '../view/view.ts'
import { DATA_SETS, type DataSet, dataSetOf, loadDataSet, nameOf } from './data-sets.ts'
import type { Editing } from './editing.ts'
import type { Read } from './files/files-protocol.ts'
import type { Scene } from './history.ts'
import { cameraOf, circlesOfLink, viewOfLink } from './scene-link.ts'
import type { State } from './state.ts'
import type { Store } from './store.ts'

/** How far one may zoom in from the picture without outliers, and out from the whole one. */
const LARGEST_ZOOM = 1e7
const SMALLEST_ZOOM = 0.05
/** The radius of a circle that is added with room around, in pixels. */
const USUAL_RADIUS = 24

/** What a link may say beside its circles. */
interface Opened {
  readonly edits?: readonly Edit[] | undefined
  readonly view?: LinkView | undefined
  readonly layers?: LinkState['layers']
}

/** All that a user can do. Input and panels call these; nothing else changes the state, but for what was computed. */
export class Actions implements Hands {
  readonly #store: Store<State>
  readonly #editing: Editing
  readonly #view: View
  readonly #padding: () => Padding
  #lastLoad = 0

  constructor(store: Store<State>, editing: Editing, view: View, padding: () => Padding) {
    this.#store = store
    this.#editing = editing
    this.#view = view
    this.#padding = padding
  }

  get isAdding(): boolean {
    return this.#store.get().isAdding
  }

  circle(id: number): Circle | undefined {
    return this.#editing.circles.get(id)
  }

  beginGesture(): number {
    return this.#editing.beginGesture()
  }

  /** Circles of the menu. */
  async load(id: string): Promise<void> {
    const dataSet = DATA_SETS.find((dataSet) => dataSet.id === id)
    if (dataSet !== undefined) await this.#opening(() => this.#loadNamed(nameOf(dataSet)))
  }

  /** What a link says; reports whether that could be shown. */
  openLink(text: string): Promise<boolean> {
    return this.#opening(() => this.#linked(text))
  }

  /** What is read somewhere; reports whether that could be shown. */
  openRead(read: () => Promise<Read>): Promise<boolean> {
    return this.#opening(async () => {
      const result = await read()
      return 'link' in result ? this.#linked(result.link) : { circles: result.circles, dataSet: '', isEdited: false }
    })
  }

  /** What is shown, to be kept or sent; `undefined`: nothing yet. */
  linkState(): LinkInput | undefined {
    const { scene, circles } = this.#editing
    if (scene === undefined) return undefined
    const { camera, size } = this.#view
    const isWhole = isSame(camera, this.#fitted(circles.box()))
    const layers = keptLayers(this.#view.layers)
    return {
      ...circlesOfLink(scene, circles),
      ...(!isWhole && { view: viewOfLink(camera, size) }),
      ...(Object.keys(layers).length > 0 && { layers }),
    }
  }

  async #linked(text: string): Promise<Scene & Opened> {
    const { circles, dataSet, edits, view, layers = {} } = await decodeLink(text)
    const scene =
      circles === undefined
        ? await this.#loadNamed(dataSet ?? nameOf(DATA_SETS[0] as DataSet))
        : { circles, dataSet: '', isEdited: false }
    return { ...scene, edits, view, layers }
  }

  async #loadNamed(name: string): Promise<Scene> {
    return { circles: await loadDataSet(name), dataSet: dataSetOf(name) === undefined ? '' : name, isEdited: false }
  }

  /** Opens what is loaded, unless something else is asked for meanwhile. What cannot be opened changes nothing. */
  async #opening(load: () => Promise<Scene & Opened>): Promise<boolean> {
    this.#lastLoad += 1
    const turn = this.#lastLoad
    try {
      const { edits, view, layers, ...scene } = await load()
      if (turn !== this.#lastLoad) return false
      const before = this.#view.camera
      this.#view.setCamera(this.#looking(view, boundingBox(scene.circles)))
      if ((await this.#editing.open(scene)) === undefined) {
        this.#view.setCamera(before)
        return false
      }
      if (layers !== undefined) this.#view.setLayers(layersFrom(layers))
      if (edits !== undefined && edits.length > 0) await this.#editing.edit(edits)
      this.#store.update((state) => ({ ...state, isAdding: false }))
      this.select(undefined)
      return true
    } catch (error) {
      this.#store.update((state) => ({ ...state, problem: (error as Error).message }))
      return false
    }
  }

  set(id: number, circle: Circle, gesture = this.beginGesture()): void {
    // A drag may go on where the circle was removed by a key.
    if (this.#editing.latest(id) !== undefined) this.#editing.edit([{ kind: 'replace', id, circle }], gesture)
  }

  /** Adds a circle and selects it. */
  async add(circle: Circle, gesture = this.beginGesture()): Promise<number | undefined> {
    const edited = await this.#editing.edit([{ kind: 'insert', circle }], gesture)
    const id = edited?.inserted[0]
    this.#store.update((state) => ({ ...state, isAdding: false }))
    if (id !== undefined) this.select(id)
    return id
  }

  async addFitting({ x, y }: Point): Promise<void> {
    const usual = USUAL_RADIUS / this.#view.camera.scale
    const nearest = await this.#view.hit(x, y, 0)
    const other = nearest === undefined ? undefined : this.circle(nearest.id)
    const room = other === undefined ? 2 * usual : Math.hypot(x - other.x, y - other.y) - other.r
    await this.add({ x, y, r: room > 0 ? Math.min(usual, room / 2) : usual })
  }

  cancel(gesture: number): void {
    this.#editing.cancel(gesture)
  }

  toggleAdding(): void {
    this.#store.update((state) => ({ ...state, isAdding: !state.isAdding }))
  }

  removeSelected(): void {
    const { selected } = this.#store.get()
    if (selected === undefined) return
    this.select(undefined)
    this.#editing.edit([{ kind: 'remove', id: selected }])
  }

  moveSelected(dx: number, dy: number, gesture: number): void {
    this.#changeSelected(({ x, y, r }) => ({ x: x + dx, y: y + dy, r }), gesture)
  }

  /** The radius does not go below zero. */
  growSelected(dr: number, gesture: number): void {
    this.#changeSelected(({ x, y, r }) => ({ x, y, r: Math.max(r + dr, 0) }), gesture)
  }

  select(id: number | undefined): void {
    this.#store.update((state) =>
      state.selected === id
        ? state
        : {
            ...state,
            selected: id,
            circle: id === undefined ? undefined : this.circle(id),
            described: undefined,
            problem: '',
          },
    )
  }

  /** Selects a circle and has the view show it. */
  goTo(id: number): void {
    this.select(id)
    this.#reveal(id)
  }

  /** Selects the circle nearest to the middle of the view. */
  async selectNearMiddle(): Promise<void> {
    const { x, y } = this.#view.camera
    this.select((await this.#view.hit(x, y, 0))?.id)
  }

  /** Selects the next circle by number, or the one before; reports whether there is one. */
  selectNext(step: 1 | -1): boolean {
    const { selected } = this.#store.get()
    const next = selected === undefined ? undefined : this.#editing.circles.next(selected + step, step)
    if (next !== undefined) this.goTo(next)
    return next !== undefined
  }

  hover(id: number | undefined): void {
    this.#store.update((state) => (state.hovered === id ? state : { ...state, hovered: id }))
  }

  /** Gives up what is going on: adding, or else the selection. */
  release(): void {
    if (this.isAdding) this.toggleAdding()
    else this.select(undefined)
  }

  /** Draws something else, or something more. */
  setLayers(change: Partial<Layers>): void {
    this.#view.setLayers(change)
  }

  undo(): Promise<void> {
    return this.#goThroughHistory(() => this.#editing.undo())
  }

  redo(): Promise<void> {
    return this.#goThroughHistory(() => this.#editing.redo())
  }

  async #goThroughHistory(go: () => Promise<Edited | undefined>): Promise<void> {
    const { scene } = this.#editing
    const edited = await go()
    const id = edited?.inserted[0]
    if (id !== undefined) this.goTo(id)
    if (this.#editing.scene !== scene) this.#view.setCamera(this.#fitted(this.#editing.circles.box()))
  }

  pan(dx: number, dy: number): void {
    this.#view.setCamera(panned(this.#view.camera, dx, dy))
  }

  zoom(factor: number, anchor: Point): void {
    const { camera, size } = this.#view
    const { circles } = this.#editing
    const [least, most] = this.#zoomLimits(circles.box(), circles.core())
    const scale = Math.min(Math.max(camera.scale * factor, least), most)
    this.#view.setCamera(zoomed(camera, size, anchor, scale / camera.scale))
  }

  zoomAtMiddle(factor: number): void {
    const { width, height } = this.#view.size
    this.zoom(factor, { x: width / 2, y: height / 2 })
  }

  /** Shows everything, or where everything is shown already, all but what lies far outside. */
  fit(): void {
    const { circles } = this.#editing
    const [whole, core] = [this.#fitted(circles.box()), this.#fitted(circles.core())]
    this.#view.setCamera(isSame(this.#view.camera, whole) ? core : whole)
  }

  #zoomLimits(box: Box, core: Box): [least: number, most: number] {
    const whole = this.#fitted(box).scale
    return [whole * SMALLEST_ZOOM, Math.max(whole, this.#fitted(core).scale) * LARGEST_ZOOM]
  }

  /** The camera of a view that somebody else has made up, if it is one of these circles; else all of them. */
  #looking(view: LinkView | undefined, box: Box): Camera {
    const whole = this.#fitted(box)
    if (view === undefined) return whole
    const camera = cameraOf(view, this.#view.size)
    const [least, most] = this.#zoomLimits(box, box)
    const isNear = (value: number, from: number, to: number) => value >= from - (to - from) && value <= to + (to - from)
    const isRight = isNear(view.x, box.minX, box.maxX) && isNear(view.y, box.minY, box.maxY)
    return isRight && camera.scale >= least && camera.scale <= most ? camera : whole
  }

  #fitted(box: Box): Camera {
    return fitted(box, this.#view.size, this.#padding())
  }

  /** Has the view show the centre of a circle, where it does not. */
  #reveal(id: number): void {
    const circle = this.circle(id)
    if (circle === undefined) return
    const { camera, size } = this.#view
    const { top, right, bottom, left } = this.#padding()
    const { x, y } = toScreen(camera, size, circle)
    const isShown = x >= left && x <= size.width - right && y >= top && y <= size.height - bottom
    if (!isShown) this.#view.setCamera({ ...camera, x: circle.x, y: circle.y })
  }

  #changeSelected(change: (circle: Circle) => Circle, gesture: number): void {
    const { selected } = this.#store.get()
    const circle = selected === undefined ? undefined : this.#editing.latest(selected)
    if (selected !== undefined && circle !== undefined) this.set(selected, change(circle), gesture)
  }
}

function isSame(camera: Camera, other: Camera): boolean {
  return camera.x === other.x && camera.y === other.y && camera.scale === other.scale
}
