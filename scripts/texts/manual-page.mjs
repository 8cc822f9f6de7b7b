// SPDX-License-Identifier: GPL-3.0-or-later
// The manual page, which is in mdoc, as HTML. Macros that it does not use are unknown here.
import { slugOf } from './markdown.mjs'
import { escaped } from './page.mjs'

const WORDS = {
  Fl: (word) => `<code class="flag">-${word}</code>`,
  Ar: (word) => `<var>${word}</var>`,
  Cm: (word) => `<code>${word}</code>`,
  Li: (word) => `<code>${word}</code>`,
  Pa: (word) => `<code>${word}</code>`,
  Nm: (word) => `<code>${word}</code>`,
  Sq: (word) => `‘<code>${word}</code>’`,
}
const CLOSING = /^[.,;:)\]|]$/
const SETTINGS = ['Dd', 'Dt', 'Os']

/** @returns {{ name: string, html: string }} */
export function renderManualPage(mdoc) {
  const out = []
  let name = ''
  let section = ''
  let isInDefinition = false
  let isInParagraph = false
  let examples = []

  const write = (html) => {
    if (!isInParagraph && !isInDefinition) {
      out.push('<p>')
      isInParagraph = true
    }
    out.push(html)
  }
  const endParagraph = () => {
    if (isInParagraph) out.push('</p>')
    isInParagraph = false
  }
  const endExamples = () => {
    if (examples.length > 0) out.push(`<pre tabindex="0"><code>${examples.join('\n')}\n</code></pre>`)
    examples = []
  }
  const heading = (level, title) => {
    endParagraph()
    out.push(`<h${level} id="${slugOf(title)}">${title}</h${level}>`)
  }

  const macros = {
    Sh(title) {
      section = title
      const written = title.charAt(0) + title.slice(1).toLowerCase()
      if (title !== 'NAME') heading(2, written)
    },
    Ss: (title) => heading(3, escaped(title)),
    Nd() {},
    Nm(rest) {
      if (name === '') name = rest
      if (section === 'NAME') return
      if (section === 'SYNOPSIS') {
        endParagraph()
        write(`<code>${name}</code>`)
      } else write(inline(`Nm ${rest || name}`))
    },
    Op: (rest) => write(`[${inline(rest)}]`),
    Sx: (rest) => {
      const [title, ...after] = rest.split(' ')
      write(`<a href="#${slugOf(title)}">${title.charAt(0)}${title.slice(1).toLowerCase()}</a>${after.join('')}`)
    },
    Pp() {
      endExamples()
      endParagraph()
    },
    Bl() {
      endParagraph()
      out.push('<dl>')
    },
    It(rest) {
      if (isInDefinition) out.push('</dd>')
      isInDefinition = true
      const isMacro = Object.hasOwn(WORDS, rest.split(' ')[0])
      out.push(`<dt>${isMacro ? inline(rest) : escaped(rest)}</dt><dd>`)
    },
    El() {
      out.push('</dd></dl>')
      isInDefinition = false
    },
    Dl(rest) {
      endParagraph()
      examples.push(escaped(rest))
    },
  }

  for (const line of mdoc.split('\n')) {
    const [, macro, rest] = /^\.(\w+) ?(.*)$/.exec(unescaped(line)) ?? []
    if (macro !== 'Dl') endExamples()
    if (line.startsWith('.\\"') || line === '' || SETTINGS.includes(macro)) continue
    if (macro === undefined) write(escaped(unescaped(line)))
    else if (Object.hasOwn(macros, macro)) macros[macro](rest)
    else if (Object.hasOwn(WORDS, macro)) write(inline(`${macro} ${rest}`))
    else throw new Error(`The manual page has a macro that is not known here: ${macro}.`)
  }
  endExamples()
  endParagraph()
  return { name, html: out.join('\n').replace(/<dd>\s*<\/dd>\s*(?=<dt>)/g, '') }
}

/** The words of a line of macros; what closes comes after a word without a space. */
function inline(line) {
  let html = ''
  let macro
  let isJoined = true
  for (const word of line.split(' ')) {
    if (word === 'Ns') isJoined = true
    else if (Object.hasOwn(WORDS, word) && word.length === 2) macro = word
    else {
      const isClosing = CLOSING.test(word) && word !== '|'
      if (!isJoined && !isClosing) html += ' '
      const isPlain = macro === undefined || CLOSING.test(word) || word === '='
      html += isPlain ? escaped(word) : WORDS[macro](escaped(word))
      isJoined = false
    }
  }
  return html
}

function unescaped(text) {
  return text.replaceAll('\\(dq', '"').replaceAll('\\-', '−')
}
