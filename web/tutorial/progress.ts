// SPDX-License-Identifier: GPL-3.0-or-later

const KEY = 'circle-voronoi tutorial'

/** The tasks of a chapter that a reader has solved, by their places, and the number of its tasks. */
interface Progress {
  readonly solved: readonly number[]
  readonly tasks: number
}

/**
 * Marks chapters whose questions and exercises are all solved. A task reports that by the event `solved`. Without storage
 * only the open chapter is marked.
 */
export function markSolved(page: Document): void {
  const chapters = new Map(Object.entries(kept()))
  const links = [...page.querySelectorAll<HTMLAnchorElement>('nav.pages ol a, ol.gallery a')]
  const fileOf = (link: HTMLAnchorElement) => link.getAttribute('href') as string
  for (const link of links) if (isSolved(chapters.get(fileOf(link)))) mark(link)
  const own = links.find((link) => link.hasAttribute('aria-current'))
  const tasks = [...page.querySelectorAll('form.question, .try')]
  if (own === undefined || tasks.length === 0) return
  const file = fileOf(own)
  page.addEventListener('solved', ({ target }) => {
    const before = chapters.get(file)?.solved ?? []
    const progress = { solved: [...new Set([...before, tasks.indexOf(target as Element)])], tasks: tasks.length }
    chapters.set(file, progress)
    keep(Object.fromEntries(chapters))
    if (isSolved(progress)) mark(own)
  })
}

function isSolved(progress: Progress | undefined): boolean {
  return progress !== undefined && progress.solved.length >= progress.tasks
}

function mark(link: HTMLAnchorElement): void {
  if (link.classList.contains('solved')) return
  link.classList.add('solved')
  link.append(Object.assign(document.createElement('span'), { className: 'hidden', textContent: ' (solved)' }))
}

function kept(): Record<string, Progress> {
  try {
    const chapters: unknown = JSON.parse(localStorage.getItem(KEY) ?? '{}')
    if (typeof chapters !== 'object' || chapters === null) return {}
    return Object.fromEntries(Object.entries(chapters).filter(([, progress]) => isProgress(progress)))
  } catch {
    return {}
  }
}

function isProgress(value: unknown): value is Progress {
  const { solved, tasks } = (value ?? {}) as { solved?: unknown; tasks?: unknown }
  return Array.isArray(solved) && solved.every(Number.isInteger) && Number.isInteger(tasks)
}

function keep(chapters: Record<string, Progress>): void {
  try {
    localStorage.setItem(KEY, JSON.stringify(chapters))
  } catch {
    // Storage is full or forbidden.
  }
}
