// SPDX-License-Identifier: GPL-3.0-or-later

import type { Editing } from '../editing/editing.ts'
import { EditorActions, type HowOpened, type Opened } from '../editing/editor-actions.ts'
import type { Scene } from '../editing/history.ts'
import type { State } from '../editing/state.ts'
import type { Store } from '../editing/store.ts'
import type { Float64s } from '../lib/index.ts'
import { decodeLink, type LinkView } from '../lib/link.ts'
import { boundingBox, type Padding } from '../view/camera.ts'
import type { View } from '../view/view.ts'
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
import type { Read } from './files/files-protocol.ts'
import type { Recipe } from './generators/generators.ts'
import { interestingBox, sizeOf } from './generators/interesting-box.ts'

/** What a user of the page can open beside. */
export class PageActions extends EditorActions {
  readonly #files: Pick<FilesClient, 'cancel'>
  readonly #make: (recipe: Recipe) => Promise<Float64s>
  readonly #shown: () => string

  constructor(
    store: Store<State>,
    editing: Editing,
    view: View,
    padding: () => Padding,
    files: Pick<FilesClient, 'make' | 'cancel'>,
  ) {
    super(store, editing, view, padding)
    this.#files = files
    this.#make = (recipe) => files.make(recipe)
    this.#shown = () => store.get().dataSet
  }

  override cancelOpening(): void {
    // What is read or made ends, too.
    this.#files.cancel()
    super.cancelOpening()
  }

  /** Circles of the menu. */
  async load(id: string): Promise<void> {
    const dataSet = DATA_SETS.find((dataSet) => dataSet.id === id)
    if (dataSet !== undefined) await this.open(() => this.#loadNamed(nameFrom(dataSet)))
  }

  /** Circles of a family or of a figure of the paper. */
  async generate(recipe: Recipe): Promise<void> {
    await this.open(async () => {
      const scene = await this.#loadNamed(nameOf(recipe))
      return recipe.kind === 'figure' ? { ...scene, view: viewOfFigure(scene.circles) } : scene
    })
  }

  /** Other random circles of the family that is shown. */
  async generateAgain(): Promise<void> {
    const source = sourceOf(this.#shown())
    if (source?.kind === 'family') await this.generate({ ...source, seed: randomSeed() })
    if (source?.kind === 'former') await this.load('random')
  }

  /** What a link says. */
  openLink(text: string): Promise<HowOpened> {
    return this.open(() => this.#linked(text))
  }

  /** What is read somewhere. */
  openRead(read: () => Promise<Read>): Promise<HowOpened> {
    return this.open(async () => {
      const result = await read()
      return 'link' in result ? this.#linked(result.link) : { ...result, dataSet: '', isEdited: false }
    })
  }

  async #linked(text: string): Promise<Opened> {
    const { circles, names, dataSet, edits, view, layers = {}, step, method } = await decodeLink(text)
    const scene =
      circles === undefined
        ? await this.#loadNamed(dataSet ?? nameFrom(DATA_SETS[0] as DataSet), loadLinked)
        : { circles, names, dataSet: '', isEdited: false }
    return { ...scene, edits, view, layers, step, method }
  }

  async #loadNamed(name: string, load = loadDataSet): Promise<Scene> {
    return { ...(await load(name, this.#make)), dataSet: name, isEdited: false }
  }
}

/** Figures are about the small circles beside a huge one. `undefined`: all of them. */
function viewOfFigure(circles: Float64s): LinkView | undefined {
  const [whole, box] = [boundingBox(circles), interestingBox(circles)]
  if (sizeOf(box) === sizeOf(whole)) return undefined
  return { x: (box.minX + box.maxX) / 2, y: (box.minY + box.maxY) / 2, span: 1.4 * sizeOf(box) }
}
