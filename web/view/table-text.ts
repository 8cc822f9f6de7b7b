// SPDX-License-Identifier: GPL-3.0-or-later
// Tables as text (CSV), read as `cpp/src/io/csv_table` and `cpp/src/io/csv` read them. The module for files is larger than
// everything else in an element together; tests/files/readings.json has the cases that both must read alike.

/** A field without the white space around it and without quotation marks. */
export interface TableField {
  readonly text: string
  readonly isQuoted: boolean
}

export interface TableRecord {
  /** The line where the record begins, from 1. */
  readonly line: number
  readonly fields: readonly TableField[]
}

/** What is wrong with a text, and where. */
export class TextProblem extends Error {
  /** The line, from 1; `undefined` if it is not about one. */
  readonly line: number | undefined
  /** The index of the circle; `undefined` if it is not about one. */
  readonly circle: number | undefined

  constructor(message: string, { line, circle }: { line?: number | undefined; circle?: number | undefined } = {}) {
    super(message)
    this.line = line
    this.circle = circle
  }
}

/** In the order in which they are tried: a comma may be a decimal mark, and spaces stand beside separators. */
export const SEPARATORS = [';', '\t', ',', ' '] as const
export type Separator = (typeof SEPARATORS)[number] | '|'

const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i
const DECIMAL_COMMA = /^([^.,]*),(\d[^.,]*)$/

/**
 * The records of a table: lines that are not blank, hold more than separators, and do not begin with `#`. A line end in
 * quotation marks belongs to a field. A space as the separator stands for any number of spaces and tabs.
 *
 * @throws TextProblem if quotation marks are amiss
 */
export function* recordsOf(text: string, separator: Separator): Generator<TableRecord> {
  let at = text.startsWith('\uFEFF') ? 1 : 0
  let line = 1
  const isLineEnd = () => at === text.length || text[at] === '\n' || text[at] === '\r'
  const isBlank = () => text[at] === ' ' || (text[at] === '\t' && separator !== '\t')
  const skipBlanks = () => {
    while (isBlank()) at += 1
  }

  const quoted = (): TableField => {
    const begin = line
    let value = ''
    for (at += 1; ; at += 1) {
      if (at === text.length) throw new TextProblem('a quotation mark is not closed', { line: begin })
      if (text[at] === '"' && text[at + 1] !== '"') break
      if (text[at] === '"') at += 1
      if (text[at] === '\n' || (text[at] === '\r' && text[at + 1] !== '\n')) line += 1
      value += text[at]
    }
    at += 1
    const end = at
    skipBlanks()
    const isOver = isLineEnd() || text[at] === separator || (separator === ' ' && at > end)
    if (!isOver) throw new TextProblem('a field goes on after its closing quotation mark', { line })
    return { text: value.replace(/^[ \t]+/, '').replace(/(?<![ \t])[ \t]+$/, ''), isQuoted: true }
  }

  const field = (): TableField => {
    if (text[at] === '"') return quoted()
    const from = at
    let to = at
    for (; !isLineEnd() && text[at] !== separator; at += 1) {
      if (text[at] === '\t' && separator === ' ') break
      if (text[at] !== ' ' && text[at] !== '\t') to = at + 1
    }
    return { text: text.slice(from, to), isQuoted: false }
  }

  while (at < text.length) {
    const begin = line
    skipBlanks()
    const fields: TableField[] = []
    if (text[at] === '#') {
      while (!isLineEnd()) at += 1
    } else {
      let hasMore = true
      for (; !isLineEnd(); skipBlanks()) {
        fields.push(field())
        hasMore = !isLineEnd()
        if (!hasMore) break
        if (separator !== ' ') at += 1
      }
      // An empty field follows the last separator.
      if (hasMore && separator !== ' ') fields.push({ text: '', isQuoted: false })
    }
    if (text[at] === '\r' && text[at + 1] === '\n') at += 1
    at += 1
    line += 1
    if (fields.some(({ text }) => text !== '')) yield { line: begin, fields }
  }
}

/** Reads numbers with a decimal point, or a decimal comma where commas separate no fields, but not with both. */
export class NumberReader {
  readonly #mayBeComma: boolean
  #mark = ''

  constructor(separator: Separator) {
    this.#mayBeComma = separator === ';' || separator === '\t' || separator === '|'
  }

  /** `undefined`: the field is no finite number, or has another decimal mark than the numbers before it. */
  read({ text, isQuoted }: TableField): number | undefined {
    const isComma = (this.#mayBeComma || isQuoted) && DECIMAL_COMMA.test(text)
    const digits = isComma ? text.replace(',', '.') : text
    if (!NUMBER.test(digits)) return undefined
    const value = Number(digits)
    // Beyond the range of a double, on either side.
    if (!Number.isFinite(value) || (value === 0 && /[1-9]/.test(digits.replace(/e.*/i, '')))) return undefined
    const mark = isComma ? ',' : digits.includes('.') ? '.' : ''
    if (mark !== '' && this.#mark !== '' && mark !== this.#mark) return undefined
    this.#mark ||= mark
    return value
  }
}

/** Fields without the empty ones at the end. */
export function filled(fields: readonly TableField[]): readonly TableField[] {
  let count = fields.length
  while (count > 0 && fields[count - 1]?.text === '') count -= 1
  return fields.slice(0, count)
}
