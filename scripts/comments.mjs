// SPDX-License-Identifier: GPL-3.0-or-later
// Checks that no sentence of a comment begins with a pronoun or a conjunction that stands for its subject, such as
// "What is drawn." With --count it prints the share of such sentences in every folder.
import { execFileSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { isMain, main, ROOT } from './run.mjs'

const COMMENT = /(?:^|\s)(?:\/\/[/!]?<?|#)(?: (.*)|$)|^\s*(?:\/\*\*?|\*(?!\/))(?: (.*)|$)|\s\/\*\* (.*)$/
const HEADLESS =
  /^(?:What|Whose|Whom?|Whoever|Whatever|None|Likewise|Nothing but|All that|Whether what|(?:So|How|As) (?:many|much|far|large|long|often|small|few|near|high|it|does|do|is|are|that)|(?:Those|Such|That|The ones?|The same|The others?)(?: (?:of|that|which|who|with|without|in|on|for|as|from)|[,.:;(])|(?:Of|By|For|From|In|On|To|With|At) (?:what|which|whom|whose|that|those|it|these|them|how))(?![-\w])/
/** A clause may begin with these words if a comma and a sentence follow it: "Where two arcs meet, a cell has a corner." */
const CLAUSE = /^(?:As|Where|Wherever|How|Of|Which|To whom|From where) [^,:]*$/

/** Returns the sentences of a source text's comments, each with the number of the line where its comment begins. */
export function sentencesOf(text) {
  const sentences = []
  let open = []
  let line = 0
  const close = () => {
    for (const sentence of open.join(' ').split(/(?<=[.!?]) +(?=[A-Z])/))
      if (/\w/.test(sentence)) sentences.push({ line, sentence })
    open = []
  }
  const docstrings = (all) => all.replaceAll('"""', '').replaceAll(/^ */gm, '# ')
  text
    .replaceAll(/^ *"""[\s\S]*?"""/gm, docstrings)
    .split('\n')
    .forEach((code, k) => {
      const comment = COMMENT.exec(code)
        ?.slice(1)
        .find((part) => part !== undefined)
      const isWholeLine = /^\s*(?:\/|\*|#)/.test(code)
      if (!comment || !isWholeLine || /^\s*(?:@|- )/.test(comment)) close()
      if (!comment || comment.startsWith('SPDX')) return
      if (open.length === 0) line = k + 1
      open.push(comment.replace(/^@(?:param \S+|\w+) /, '').replace(/\s*\*\/.*$/, ''))
      if (!isWholeLine) close()
    })
  close()
  return sentences
}

/** Whether a sentence begins without a noun. */
export function isHeadless(sentence) {
  return HEADLESS.test(sentence) || CLAUSE.test(sentence)
}

function sourceFiles() {
  const names = execFileSync('git', ['ls-files'], { cwd: ROOT, encoding: 'utf8' }).split('\n')
  return names.filter((name) => /\.(?:[cm]?[jt]sx?|cpp|h|py)$/.test(name) && !name.includes('third_party'))
}

function printCounts() {
  const counts = {}
  for (const name of sourceFiles()) {
    const folder = name
      .split('/')
      .slice(0, -1)
      .slice(0, name.startsWith('cpp/src') ? 3 : 2)
      .join('/')
    counts[folder] ??= { sentences: 0, headless: 0 }
    for (const { sentence } of sentencesOf(readFileSync(ROOT + name, 'utf8'))) {
      counts[folder].sentences += 1
      if (isHeadless(sentence)) counts[folder].headless += 1
    }
  }
  console.table(counts)
}

if (isMain(import.meta.url)) {
  await main(() => {
    if (process.argv.includes('--count')) return printCounts()
    const names = sourceFiles()
    const found = names.flatMap((name) =>
      sentencesOf(readFileSync(ROOT + name, 'utf8'))
        .filter(({ sentence }) => isHeadless(sentence))
        .map(({ line, sentence }) => `${name}:${line}: ${sentence}`),
    )
    if (found.length > 0) throw new Error(`Begin these sentences of comments with their subject:\n${found.join('\n')}`)
    console.log(`The comments of ${names.length} files begin with their subjects.`)
  })
}
