// SPDX-License-Identifier: GPL-3.0-or-later

import { type Attributes, isNumeric, numbersIn, textIn, valueIn } from '../editing/attributes.ts'
import type { Editing, Outcome } from '../editing/editing.ts'
import { EditorActions } from '../editing/editor-actions.ts'
import type { CircleSet } from '../editing/history.ts'
import { COLOR, colorColumn, isColor, NAME, nameColumn, nameIn } from '../editing/identity.ts'
import { type OpenRequest, requestOf } from '../editing/open-request.ts'
import type { HowOpened } from '../editing/opening-actions.ts'
import { dataSetName, type Remedy, type State } from '../editing/state.ts'
import type { Circle, Edit, Float64s, Lattice, Point } from '../lib/index.ts'
import { decodeLink, LINK_LIMITS, type LinkFrame, type LinkView } from '../lib/link.ts'
import { frameOf } from '../lib/link-frame.ts'
import { boundingBox, type Padding } from '../view/camera.ts'
import type { Areas, Domain } from '../view/domain.ts'
import type { Layers } from '../view/layers.ts'
import type { Edited } from '../view/scene-client.ts'
import type { Store } from '../view/store.ts'
import type { View } from '../view/view.ts'
import { boxAround } from './box-around.ts'
import { cellValues } from './cell-values.ts'
import {
  DATA_SETS,
  type DataSet,
  loadDataSet,
  loadLinked,
  nameFrom,
  nameOf,
  randomSeed,
  sourceOf,
} from './data-sets.ts'
import type { FilesClient } from './files/files-client.ts'
import type { Photo, Read, Stippled } from './files/files-protocol.ts'
import type { Recipe } from './generators/generators.ts'
import { interestingBox, sizeOf } from './generators/interesting-box.ts'

/** The layers of a photo. */
const MOSAIC = { fullColor: true, circles: false, edges: false, vertices: false } as const

/** The actions of the page beyond those of a figure: opening data, and assigning areas and colors by columns. */
export class PageActions extends EditorActions {
  /** Names in links are limited like circles in links. */
  protected override readonly mostNamed = LINK_LIMITS.circles
  /** Reads and generates circles. */
  readonly #reader: Pick<FilesClient, 'cancel'>
  readonly #make: (recipe: Recipe) => Promise<Float64s>
  /** The photos of the session by the attributes of their circles, which undo brings back, too. */
  readonly photos = new WeakMap<Attributes, Photo>()
  /** The attributes of the current colors. */
  #attributes: Attributes | undefined
  /** The layers that the last photo replaced. */
  #beforeMosaic: Partial<Layers> = { fullColor: false, circles: true, edges: true, vertices: true }

  constructor(
    store: Store<State>,
    editing: Editing,
    view: View,
    padding: () => Padding,
    reader: Pick<FilesClient, 'call' | 'cancel'>,
  ) {
    super(store, editing, view, padding)
    this.#reader = reader
    this.#make = (recipe) => reader.call('make', recipe)
  }

  /** The space that panels cover. */
  covered = (): Padding => this.padding()

  override get paddingNow(): Padding {
    return this.covered()
  }

  /** The title, question and check of the last opened link; `undefined` if it had none. */
  frame: LinkFrame | undefined

  override async setDomain(
    change: Partial<Domain>,
    gesture?: number,
    edits: readonly Edit[] = [],
  ): Promise<Edited | undefined> {
    const { count } = this.editing.circles
    // Cells are cut to a region, or they repeat in a box.
    const isOther = change.region !== undefined && this.editing.domain.lattice !== undefined
    const { areas, region } = { ...this.editing.domain, ...change }
    this.onstage(areas !== undefined ? 'fitting' : region !== undefined ? 'clipping' : 'repeating', count)
    try {
      return await super.setDomain(isOther ? { lattice: undefined, ...change } : change, gesture, edits)
    } finally {
      this.onstage('opened', count)
    }
  }

  /** Prescribes areas; `undefined` restores the former radii. */
  async setAreas(areas: Areas | undefined, gesture?: number): Promise<Edited | undefined> {
    const { circles, domain } = this.editing
    const known: number[] = []
    for (const id of circles.ids()) known[id] = (circles.get(id) as Circle).r
    const radii = domain.areas === undefined ? known : domain.radii
    return this.setDomain({ areas, radii }, gesture, areas === undefined ? this.#withRadii() : [])
  }

  /** Edits that give circles the radii again that they had before areas. */
  #withRadii(move: Point = { x: 0, y: 0 }): Edit[] {
    const { circles } = this.editing
    const radii = this.radii()
    return Array.from(circles.ids(), (id, k): Edit => {
      const { x, y } = circles.get(id) as Circle
      return { kind: 'replace', id, circle: { x: x + move.x, y: y + move.y, r: radii[k] as number } }
    })
  }

