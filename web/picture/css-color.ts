// SPDX-License-Identifier: GPL-3.0-or-later
import { color } from '@csstools/css-color-parser'
import { parseComponentValue } from '@csstools/css-parser-algorithms'
import { tokenize } from '@csstools/css-tokenizer'

/** Returns whether a text is a CSS color, as `CSS.supports` says in browsers, without colors of a system or a page. */
export function isCssColor(text: string): boolean {
  const value = parseComponentValue(tokenize({ css: text }))
  return value !== undefined && color(value) !== false
}
