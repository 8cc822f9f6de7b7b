// SPDX-License-Identifier: GPL-3.0-or-later
import type MiniSearch from 'minisearch'

const MOST = 8
interface Page {
  readonly id: number
  readonly title: string
  readonly file: string
}

/** A search over all pages, in the page itself: what it needs is loaded when somebody begins to search. */
export function offerSearch(page: Document): void {
  const form = page.querySelector('form.search') as HTMLFormElement
  const field = form.elements.namedItem('q') as HTMLInputElement
  const list = page.querySelector('ol.found') as HTMLOListElement
  let loading: Promise<MiniSearch<Page>> | undefined
  const load = () => {
    loading ??= loadSearch().catch((error) => {
      loading = undefined
      throw error
    })
    return loading
  }

  field.addEventListener('focus', () => void load().catch(() => {}), { once: true })
  field.addEventListener('input', () => void show())
  form.addEventListener('submit', (event) => {
    event.preventDefault()
    list.querySelector('a')?.click()
  })
  form.addEventListener('keydown', ({ key }) => {
    if (key === 'Escape') list.hidden = true
  })

  // Somebody may have been faster than this script.
  if (field.value !== '') void show()

  async function show() {
    const words = field.value.trim()
    try {
      const search = await load()
      if (words !== field.value.trim()) return
      const found = search.search(words, { prefix: true, fuzzy: 0.2, boost: { title: 3 } }).slice(0, MOST)
      say(found.map(({ file, title }) => linkTo(file, title)))
      if (words !== '' && found.length === 0) say(['Nothing found.'])
    } catch {
      say(['The search could not be loaded.'])
    }
    list.hidden = words === ''
  }

  function say(items: (Node | string)[]) {
    list.replaceChildren(
      ...items.map((item) => {
        const entry = page.createElement('li')
        entry.append(item)
        return entry
      }),
    )
  }

  function linkTo(file: string, title: string) {
    return Object.assign(page.createElement('a'), { href: `../${file}`, textContent: title })
  }
}

async function loadSearch(): Promise<MiniSearch<Page>> {
  const [{ default: Search }, index] = await Promise.all([import('minisearch'), fetch('../search.json')])
  if (!index.ok) throw new Error(`search.json: ${index.status}`)
  return Search.loadJSON(await index.text(), { fields: ['title', 'text'], storeFields: ['title', 'file'] })
}
