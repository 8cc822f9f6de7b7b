// SPDX-License-Identifier: GPL-3.0-or-later
import { html } from 'lit/html.js'
import { icon } from '../../player/icon.ts'
import { DOWN, FOLDER } from '../../view/icons.ts'
import type { FileActions, Part } from '../files/file-actions.ts'
import type { SavedFormat } from '../files/files-protocol.ts'
import { byId } from './by-id.ts'
import { panelOf } from './panel.ts'

const OPENED = '.csv,.tsv,.txt,.json,.geojson,.wkt,.svg,image/*'

const SAVED: readonly (readonly [format: SavedFormat, label: string, what: string])[] = [
  ['csv', 'CSV', 'x, y, r and the other columns of each circle'],
  ['json', 'JSON', 'circles and their diagram'],
  ['geojson', 'GeoJSON', 'circles as points with a radius and their other properties'],
  ['cells', 'Cells', 'GeoJSON with the cells as polygons'],
]
const PARTS: readonly (readonly [part: Part, label: string])[] = [
  ['seen', 'what you see'],
  ['all', 'all circles'],
]

/** The panel for opening and saving. */
export function mountFiles(actions: FileActions): void {
  /** Pixels of a saved picture per pixel on screen. */
  let scale = 2
  let part: Part = 'seen'

  const open = async ({ target }: Event) => {
    const input = target as HTMLInputElement
    const file = input.files?.[0]
    if (file !== undefined) await actions.openFile(file)
    // Allows choosing the same file again.
    input.value = ''
  }
  const rescale = ({ target }: Event) => {
    const input = target as HTMLInputElement
    if (input.reportValidity()) scale = input.valueAsNumber
    // Restores the last valid number.
    else input.value = String(scale)
  }
  const choosePart = ({ target }: Event) => {
    part = (target as HTMLSelectElement).value as Part
  }

  const draw = () =>
    panel.render(
      () => html`
          <label class="button wide">
            ${icon(FOLDER)}Open …
            <input type="file" class="visually-hidden" accept=${OPENED} @change=${open} />
          </label>
          <p>You can also drop or paste a file: CSV, JSON, GeoJSON, an SVG that was saved here, or a picture, which becomes circles. Polygons, as GeoJSON or WKT, become the region.</p>
          <h3>Save the picture</h3>
          <div class="choices">
            <label>of
              <select aria-label="What the picture shows" @change=${choosePart}>
                ${PARTS.map(([value, label]) => html`<option value=${value} ?selected=${value === part}>${label}</option>`)}
              </select>
            </label>
          </div>
          <div class="choices">
            <button type="button" title="Save a drawing as you see it, which opens here again" @click=${() => actions.saveDrawing(part)}>
              ${icon(DOWN)}SVG
            </button>
            <button type="button" title="Save a PNG for a sheet of A3 paper at 300 dots per inch" @click=${() => actions.savePoster(part)}>
              ${icon(DOWN)}Poster, A3
            </button>
            <button type="button" title="Save a picture as you see it" @click=${() => actions.savePicture(part, scale)}>
              ${icon(DOWN)}PNG
            </button>
            <label>
              <input type="number" min="0.1" step="any" required .value=${String(scale)} @change=${rescale} autocomplete="off" />
              × its size
            </label>
          </div>
          <h3>Save the data</h3>
          <div class="choices">
            ${SAVED.map(
              ([format, label, what]) =>
                html`<button type="button" title=${`Save ${what}`} @click=${() => actions.saveAs(format)}>
                  ${icon(DOWN)}${label}
                </button>`,
            )}
          </div>
      `,
    )
  const panel = panelOf(byId('files', HTMLElement), 'Open and save', draw)
  draw()
}
