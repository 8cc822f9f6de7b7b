// SPDX-License-Identifier: GPL-3.0-or-later
import { CircleVoronoiError } from '../../lib/index.ts'
import { encodeLink } from '../../lib/link.ts'
import type { View } from '../../view/view.ts'
import type { Actions } from '../actions.ts'
import { dataSetOf } from '../data-sets.ts'
import type { Editing } from '../editing.ts'
import type { State } from '../state.ts'
import type { Store } from '../store.ts'
import { FilesClient } from './files-client.ts'
import type { SavedFormat } from './files-protocol.ts'
import { embedCode, save } from './saving.ts'

/** Larger files are none that a browser could show. */
const LARGEST_FILE = 2 ** 28
/** Browsers draw no larger pictures: pixels of a side, and all of them. */
const LONGEST_SIDE = 16_384
const MOST_PIXELS = 2 ** 27
/** A longer address is none that browsers open. */
const LONGEST_LINK = 2_000_000
const TYPES: Readonly<Record<SavedFormat, readonly [ending: string, type: string]>> = {
  svg: ['.svg', 'image/svg+xml'],
  csv: ['.csv', 'text/csv'],
  json: ['.json', 'application/json'],
  geojson: ['.geojson', 'application/geo+json'],
  cells: ['-cells.geojson', 'application/geo+json'],
}

/** All that a user can do with files and links. */
export class FileActions {
  readonly #store: Store<State>
  readonly #editing: Editing
  readonly #actions: Actions
  readonly #view: View
  readonly #client = new FilesClient()

  constructor(store: Store<State>, editing: Editing, actions: Actions, view: View) {
    this.#store = store
    this.#editing = editing
    this.#actions = actions
    this.#view = view
  }

  /** Opens a file. One that cannot be read changes nothing. */
  openFile(file: File): Promise<boolean> {
    return this.#actions.openRead(async () => {
      if (file.size > LARGEST_FILE) throw new Error(`${file.name}: the file is too large.`)
      return this.#client.read(new Uint8Array(await file.arrayBuffer()), file.name)
    })
  }

  /** Opens a text as if it were a file, or a link. */
  openText(text: string): Promise<boolean> {
    const link = /^\S*#(v\d+\.[\w-]+)$/.exec(text.trim())?.[1]
    if (link !== undefined) return this.#actions.openLink(link)
    return this.#actions.openRead(() => this.#client.read(new TextEncoder().encode(text), 'The pasted text'))
  }

  async saveAs(format: SavedFormat): Promise<void> {
    await this.#try(async () => {
      const circles = this.#editing.circles.circles()
      const text = await this.#client.write(circles, format, format === 'svg' ? await this.#link() : '')
      const [ending, type] = TYPES[format]
      save(new Blob([text], { type }), `${this.#name}${ending}`)
    })
  }

  /** The picture that is seen, so many times as large. */
  async savePicture(scale: number): Promise<void> {
    await this.#try(async () => {
      const { width, height } = this.#view.size
      if (
        !(scale > 0 && scale * Math.max(width, height) <= LONGEST_SIDE && scale * scale * width * height <= MOST_PIXELS)
      ) {
        throw new Error(`A picture ${scale} times as large as this one is too large.`)
      }
      save(await this.#view.toPNG(scale), `${this.#name}.png`)
    })
  }

  /** Reports whether it is in the clipboard. */
  copyLink(): Promise<boolean> {
    return this.#copy((address) => address)
  }

  copyEmbedCode(): Promise<boolean> {
    return this.#copy(embedCode)
  }

  #copy(textOf: (address: string) => string): Promise<boolean> {
    return this.#try(async () => {
      const link = await this.#link()
      if (link === '' || link.length > LONGEST_LINK) {
        throw new Error('These are too many circles for a link: save them as a file.')
      }
      await navigator.clipboard.writeText(textOf(`${location.origin}${location.pathname}#${link}`))
    })
  }

  /** Empty, if there is too much for a link. */
  async #link(): Promise<string> {
    try {
      return await encodeLink(this.#actions.linkState() ?? {})
    } catch (error) {
      if (error instanceof CircleVoronoiError && error.code === 'tooManyCircles') return ''
      throw error
    }
  }

  get #name(): string {
    return dataSetOf(this.#store.get().dataSet)?.id ?? 'circles'
  }

  /** Reports whether it was done; if not, a sentence says why. */
  async #try(act: () => Promise<void>): Promise<boolean> {
    try {
      await act()
      return true
    } catch (error) {
      this.#store.update((state) => ({ ...state, problem: (error as Error).message }))
      return false
    }
  }
}
