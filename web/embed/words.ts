// SPDX-License-Identifier: GPL-3.0-or-later

/** The texts of a frame. */
export interface FrameWords {
  readonly title: string
  readonly open: string
  readonly startOver: string
  readonly met: string
  readonly unmet: string
}

const ENGLISH: FrameWords = {
  title: 'Voronoi diagram of circles',
  open: 'Open',
  startOver: 'Start over',
  met: 'Solved',
  unmet: 'Not solved yet',
}

const GERMAN: FrameWords = {
  title: 'Voronoi-Diagramm von Kreisen',
  open: 'Öffnen',
  startOver: 'Neu beginnen',
  met: 'Gelöst',
  unmet: 'Noch nicht gelöst',
}

export function frameWords(lang: string): FrameWords {
  return /^de(-|$)/i.test(lang) ? GERMAN : ENGLISH
}
