// SPDX-License-Identifier: GPL-3.0-or-later
import { html, type TemplateResult } from 'lit/html.js'

/** An icon of a path in 20 by 20 units (`view/icons.ts`). */
export const icon = (path: string, isFilled = false): TemplateResult =>
  html`<svg class=${isFilled ? 'glyph full' : 'glyph'} viewBox="0 0 20 20" aria-hidden="true"><path d=${path} /></svg>`
