// SPDX-License-Identifier: GPL-3.0-or-later
// A text of the site from Markdown: mathematics between dollars becomes MathML, headings can be linked to, and in chapters
// blocks of code called figure, try, question and so on, which hold JSON, become what a reader can touch.
import MarkdownIt from 'markdown-it'
import definitions from 'markdown-it-deflist'
import temml from 'temml'

/** Kinds of code blocks that become interactive. */
export const BLOCKS = ['figure', 'try', 'question', 'corrupt', 'printed', 'drawn', 'cones']

/**
 * @param {string} markdown
 * @param {object} [options]
 * @param {(kind: string, spec: object, inline: (text: string) => string) => string} [options.block] renders a block;
 * without it there are none
 * @param {(address: string) => string} [options.link] maps the addresses of links and pictures
 * @returns {{ title: string, html: string, blocks: { kind: string, spec: object }[] }}
 */
export function renderMarkdown(markdown, { block, link = (address) => address } = {}) {
  const blocks = []
  const slugs = new Map()
  const md = new MarkdownIt({ html: true }).use(definitions)
  if (block !== undefined) md.use(mathematics)
  const inline = (text) => md.renderInline(text)
  const { escapeHtml } = md.utils
  const { fence, link_open: linkOpen = plain, image } = md.renderer.rules
  md.renderer.rules.fence = (tokens, i, ...rest) => {
    const { info, content } = tokens[i]
    const kind = info.trim()
    if (block === undefined || !BLOCKS.includes(kind)) return fence(tokens, i, ...rest)
    const spec = JSON.parse(content)
    blocks.push({ kind, spec })
    return block(kind, spec, inline)
  }
  md.renderer.rules.code_block = (tokens, i) => {
    const { content } = tokens[i]
    const listed = listOf(content)
    if (listed !== undefined) {
      const items = listed.map(
        ([name, about]) => `<dt><code>${escapeHtml(name)}</code></dt><dd>${escapeHtml(about)}</dd>`,
      )
      return `<dl class="listed">\n${items.join('\n')}\n</dl>\n`
    }
    return `${opened(content)}<code>${escapeHtml(content)}</code></pre>\n`
  }
  md.renderer.rules.link_open = (tokens, i, ...rest) => {
    tokens[i].attrSet('href', link(tokens[i].attrGet('href')))
    return linkOpen(tokens, i, ...rest)
  }
  md.renderer.rules.image = (tokens, i, ...rest) => {
    tokens[i].attrSet('src', link(tokens[i].attrGet('src')))
    return image(tokens, i, ...rest)
  }
  md.renderer.rules.html_block = (tokens, i) => relinked(tokens[i].content, link)
  md.renderer.rules.html_inline = md.renderer.rules.html_block
  md.renderer.rules.table_open = () => '<div class="wide" tabindex="0"><table>\n'
  md.renderer.rules.table_close = () => '</table></div>\n'
  md.renderer.rules.heading_open = (tokens, i, options, _, self) => {
    const slug = slugOf(tokens[i + 1].content)
    const before = slugs.get(slug) ?? 0
    slugs.set(slug, before + 1)
    // Numbers repeated headings like GitHub.
    tokens[i].attrSet('id', before === 0 ? slug : `${slug}-${before}`)
    return self.renderToken(tokens, i, options)
  }
  // A column without a title has no header.
  const html = md.render(markdown).replaceAll('<th></th>', '<td></td>')
  const [, title] = /^# (.*)$/m.exec(markdown) ?? []
  if (title === undefined) throw new Error('A text begins with its title.')
  return { title, html, blocks }
}

function plain(tokens, i, options, _, self) {
  return self.renderToken(tokens, i, options)
}

/** Commands or folders with their descriptions, in two columns. A description may continue in the next line. */
function listOf(content) {
  const items = []
  for (const line of content.trimEnd().split('\n')) {
    const [, name, about] = /^(\S(?:.*?\S)?) {2,}(\S.*)$/.exec(line) ?? []
    const more = /^ {6,}(\S.*)$/.exec(line)?.[1]
    if (/[─│┐└"]/.test(line)) return undefined
    if (name !== undefined) items.push([name, about])
    else if (more !== undefined && items.length > 0) items.at(-1)[1] += ` ${more}`
    else items.push([line.trim(), ''])
  }
  return items.some(([, about]) => about !== '') ? items : undefined
}

/**
 * Allows breaking lines of code. Character drawings keep their lines, and can be scrolled by keys if they are too wide.
 */
function opened(content) {
  return /[─│┐└]/.test(content) ? '<pre class="drawn" tabindex="0">' : '<pre>'
}

function relinked(html, link) {
  return html.replace(/ (src|srcset|href)="([^"]*)"/g, (_, name, address) => ` ${name}="${link(address)}"`)
}

/** The id that GitHub gives to a heading. */
export function slugOf(heading) {
  return heading
    .toLowerCase()
    .replace(/[^\p{L}\p{N}\s_-]/gu, '')
    .trim()
    .replace(/\s/g, '-')
}

/** `$...$` within a line, and `$$...$$` as a paragraph of its own. */
function mathematics(md) {
  md.inline.ruler.before('escape', 'mathematics', (state, isSilent) => {
    const match = /^\$(\$?)([^$]+)\1\$/.exec(state.src.slice(state.pos))
    if (match === null) return false
    if (!isSilent) {
      const token = state.push('mathematics', 'math', 0)
      token.content = match[2]
      token.markup = match[1]
    }
    state.pos += match[0].length
    return true
  })
  md.renderer.rules.mathematics = (tokens, i) => {
    const displayMode = tokens[i].markup !== ''
    const math = temml
      .renderToString(tokens[i].content, { displayMode, throwOnError: true })
      // The policy of the pages allows no style attributes. Browsers use this style anyway.
      .replace(' style="display:block math;"', '')
    return displayMode ? `<span class="wide formula" tabindex="0">${math}</span>` : math
  }
}
