// SPDX-License-Identifier: GPL-3.0-or-later
export interface Block {
  readonly file: string
  readonly line: number
  readonly language: string
  readonly code: string
  readonly headings: readonly string[]
}

export function blocksRunBy(test: string): readonly Block[]
