// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces web/lib/diagram/diagram-file.ts, because the element neither reads nor writes diagrams as JSON.

export function dataFrom(): never {
  throw new Error('The element reads no diagrams.')
}

export function fileOf(): never {
  throw new Error('The element writes no diagrams.')
}
