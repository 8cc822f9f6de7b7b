// SPDX-License-Identifier: GPL-3.0-or-later

/** A fenced code block: its language, its code, and the line of the file on which the code begins. */
export interface Snippet {
  readonly language: string
  readonly code: string
  readonly line: number
}

export function readmeSnippets(heading: string): Snippet[]
export function snippets(markdown: string, heading: string): Snippet[]