  /** Makes the circles periodic in a box around them with a corner at the origin. Moves them there if necessary. */
  async repeat(): Promise<void> {
    const { circles } = this.editing
    const { lattice, move } = boxAround(circles.box(), circles.count)
    await this.setLattice(lattice, move)
  }

  /** Sets or removes the periods after moving the circles. Periodic cells are whole, so a region is removed. */
  async setLattice(lattice: Lattice | undefined, move: Point = { x: 0, y: 0 }): Promise<void> {
    const { areas } = this.editing.domain
    const isMoved = move.x !== 0 || move.y !== 0
    const edits = lattice !== undefined && (isMoved || areas !== undefined) ? this.#withRadii(move) : []
    const change = lattice === undefined ? { lattice } : { lattice, region: undefined, areas: undefined }
    const edited = await this.setDomain(change, undefined, edits)
    if (edited !== undefined && lattice !== undefined) this.look(undefined)
  }

  /** Offers a remedy for the current problem. */
  offer(remedy: Remedy): void {
    this.store.update((state) => ({ ...state, remedy }))
  }

  /** Opens circles, and colors them by a column if they come with one. */
  override async open(load: () => Promise<OpenRequest>): Promise<HowOpened> {
    let column: unknown
    const how = await super.open(async () => {
      const opened = await load()
      column = opened.layers?.column
      return opened
    })
    if (how === 'opened' && typeof column === 'string') this.colorBy(column)
    return how
  }

  /** The name of a circle, or an empty text. */
  nameOf(id: number): string {
    return nameIn(this.editing.attributes, id)
  }

  /** Names a circle; an empty text removes its name. */
  async setName(id: number, name: string): Promise<void> {
    const column = nameColumn(this.editing.attributes.columns)?.name ?? NAME
    await this.editing.setValues(column, new Map([[id, name === '' ? '' : JSON.stringify(name)]]))
  }

  /** Gives circles a CSS color of their own; `undefined` removes it. */
  async setColor(ids: readonly number[], color: string | undefined, gesture?: number): Promise<void> {
    const column = colorColumn(this.editing.attributes.columns)?.name ?? COLOR
    const value = color === undefined ? '' : JSON.stringify(color)
    await this.editing.setValues(column, new Map(ids.map((id) => [id, value])), gesture)
  }

  /** The CSS color of its own that a circle has. */
  ownColorOf(id: number): string | undefined {
    const color = textIn(
      valueIn(this.editing.attributes, colorColumn(this.editing.attributes.columns)?.name ?? COLOR, id),
    )
    return isColor(color) ? color : undefined
  }

  /** Colors cells by a column; an unknown name ends coloring by column. */
  colorBy(name: string): void {
    const { circles, attributes } = this.editing
    const column = attributes.columns.find((column) => column.name === name)
    const valueAt = (id: number) => column?.values[id]
    this.setLayers({ column: column && cellValues(column, circles, valueAt) })
  }

  /** Updates the colors after an edit, a change of values or an opening. Call with each outcome. */
  follow({ edited, isOpened }: Outcome): void {
    const { attributes } = this.editing
    if (isOpened) this.#showMosaic(this.photos.has(attributes))
    const { column } = this.view.layers
    const isOther = isOpened || attributes !== this.#attributes || edited.inserted.length > 0
    this.#attributes = attributes
    if (column !== undefined && isOther) this.colorBy(column.name)
  }

  /** Shows the circles of a photo as a mosaic, and others with the layers from before. */
  #showMosaic(isPhoto: boolean): void {
    const { fullColor, circles, edges, vertices } = this.view.layers
    const isMosaic = fullColor && !circles && !edges && !vertices
    if (isPhoto === isMosaic) return
    if (isPhoto) this.#beforeMosaic = { fullColor, circles, edges, vertices }
    this.setLayers(isPhoto ? MOSAIC : this.#beforeMosaic)
  }

  /** Opens circles made from a photo, clipped to its frame. */
  openPhoto(file: File, count: number, read: () => Promise<Stippled>): Promise<HowOpened> {
    return this.open(async () => {
      const { circles, attributes, size } = await read()
      const { width, height } = size
      this.photos.set(attributes, { file, count, size })
      const region = [[[0, 0] as const, [width, 0] as const, [width, height] as const, [0, height] as const]]
      return { ...requestOf({ circles, region }), attributes }
    })
  }

  /** Moves the ends of the path that panels cover, and did not cover before, to where they are seen. */
  uncoverPath(before: Padding): void {
    const { path } = this.view.layers
    if (path === undefined) return
    const isCovered = (end: Point) => this.shows(end, before) && !this.shows(end)
    const across = this.pathAcross()
    const from = isCovered(path.from) ? across.from : path.from
    const to = isCovered(path.to) ? across.to : path.to
    if (from !== path.from || to !== path.to) this.view.setLayers({ path: { from, to } })
  }

  /** The names of numeric columns. */
  get columns(): readonly string[] {
    return this.editing.attributes.columns.filter(isNumeric).map(({ name }) => name)
  }

