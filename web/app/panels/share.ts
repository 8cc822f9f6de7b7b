// SPDX-License-Identifier: GPL-3.0-or-later
import { html } from 'lit/html.js'
import { icon } from '../../player/icon.ts'
import { CHAIN, CODE } from '../../view/icons.ts'
import type { FileActions } from '../files/file-actions.ts'
import { byId } from './by-id.ts'
import { panelOf } from './panel.ts'
import { toast } from './toast.ts'

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
            ${icon(CHAIN)}Copy link
          </button>
          <button
            type="button"
            title="Copy HTML for a frame in another page"
            @click=${() => copy(() => actions.copyEmbedCode(), 'The code')}
          >
            ${icon(CODE)}Copy embed code
          </button>
          <button
            type="button"
            title="Copy a script and a tag that show these circles in another page, without a frame"
            @click=${() => copy(() => actions.copyElementCode(), 'The code')}
          >
            ${icon(CODE)}Copy element
          </button>
        </div>
      `,
    )
  const panel = panelOf(byId('share', HTMLElement), 'Share', draw, { isKept: false })
  draw()
}
