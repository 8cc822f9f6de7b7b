// SPDX-License-Identifier: GPL-3.0-or-later
import type MiniSearch from 'minisearch'
import type { SearchOptions } from 'minisearch'

/** A section of a page, as scripts/texts/texts.mjs writes it. */
export interface Section {
  readonly title: string
  /** The section's heading; empty for text before the first heading. */
  readonly heading: string
  /** The address, relative to the site's folder. */
  readonly address: string
  /** The beginning of the section's text. */
  readonly shown: string
}

/** An excerpt around the first match, in parts that are highlighted or not. */
export type Snippet = readonly { readonly text: string; readonly isMarked: boolean }[]

const MOST = 10
/** The largest number of results of one page. */
const MOST_OF_PAGE = 3
/** Characters of a snippet before the match. */
const BEFORE = 40
const LENGTH = 150
/** Pages that explain come before the reference and the changelog, which contain almost every word. */
const MINOR = /^(?:api\/|docs\/changelog\.html)/
const MINOR_BOOST = 0.3
/** The share of letters that may differ, in a word that the site does not contain. */
const MISSPELLED = 0.2
const SHORTEST_MISSPELLED = 5

const OPTIONS: SearchOptions = {
  combineWith: 'AND',
  prefix: (term) => term.length > 2,
  // An exact match counts more than a word that only begins with the query.
  weights: { prefix: 0.35, fuzzy: 0.1 },
  boost: { title: 4, heading: 4 },
  boostDocument: (_, term, stored) => {
    const { title = '', heading = '', address = '' } = (stored ?? {}) as Partial<Section>
    const isNamed = `${title} ${heading}`
      .toLowerCase()
      .split(/[^\p{L}\p{N}]+/u)
      .includes(term.toLowerCase())
    return (MINOR.test(address) ? MINOR_BOOST : 1) * (isNamed ? 2 : 1)
  },
}

export interface Found extends Section {
  readonly snippet: Snippet
}

/**
 * Returns the sections that contain all words of a query, the best first. If no section contains all words, sections
 * with some of the words are returned. Other spellings are tried only for words that no section contains, even as a
 * beginning.
 */
export function find(search: MiniSearch<Section>, words: string): readonly Found[] {
  const isKnown = (term: string) => search.search(term, OPTIONS).length > 0
  const options: SearchOptions = {
    ...OPTIONS,
    fuzzy: (term) => (term.length >= SHORTEST_MISSPELLED && !isKnown(term) ? MISSPELLED : false),
  }
  const all = search.search(words, options)
  const results = all.length > 0 ? all : search.search(words, { ...options, combineWith: 'OR' })
  const ofPage = new Map<string, number>()
  return results
    .filter(({ address }) => {
      const [page] = (address as string).split('#') as [string]
      const count = (ofPage.get(page) ?? 0) + 1
      ofPage.set(page, count)
      return count <= MOST_OF_PAGE
    })
    .slice(0, MOST)
    .map((result) => {
      const { title, heading, address, shown } = result as unknown as Section
      return { title, heading, address, shown, snippet: snippetOf(shown, result.terms) }
    })
}

export function snippetOf(text: string, terms: readonly string[]): Snippet {
  const escaped = terms.map((term) => term.replace(/[.*+?^${}()|[\]\\]/g, '\\$&'))
  const pattern = terms.length === 0 ? /$^/g : new RegExp(`(?<![\\p{L}\\p{N}])(?:${escaped.join('|')})`, 'giu')
  const first = text.search(pattern)
  const start = first <= BEFORE ? 0 : text.indexOf(' ', first - BEFORE) + 1
  const end = text.length - start <= LENGTH ? text.length : text.lastIndexOf(' ', start + LENGTH)
  const shown = text.slice(start, end)
  const parts: { text: string; isMarked: boolean }[] = []
  const add = (part: string, isMarked: boolean) => part !== '' && parts.push({ text: part, isMarked })
  if (start > 0) add('… ', false)
  let reached = 0
  for (const { 0: word, index } of shown.matchAll(pattern)) {
    add(shown.slice(reached, index), false)
    add(word, true)
    reached = index + word.length
  }
  add(shown.slice(reached), false)
  if (end < text.length) add(' …', false)
  return parts
}

/** Adds a search over all pages, which runs in the browser. Its index is loaded on first use. */
export function offerSearch(page: Document): void {
  const form = page.querySelector('form.search') as HTMLFormElement
  const field = form.elements.namedItem('q') as HTMLInputElement
  const list = page.querySelector('ol.found') as HTMLOListElement
  let loading: Promise<MiniSearch<Section>> | undefined
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
  const box = form.parentElement as HTMLElement
  box.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') {
      list.hidden = true
      field.focus()
    }
    if (event.key !== 'ArrowDown' && event.key !== 'ArrowUp') return
    const stops: HTMLElement[] = [field, ...list.querySelectorAll('a')]
    const next = stops[stops.indexOf(page.activeElement as HTMLElement) + (event.key === 'ArrowDown' ? 1 : -1)]
    if (next === undefined) return
    event.preventDefault()
    next.focus()
  })
  page.addEventListener('pointerdown', ({ target }) => {
    if (!box.contains(target as Node)) list.hidden = true
  })

  // The user may have typed before this script ran.
  if (field.value !== '') void show()

  async function show() {
    const words = field.value.trim()
    try {
      const search = await load()
      if (words !== field.value.trim()) return
      const found = find(search, words)
      say(found.map(linkTo))
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

  function linkTo({ title, heading, address, snippet }: Found) {
    const link = Object.assign(page.createElement('a'), { href: `../${address}` })
    // A link to this page only scrolls.
    link.addEventListener('click', () => {
      list.hidden = true
    })
    link.append(element('b', heading || title))
    if (heading !== '') link.append(' ', element('i', title))
    const words = page.createElement('span')
    words.append(...snippet.map(({ text, isMarked }) => (isMarked ? element('mark', text) : text)))
    link.append(words)
    return link
  }

  function element(name: string, textContent: string) {
    return Object.assign(page.createElement(name), { textContent })
  }
}

async function loadSearch(): Promise<MiniSearch<Section>> {
  const [{ default: Search }, index] = await Promise.all([import('minisearch'), fetch('../search.json')])
  if (!index.ok) throw new Error(`search.json: ${index.status}`)
  return Search.loadJSON(await index.text(), {
    fields: ['title', 'heading', 'text'],
    storeFields: ['title', 'heading', 'address', 'shown'],
  })
}
