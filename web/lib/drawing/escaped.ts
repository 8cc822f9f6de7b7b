// SPDX-License-Identifier: GPL-3.0-or-later

/** Escapes a text for XML, both between tags and in quoted attributes. */
export function escaped(text: string): string {
  return text.replace(/[&<>']/g, (c) => `&#${c.charCodeAt(0)};`).replaceAll('"', '&quot;')
}

/** Reverts `escaped`. */
export function unescaped(text: string): string {
  return text.replaceAll('&quot;', '"').replace(/&#(\d+);/g, (_, code) => String.fromCharCode(code))
}
