// SPDX-License-Identifier: GPL-3.0-or-later
export function headingsOf(html: string): { level: number; id: string; title: string }[]
export function sectionsOf(html: string): { id: string; heading: string; text: string }[]
export function wordsOf(html: string): string
export function firstSentence(words: string): string
