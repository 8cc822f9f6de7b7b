// SPDX-License-Identifier: GPL-3.0-or-later

/** Returns a text as it can stand in XML, between tags and in an attribute in quotation marks. */
export function escaped(text: string): string {
  return text.replace(/[&<>"']/g, (c) => `&#${c.charCodeAt(0)};`)
}
