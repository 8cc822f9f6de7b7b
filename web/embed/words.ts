// SPDX-License-Identifier: GPL-3.0-or-later

/** The texts of a frame. */
const ENGLISH = {
  title: 'Voronoi diagram of circles',
  open: 'Open',
  startOver: 'Start over',
  met: 'Solved',
  unmet: 'Not solved yet',
}

export type FrameWords = typeof ENGLISH

const GERMAN = {
  title: 'Voronoi-Diagramm von Kreisen',
  open: 'Öffnen',
  startOver: 'Neu beginnen',
  met: 'Gelöst',
  unmet: 'Noch nicht gelöst',
} satisfies FrameWords

export function frameWords(lang: string): FrameWords {
  return /^de(-|$)/i.test(lang) ? GERMAN : ENGLISH
}
