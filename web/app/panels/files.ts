// SPDX-License-Identifier: GPL-3.0-or-later
import { html, svg, type TemplateResult } from 'lit'
import type { FileActions } from '../files/file-actions.ts'
import type { SavedFormat } from '../files/files-protocol.ts'
import { byId } from './by-id.ts'
import { folding } from './folding.ts'

const OPENED = '.csv,.tsv,.txt,.json,.geojson,.svg'
/** What is copied is said for so long, in milliseconds. */
const SAID = 4000

const SAVED: readonly (readonly [format: SavedFormat, label: string, what: string])[] = [
  ['svg', 'SVG', 'a drawing, which opens again as it is'],
  ['csv', 'CSV', 'x, y and r of each circle'],
  ['json', 'JSON', 'circles and their diagram'],
  ['geojson', 'GeoJSON', 'circles as points with a radius'],
  ['cells', 'Cells', 'GeoJSON with the cells as polygons'],
]

const icon = (path: TemplateResult) => html`<svg viewBox="0 0 20 20" aria-hidden="true">${path}</svg>`
const FOLDER = icon(svg`<path d="M3 6v9h14V7h-7L8 5H3Z" />`)
const DOWN = icon(svg`<path d="M10 4v8m-3-3 3 3 3-3M4 16h12" />`)
const CHAIN = icon(svg`<path d="M8 12l4-4M7 9l-2 2a2.800 2.800 0 0 0 4 4l2-2M13 11l2-2a2.800 2.800 0 0 0-4-4L9 7" />`)
const CODE = icon(svg`<path d="m7 6-4 4 4 4M13 6l4 4-4 4" />`)

/** Open, save and share. */
export function mountFiles(actions: FileActions): void {
  let said = ''
  /** How many pixels a saved picture has for one that is seen. */
  let scale = 2
  let timer: ReturnType<typeof setTimeout> | undefined

  const say = (text: string) => {
    said = text
    draw()
    clearTimeout(timer)
    if (text !== '') timer = setTimeout(() => say(''), SAID)
  }
  const copy = async (act: () => Promise<boolean>, what: string) =>
    say((await act()) ? `${what} is in the clipboard.` : '')
  const open = async ({ target }: Event) => {
    const input = target as HTMLInputElement
    const file = input.files?.[0]
    if (file !== undefined) await actions.openFile(file)
    // The same file may be chosen once more.
    input.value = ''
  }

  const rescale = ({ target }: Event) => {
    scale = (target as HTMLInputElement).valueAsNumber
  }

  const draw = () =>
    panel.render(
      () => html`
          <label class="button wide">
            ${FOLDER}Open …
            <input type="file" class="visually-hidden" accept=${OPENED} @change=${open} />
          </label>
          <p>or drop or paste it: CSV, JSON, GeoJSON, or an SVG that was saved here</p>
          <h3>Save</h3>
          <div class="choices">
            ${SAVED.map(
              ([format, label, what]) =>
                html`<button type="button" title=${`Save ${what}`} @click=${() => actions.saveAs(format)}>
                  ${DOWN}${label}
                </button>`,
            )}
          </div>
          <div class="choices">
            <button type="button" title="Save the picture that is seen" @click=${() => actions.savePicture(scale)}>
              ${DOWN}PNG
            </button>
            <label>
              times
              <input type="number" min="0.1" step="any" .value=${String(scale)} @change=${rescale} autocomplete="off" />
            </label>
          </div>
          <h3>Share</h3>
          <div class="choices">
            <button type="button" title="Copy a link to what is shown" @click=${() => copy(() => actions.copyLink(), 'The link')}>
              ${CHAIN}Copy link
            </button>
            <button
              type="button"
              title="Copy HTML that shows this in another page"
              @click=${() => copy(() => actions.copyEmbedCode(), 'The code')}
            >
              ${CODE}Copy embed code
            </button>
            <button
              type="button"
              title="Copy a script and a tag that show these circles in another page, without a frame"
              @click=${() => copy(() => actions.copyElementCode(), 'The code')}
            >
              ${CODE}Copy element
            </button>
          </div>
          <p aria-live="polite">${said}</p>
      `,
    )
  const panel = folding(byId('files', HTMLElement), 'Files', svg`<path d="M3 6v9h14V7h-7L8 5H3Z" />`, draw)
  draw()
}
