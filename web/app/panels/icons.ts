// SPDX-License-Identifier: GPL-3.0-or-later
import { html, svg, type TemplateResult } from 'lit/html.js'

/** An icon of a path in 20 by 20 units. */
export const icon = (path: TemplateResult) => html`<svg viewBox="0 0 20 20" aria-hidden="true">${path}</svg>`

/** The icon of buttons that close something. */
export const CLOSE = icon(svg`<path d="m6 6 8 8M14 6l-8 8" />`)
/** The icon of buttons that open a file. */
export const FOLDER = icon(svg`<path d="M3 6v9h14V7h-7L8 5H3Z" />`)
