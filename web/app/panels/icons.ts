// SPDX-License-Identifier: GPL-3.0-or-later
import { html } from 'lit/html.js'

/** The icon of buttons that close something. */
export const CLOSE = html`<svg viewBox="0 0 20 20" aria-hidden="true"><path d="m6 6 8 8M14 6l-8 8" /></svg>`
