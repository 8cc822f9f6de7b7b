// SPDX-License-Identifier: GPL-3.0-or-later
// The search of the site: results, ranking and snippets.
// @vitest-environment happy-dom
import MiniSearch from 'minisearch'
import { describe, expect, it, test, vi } from 'vitest'
import { firstSentence, headingsOf, sectionsOf } from '../../scripts/texts/sections.mjs'
import { find, offerSearch, type Section, snippetOf } from '../../web/reading/search.ts'
import { openPage, send, textOf } from './page-document.ts'

function searchIn(sections: readonly Section[]): MiniSearch<Section> {
  const search = new MiniSearch<Section>({
    fields: ['title', 'heading', 'text'],
    storeFields: ['title', 'heading', 'address', 'shown'],
  })
  search.addAll(sections.map((section) => ({ ...section, id: section.address, text: section.shown })))
  return search
}

const section = (address: string, title: string, heading: string, shown: string): Section => ({
  address,
  title,
  heading,
  shown,
})

const addressesOf = (sections: readonly Section[], words: string) =>
  find(searchIn(sections), words).map(({ address }) => address)

describe('order', () => {
  it('has words as they are written before those that begin so or are spelled so', () => {
    const sections = [
      section('docs/a.html', 'Reactions', '', 'Reaction, reactor, reactive: react.ions'),
      section('docs/b.html', 'Cookbook', 'Use it in React', 'The element works in React.'),
    ]
    expect(addressesOf(sections, 'react')[0]).toBe('docs/b.html')
  })

  it('tries another spelling only of words that no section has', () => {
    const sections = [
      section('docs/a.html', 'Speed', '', 'It takes over a second to go over a cover.'),
      section('docs/b.html', 'Element', '', 'A figure fires an event on hover.'),
    ]
    expect(addressesOf(sections, 'hover')).toEqual(['docs/b.html'])
    expect(addressesOf(sections, 'hovver')).toEqual(['docs/b.html'])
    expect(addressesOf(sections, 'hover secnd')).toEqual(['docs/b.html', 'docs/a.html'])
  })

  it('has pages that explain before the changelog', () => {
    const sections = [
      section('docs/changelog.html#unreleased', 'Changelog', 'Unreleased', 'array array layout layout'),
      section(
        'docs/javascript.html#arrays',
        'Use it from JavaScript',
        'Arrays',
        'The layout of each array of a diagram.',
      ),
    ]
    expect(addressesOf(sections, 'array layout')[0]).toBe('docs/javascript.html#arrays')
  })

  it('has sections with all words before others', () => {
    const sections = [
      section('docs/a.html', 'Canvas', '', 'canvas canvas canvas'),
      section('docs/b.html', 'Other', '', 'A canvas in a worker.'),
    ]
    expect(addressesOf(sections, 'canvas worker')).toEqual(['docs/b.html'])
    expect(addressesOf(sections, 'canvas nowhere')).toHaveLength(2)
  })

  it('has three sections of a page at most', () => {
    const sections = Array.from({ length: 5 }, (_, k) => section(`docs/a.html#${k}`, 'A', `${k}`, 'disc'))
    expect(addressesOf(sections, 'disc')).toHaveLength(3)
  })
})

describe('a snippet', () => {
  const text = `${'before '.repeat(20)}the antipodal disc of two circles ${'after '.repeat(40)}`

  it('shows the words around the first one that was found, which is marked', () => {
    const snippet = snippetOf(text, ['antipodal'])
    expect(snippet.find(({ isMarked }) => isMarked)?.text).toBe('antipodal')
    const shown = snippet.map((part) => part.text).join('')
    expect(shown).toContain('before the antipodal disc of two circles after')
    expect(shown.length).toBeLessThan(170)
    expect(shown).toMatch(/^… .* …$/)
  })

  it('begins with the text where nothing of it was found', () => {
    expect(snippetOf('Some text.', ['other'])).toEqual([{ text: 'Some text.', isMarked: false }])
    expect(snippetOf('', [])).toEqual([])
  })

  it('takes words as words', () => {
    expect(snippetOf('a.b (c', ['(c', 'a.'])).toEqual([
      { text: 'a.', isMarked: true },
      { text: 'b ', isMarked: false },
      { text: '(c', isMarked: true },
    ])
  })
})

describe('sections of a page', () => {
  const html =
    '<h1>Title</h1><p>First &amp; <code>second()</code>.</p><h2 id="one">One</h2><p>Text</p><h3 id="deep">Deep</h3><p>More</p><h2>None</h2><p>goes on</p>'

  it('have the text below each heading that can be linked to', () => {
    expect(sectionsOf(html)).toEqual([
      { id: '', heading: '', text: 'First & second().' },
      { id: 'one', heading: 'One', text: 'Text' },
      { id: 'deep', heading: 'Deep', text: 'More None goes on' },
    ])
    expect(headingsOf(html)).toEqual([
      { level: 2, id: 'one', title: 'One' },
      { level: 3, id: 'deep', title: 'Deep' },
    ])
  })
})

it('is loaded again where loading it failed', async () => {
  openPage('<div><form class="search"><input name="q" value="disc" /></form><ol class="found" hidden></ol></div>')
  const [field, list] = ['input', 'ol'].map((name) => document.querySelector(name)) as [Element, HTMLElement]
  const shown = () => [...list.children].map(textOf)
  let isThere = false
  const index = JSON.stringify(searchIn([section('docs/a.html', 'Discs', '', 'A disc.')]))
  vi.stubGlobal('fetch', async () => ({ ok: isThere, status: 404, text: async () => index }))
  offerSearch(document)
  await expect.poll(shown).toEqual(['The search could not be loaded.'])
  isThere = true
  send(field, 'input')
  await expect.poll(shown).toEqual(['DiscsA disc.'])
  expect(list.hidden).toBe(false)
  vi.unstubAllGlobals()
})

test('a first sentence is whole', () => {
  expect(firstSentence('Computes it. And more.')).toBe('Computes it.')
  expect(firstSentence('Use e.g. this one. Not that.')).toBe('Use e.g. this one.')
  expect(firstSentence('The file circle.h has it: see there')).toBe('The file circle.h has it: see there')
  expect(firstSentence('Is it so? Yes.')).toBe('Is it so?')
  expect(firstSentence('The examples begin with:')).toBe('The examples begin with.')
})
