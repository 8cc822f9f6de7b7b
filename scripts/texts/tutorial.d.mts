// SPDX-License-Identifier: GPL-3.0-or-later
/** A block of a chapter, with the properties of some kinds. */
export interface Spec {
  readonly name: string
  readonly caption?: string
  readonly ask?: string
  readonly hint?: string
  readonly answer?: string
  readonly circles?: readonly (readonly number[])[]
  readonly dataSet?: string
  readonly layers?: Readonly<Record<string, unknown>>
  readonly check?: unknown
  /** The rules that a figure of the kind `printed` applies as printed. */
  readonly rules: readonly ('side' | 'third' | 'crossing' | 'inside')[]
  /** The rules that are shown one at a time below the figure, each with the place of the figure where it applies. */
  readonly rulesShown?: readonly { readonly at?: number; readonly text: string }[]
  /** The drawing of a figure of the kind `drawn` (web/tutorial/drawn). */
  readonly kind?: string
  readonly point?: readonly [number, number]
  readonly view?: readonly [number, number, number]
  readonly stepsBetween?: readonly [number, number]
  readonly solution: readonly (readonly number[])[]
  readonly choices: readonly string[]
  readonly right: number
}

export interface Chapter {
  readonly file: string
  readonly isChapter: boolean
  readonly title: string
  /** The figure and the line that represent a chapter in the contents. */
  readonly shown: string | undefined
  readonly line: string | undefined
  readonly markdown: string
  readonly blocks: readonly {
    readonly kind: 'figure' | 'try' | 'question' | 'corrupt' | 'printed' | 'drawn' | 'cones'
    readonly spec: Spec
  }[]
}

export function readBook(): readonly Chapter[]

/** The parts of a figure that are made for the site. */
export interface Made {
  readonly circles: number[][]
  /** The fragment of its link, without the #. */
  readonly link: string
  /** The file of its picture. */
  readonly poster?: string
  /** The result of the rules as printed. */
  readonly printed?: { readonly poster: string; readonly sentence: string }
  /** A drawing of the tutorial, with the file of its picture. */
  readonly drawing?: {
    readonly poster: string
    readonly height: number
    readonly told: string
    readonly last: number
    readonly step: number | string
  }
}

/** Writes the pictures of figures into the folder of the built site. */
export function tutorialTexts(folder: string): Promise<import('./page.mjs').Text[]>
