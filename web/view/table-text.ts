// SPDX-License-Identifier: GPL-3.0-or-later
// Reads tables as text (CSV) with the same results as `cpp/src/io/csv_table` and `cpp/src/io/csv`. The files module is
// larger than the rest of an element, so it is not used here. tests/files/readings.json has the cases on which both
// must agree.

/** A field without surrounding white space and quotation marks. */
export interface TableField {
  readonly text: string
  readonly isQuoted: boolean
}

export interface TableRecord {
  /** The line where the record begins, from 1. */
  readonly line: number
  readonly fields: readonly TableField[]
}

/** An error in a text, with its position. */
export class TextProblem extends Error {
  /** The line, from 1; `undefined` if the error has none. */
  readonly line: number | undefined
  /** The index of the circle; `undefined` if the error has none. */
  readonly circle: number | undefined

  constructor(message: string, { line, circle }: { line?: number | undefined; circle?: number | undefined } = {}) {
    super(message)
    this.line = line
    this.circle = circle
  }
}

/**
 * The separators in the order in which they are tried. A comma may be a decimal mark, and spaces may surround other
 * separators.
 */
export const SEPARATORS = [';', '\t', '|', ',', ' '] as const
export type Separator = (typeof SEPARATORS)[number]

/** A line that names the separator, as Excel writes it. */
const SEPARATOR_LINE = /^[ \t]*("?)sep=(.)\1 *$/i

/** The separator that the first line of a text names; `undefined` if it names none. */
export function namedSeparator(text: string): string | undefined {
  return SEPARATOR_LINE.exec(/[^\r\n]*/.exec(text.replace(/^[\uFEFF\s]+/, ''))?.[0] ?? '')?.[2]
}

const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i
const DECIMAL_COMMA = /^([^.,]*),(\d[^.,]*)$/

/**
 * The records of a table. Blank lines, lines of separators, lines that name the separator (`sep=;`) and comments (`#`)
 * are skipped. Quoted fields may contain line ends. A space as the separator stands for any number of spaces and tabs.
 * @throws TextProblem if quotation marks do not match
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
    const isNaming =
      /s|"/i.test(text[at] ?? '') && SEPARATOR_LINE.test(/[^\r\n]*/.exec(text.slice(at, at + 99))?.[0] ?? '')
    if (text[at] === '#' || isNaming) {
      while (!isLineEnd()) at += 1
    } else {
      let hasMore = true
      for (; !isLineEnd(); skipBlanks()) {
        fields.push(field())
        hasMore = !isLineEnd()
        if (!hasMore) break
        if (separator !== ' ') at += 1
      }
      // A line that ends with a separator has an empty last field.
      if (hasMore && separator !== ' ') fields.push({ text: '', isQuoted: false })
    }
    if (text[at] === '\r' && text[at + 1] === '\n') at += 1
    at += 1
    line += 1
    if (fields.some(({ text }) => text !== '')) yield { line: begin, fields }
  }
}

/** Reads numbers with a decimal point, or a decimal comma unless commas separate fields. Mixing both is an error. */
export class NumberReader {
  readonly #mayBeComma: boolean
  #mark = ''

  constructor(separator: Separator) {
    this.#mayBeComma = separator === ';' || separator === '\t' || separator === '|'
  }

  /** `undefined`: the field is not a finite number, or its decimal mark differs from earlier ones. */
  read({ text, isQuoted }: TableField): number | undefined {
    const isComma = (this.#mayBeComma || isQuoted) && DECIMAL_COMMA.test(text)
    const digits = isComma ? text.replace(',', '.') : text
    if (!NUMBER.test(digits)) return undefined
    const value = Number(digits)
    // Rejects overflow and underflow.
    if (!Number.isFinite(value) || (value === 0 && /[1-9]/.test(digits.replace(/e.*/i, '')))) return undefined
    const mark = isComma ? ',' : digits.includes('.') ? '.' : ''
    if (mark !== '' && this.#mark !== '' && mark !== this.#mark) return undefined
    this.#mark ||= mark
    return value
  }
}

/** Removes empty fields at the end. */
export function filled(fields: readonly TableField[]): readonly TableField[] {
  let count = fields.length
  while (count > 0 && fields[count - 1]?.text === '') count -= 1
  return fields.slice(0, count)
}