  /**
   * Prescribes areas by a column. Circles without a number get the mean. Resolves to how many got the mean, or to
   * `undefined` if refused.
   */
  async setAreasBy(column: string): Promise<number | undefined> {
    const { circles } = this.editing
    const values = numbersIn(this.editing.attributes, column, circles)
    const wrong = values.findIndex((value) => value <= 0)
    if (wrong >= 0) {
      this.complain(`${column}: circle ${circles.ids()[wrong]} has ${values[wrong]}. Areas need numbers above 0.`)
      return undefined
    }
    const known = values.filter((value) => value > 0)
    const mean = known.reduce((sum, value) => sum + value, 0) / known.length
    const edited = await this.setAreas(Array.from(values, (value) => (value > 0 ? value : mean)))
    return edited && values.length - known.length
  }

  /** The radii of the circles, or their radii before areas were prescribed. */
  radii(): number[] {
    const { circles, domain } = this.editing
    return Array.from(circles.ids(), (id) => {
      const known = domain.areas === undefined ? undefined : domain.radii?.[id]
      return known ?? (circles.get(id) as Circle).r
    })
  }

  /** Removes the region and restores the radii. */
  async removeRegion(): Promise<void> {
    const gesture = this.beginGesture()
    if (this.editing.domain.areas !== undefined) await this.setAreas(undefined, gesture)
    await this.setDomain({ region: undefined }, gesture)
  }

  /** Sets a cell's share of the region, between 0 and 1. The other cells keep their proportions. */
  async setShare(id: number, share: number, gesture?: number): Promise<void> {
    const { circles, areas } = this.editing
    const list = Array.isArray(areas) ? [...areas] : Array<number>(circles.count).fill(1)
    const k = circles.countBelow(id)
    const others = list.reduce((sum, area, i) => (i === k ? sum : sum + area), 0)
    list[k] = (share / (1 - share)) * others
    await this.setDomain({ areas: list }, gesture)
  }

  /** The prescribed share of a circle's cell. */
  shareOf(id: number): number | undefined {
    const { circles, areas } = this.editing
    if (areas === undefined) return undefined
    if (areas === 'equal') return 1 / circles.count
    return (areas[circles.countBelow(id)] as number) / areas.reduce((sum, area) => sum + area, 0)
  }

  override cancelOpening(): void {
    // Cancels reading and generating, too.
    this.#reader.cancel()
    super.cancelOpening()
  }

  /** Opens a data set of the menu. */
  async load(id: string): Promise<HowOpened> {
    const dataSet = DATA_SETS.find((dataSet) => dataSet.id === id)
    return dataSet === undefined ? 'refused' : this.open(() => this.#loadNamed(nameFrom(dataSet)))
  }

  /** Generates a family or a figure of the paper. */
  async generate(recipe: Recipe): Promise<void> {
    await this.open(async () => {
      const scene = await this.#loadNamed(nameOf(recipe))
      return recipe.kind === 'figure' ? { ...scene, view: viewOfFigure(scene.circles) } : scene
    })
  }

  /** Generates other random circles of the current family. */
  async generateAgain(): Promise<void> {
    const source = sourceOf(dataSetName(this.store.get()))
    if (source?.kind === 'family') await this.generate({ ...source, seed: randomSeed() })
  }

  /** Opens a link. */
  openLink(text: string): Promise<HowOpened> {
    return this.open(() => this.#linked(text))
  }

  /** Opens the result of a reader. `file` is the name of the file, for saving. */
  openRead(read: () => Promise<Read>, file?: string): Promise<HowOpened> {
    return this.open(async () => {
      const result = await read()
      if ('link' in result) return { ...(await this.#linked(result.link)), file }
      const { region, skipped, ...given } = result
      return { ...requestOf({ region }), ...given, file }
    })
  }

  async #linked(text: string): Promise<OpenRequest> {
    const state = await decodeLink(text)
    const { circles, dataSet = nameFrom(DATA_SETS[0] as DataSet), layers = {}, step } = state
    const named = circles === undefined ? await this.#loadNamed(dataSet, loadLinked) : undefined
    const frame = frameOf(state)
    this.frame = Object.keys(frame).length > 0 ? frame : undefined
    return requestOf({ ...state, layers, step }, named)
  }

  async #loadNamed(name: string, load = loadDataSet): Promise<CircleSet> {
    return { ...(await load(name, this.#make)), dataSet: name, isEdited: false }
  }
}

/** The figure's small circles beside a huge one; `undefined` shows all circles. */
function viewOfFigure(circles: Float64s): LinkView | undefined {
  const [whole, box] = [boundingBox(circles), interestingBox(circles)]
  if (sizeOf(box) === sizeOf(whole)) return undefined
  return { x: (box.minX + box.maxX) / 2, y: (box.minY + box.maxY) / 2, span: 1.4 * sizeOf(box) }
}
