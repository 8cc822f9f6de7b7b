// SPDX-License-Identifier: GPL-3.0-or-later
import { html, svg } from 'lit/html.js'
import type { FileActions } from '../files/file-actions.ts'
import { byId } from './by-id.ts'
import { icon } from './icons.ts'
import { panelOf } from './panel.ts'
import { toast } from './toast.ts'

const CHAIN = icon(svg`<path d="M8 12l4-4M7 9l-2 2a2.800 2.800 0 0 0 4 4l2-2M13 11l2-2a2.800 2.800 0 0 0-4-4L9 7" />`)
const CODE = icon(svg`<path d="m7 6-4 4 4 4M13 6l4 4-4 4" />`)

/** Links and code that show the same elsewhere. */
export function mountShare(actions: FileActions): void {
  const copy = async (act: () => Promise<boolean>, what: string) => {
    if (await act()) toast(`${what} is in the clipboard.`)
  }
  const draw = () =>
    panel.render(
      () => html`
        <p>A link or code shows what you see now, with your edits.</p>
        <div class="choices">
          <button type="button" class="primary" @click=${() => copy(() => actions.copyLink(), 'The link')}>
            ${CHAIN}Copy link
          </button>
          <button
            type="button"
            title="Copy HTML for a frame in another page"
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
      `,
    )
  const panel = panelOf(byId('share', HTMLElement), 'Share', draw, { isKept: false })
  draw()
}
