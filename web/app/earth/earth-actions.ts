// SPDX-License-Identifier: GPL-3.0-or-later
import { columnsOf, fileAttributes, NO_ATTRIBUTES } from '../../editing/attributes.ts'
import type { Editing } from '../../editing/editing.ts'
import type { Degrees } from '../../editing/history.ts'
import type { HowOpened } from '../../editing/opening-actions.ts'
import type { FilesClient } from '../files/files-client.ts'
import type { PageActions } from '../page-actions.ts'
import { toast } from '../panels/toast.ts'
import { type GlobeTable, openGlobe } from './globe-window.ts'
import { type MapCenter, mapped, recordOf } from './map-projection.ts'

const METERS: Readonly<Record<Degrees['unit'], number>> = { km: 1000, m: 1 }

/** The actions for circles whose centers are longitude and latitude. */
export class EarthActions {
  readonly #editing: Editing
  readonly #actions: PageActions
  readonly #files: Pick<FilesClient, 'call'>

  constructor(editing: Editing, actions: PageActions, files: Pick<FilesClient, 'call'>) {
    this.#editing = editing
    this.#actions = actions
    this.#files = files
  }

  /** Opens the circles on a globe in a new tab. */
  showOnGlobe({ file, unit }: Degrees): void {
    const isOpened = openGlobe(this.#table({ file, unit }))
    if (!isOpened) this.#actions.messages.complain('The browser has blocked the new tab. Allow it for this page.')
  }

  async #table({ file, unit }: Degrees): Promise<GlobeTable> {
    const { circles } = this.#editing
    const text = await this.#files.call('write', circles.circles(), 'csv', undefined, fileAttributes(this.#editing))
    return { name: file, text, unit }
  }

  /** Projects the circles to an equal-area map in meters. Undo goes back. */
  async projectToMap({ unit }: Degrees): Promise<HowOpened> {
    const table = this.#editing.circles
    const given = table.circles().map((value, k) => (k % 3 === 2 ? value * METERS[unit] : value))
    try {
      const { circles, center } = mapped(given)
      const known = fileAttributes(this.#editing)
      const attributes = known ? columnsOf(known, table.count) : NO_ATTRIBUTES
      const collection = withRecord(attributes.collection, center)
      const how = await this.#actions.data.openRead(async () => ({
        circles,
        attributes: { ...attributes, collection },
      }))
      if (how === 'opened') {
        const said = `x and y are meters on an equal-area map around ${placeText(center)}.`
        toast(said, { label: 'Undo', act: () => this.#actions.circles.undo() })
      }
      return how
    } catch (error) {
      this.#actions.messages.complain((error as Error).message)
      return 'refused'
    }
  }
}

function withRecord(collection: string, center: MapCenter): string {
  const members = collection.trim().slice(1, -1).trim()
  return `{${[members, recordOf(center)].filter((text) => text !== '').join()}}`
}

function placeText({ longitude, latitude }: MapCenter): string {
  const part = (value: number, signs: string) => `${Math.abs(value).toFixed(1)}° ${value < 0 ? signs[1] : signs[0]}`
  return `${part(latitude, 'NS')}, ${part(longitude, 'EW')}`
}
