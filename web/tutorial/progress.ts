// SPDX-License-Identifier: GPL-3.0-or-later

const KEY = 'circle-voronoi tutorial'

/** Marks chapters as read once their end has been seen. Without storage no chapter is marked. */
export function markRead(page: Document): void {
  const read = new Set(kept())
  for (const link of page.querySelectorAll<HTMLAnchorElement>('nav.pages ol a, ol.gallery a')) {
    const file = link.getAttribute('href') as string
    if (!read.has(file)) continue
    link.classList.add('read')
    link.append(Object.assign(page.createElement('span'), { className: 'hidden', textContent: ' (read)' }))
  }
  const file = page.querySelector('nav.pages ol a[aria-current]')?.getAttribute('href')
  const end = page.querySelector('nav.turn')
  if (!file || end === null) return
  new IntersectionObserver(([entry], observer) => {
    if (!entry?.isIntersecting) return
    observer.disconnect()
    read.add(file)
    keep([...read])
  }).observe(end)
}

function kept(): string[] {
  try {
    const files: unknown = JSON.parse(localStorage.getItem(KEY) ?? '[]')
    return Array.isArray(files) ? files.filter((file) => typeof file === 'string') : []
  } catch {
    return []
  }
}

function keep(files: string[]): void {
  try {
    localStorage.setItem(KEY, JSON.stringify(files))
  } catch {
    // Storage is full or forbidden.
  }
}
