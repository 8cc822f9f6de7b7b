// SPDX-License-Identifier: GPL-3.0-or-later
// The headings of a page, and the text below each: for tables of contents and for the search.

const HEADING = /<h([1-4])(?: id="([^"]*)")?[^>]*>([\s\S]*?)<\/h\1>/g
const NAMED = { '&amp;': '&', '&lt;': '<', '&gt;': '>', '&quot;': '"', '&#39;': "'", '&nbsp;': ' ' }

/**
 * @param {string} html
 * @returns {{ level: number, id: string, title: string }[]} the headings that can be linked to, without the title
 */
export function headingsOf(html) {
  return [...html.matchAll(HEADING)]
    .map(([, level, id = '', inner]) => ({ level: Number(level), id, title: wordsOf(inner) }))
    .filter(({ level, id }) => level > 1 && id !== '')
}

/**
 * @param {string} page
 * @returns {{ id: string, heading: string, text: string }[]} the text before the first linkable heading, with an empty id
 *   and heading, then the text below each linkable heading
 */
export function sectionsOf(page) {
  // Complete sources and the buttons of examples are not text.
  const html = page.replace(/<details id="[^"]*">[\s\S]*?<\/details>|<figure class="example"[\s\S]*?<\/figure>/g, ' ')
  const marks = [...html.matchAll(HEADING)].filter(([, level, id]) => level === '1' || id)
  const starts = [{ id: '', heading: '', from: 0 }]
  for (const { 0: whole, 1: level, 2: id, 3: inner, index } of marks) {
    const from = index + whole.length
    if (level === '1') starts[0].from = from
    else starts.push({ id, heading: wordsOf(inner), from, at: index })
  }
  return starts
    .map(({ id, heading, from }, k) => ({ id, heading, text: wordsOf(html.slice(from, starts[k + 1]?.at)) }))
    .filter(({ heading, text }) => heading !== '' || text !== '')
}

/** The words of HTML without tags. */
export function wordsOf(html) {
  return html
    .replace(/<(?:style|script|annotation)[\s\S]*?<\/(?:style|script|annotation)>/g, ' ')
    .replace(/<\/?(?:code|b|em|strong|a|i|sup|sub|span|m\w+)\b[^>]*>/g, '')
    .replace(/<[^>]*>/g, ' ')
    .replace(/&(?:#39|\w+);/g, (entity) => NAMED[entity] ?? ' ')
    .replace(/\s+/g, ' ')
    .trim()
}

/**
 * @param {string} words
 * @returns {string} the complete first sentence
 */
export function firstSentence(words) {
  const [sentence] = /^.*?[.?!](?=\s|$)(?<!\b(?:e\.g|i\.e|vs)\.)/.exec(words) ?? []
  return sentence ?? words.replace(/:$/, '.')
}
