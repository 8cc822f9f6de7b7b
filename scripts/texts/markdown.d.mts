// SPDX-License-Identifier: GPL-3.0-or-later
export interface MarkdownOptions {
  /** Renders a block; without it there are none. */
  readonly block?: (kind: string, spec: object, inline: (text: string) => string) => string
  /** Maps the addresses of links and pictures. */
  readonly link?: (address: string) => string
}

export function renderMarkdown(
  markdown: string,
  options?: MarkdownOptions,
): { readonly title: string; readonly html: string; readonly blocks: { kind: string; spec: object }[] }
export function slugOf(heading: string): string
