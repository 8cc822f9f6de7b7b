// SPDX-License-Identifier: GPL-3.0-or-later
import type { CircleSet } from '../editing/history.ts'
import { type OpenRequest, requestOf } from '../editing/open-request.ts'
import type { HowOpened, OpeningActions } from '../editing/opening-actions.ts'
import { dataSetName, type State } from '../editing/state.ts'
import type { Float64s } from '../lib/index.ts'
import { decodeLink, type LinkFrame, type LinkView } from '../lib/link.ts'
import { frameOf } from '../lib/link-frame.ts'
import { boundingBox } from '../view/camera.ts'
import type { Store } from '../view/store.ts'
import type { ColoringActions } from './coloring-actions.ts'
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
import type { Read, Stippled } from './files/files-protocol.ts'
import type { Recipe } from './generators/generators.ts'
import { interestingBox, sizeOf } from './generators/interesting-box.ts'

/** The thread that reads and generates circles. */
export type Reader = Pick<FilesClient, 'call' | 'cancel'>

/** Opening data sets, generated circles, links, files and photos. */
export class DataActions {
  readonly #store: Store<State>
  readonly #opening: OpeningActions
  readonly #coloring: ColoringActions
  /** Reads and generates circles. */
  readonly #reader: Reader
  /** The title, question and check of the last opened link; `undefined` if it had none. */
  frame: LinkFrame | undefined

  constructor(store: Store<State>, opening: OpeningActions, coloring: ColoringActions, reader: Reader) {
    this.#store = store
    this.#opening = opening
    this.#coloring = coloring
    this.#reader = reader
  }

  /** Cancels reading, generating and opening; the circles stay. */
  cancel(): void {
    this.#reader.cancel()
    this.#opening.cancelOpening()
  }

  /** Opens circles made from a photo, clipped to its frame. */
  openPhoto(file: File, count: number, read: () => Promise<Stippled>): Promise<HowOpened> {
    return this.#opening.open(async () => {
      const { circles, attributes, size } = await read()
      const { width, height } = size
      this.#coloring.photos.set(attributes, { file, count, size })
      const region = [[[0, 0] as const, [width, 0] as const, [width, height] as const, [0, height] as const]]
      return { ...requestOf({ circles, region }), attributes }
    })
  }

  /** Opens a data set of the menu. */
  async load(id: string): Promise<HowOpened> {
    const dataSet = DATA_SETS.find((dataSet) => dataSet.id === id)
    return dataSet === undefined ? 'refused' : this.#opening.open(() => this.#loadNamed(nameFrom(dataSet)))
  }

  /** Generates a family or a figure of the paper. */
  async generate(recipe: Recipe): Promise<void> {
    await this.#opening.open(async () => {
      const scene = await this.#loadNamed(nameOf(recipe))
      return recipe.kind === 'figure' ? { ...scene, view: viewOfFigure(scene.circles) } : scene
    })
  }

  /** Generates other random circles of the current family. */
  async generateAgain(): Promise<void> {
    const source = sourceOf(dataSetName(this.#store.get()))
    if (source?.kind === 'family') await this.generate({ ...source, seed: randomSeed() })
  }

  /** Opens a link. */
  openLink(text: string): Promise<HowOpened> {
    return this.#opening.open(() => this.#linked(text))
  }

  /** Opens the result of a reader. `file` is the name of the file, for saving. */
  openRead(read: () => Promise<Read>, file?: string): Promise<HowOpened> {
    return this.#opening.open(async () => {
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
    return { ...(await load(name, (recipe) => this.#reader.call('make', recipe))), dataSet: name, isEdited: false }
  }
}

/** The figure's small circles beside a huge one; `undefined` shows all circles. */
function viewOfFigure(circles: Float64s): LinkView | undefined {
  const [whole, box] = [boundingBox(circles), interestingBox(circles)]
  if (sizeOf(box) === sizeOf(whole)) return undefined
  return { x: (box.minX + box.maxX) / 2, y: (box.minY + box.maxY) / 2, span: 1.4 * sizeOf(box) }
}
