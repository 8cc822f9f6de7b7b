// SPDX-License-Identifier: GPL-3.0-or-later
import { html, nothing, render, svg } from 'lit/html.js'
import { at } from '../../lib/base/diagram-data.ts'
import { NewestQueue } from '../../lib/base/newest-queue.ts'
import type { Float64s } from '../../lib/index.ts'
import { short } from '../../view/short.ts'
import { wholeNumber } from '../../view/whole-number.ts'
import {
  type Columns,
  circlesOfTable,
  guessedColumns,
  nameOfColumn,
  type RadiusKind,
  SAME,
  scaleOf,
  type Table,
} from '../files/columns.ts'
import type { NamedColumns, Preview } from '../files/files-protocol.ts'
import { previewFrame } from '../files/preview-frame.ts'
import { byId } from './by-id.ts'

/** Number of rows in the preview. */
const SHOWN = 4
/** More circles than this are drawn as a sample. */
const MOST_DRAWN = 5000
const KINDS: readonly (readonly [kind: RadiusKind, label: string])[] = [
  ['radius', 'radius'],
  ['diameter', 'diameter: halved'],
  ['root', 'area or number: square root'],
]

/** Longer numbers are rounded in the preview. */
const MOST_LETTERS = 9

const NONE = new Float64Array()

/** Asks which columns are centers and radii. Resolves to `undefined` if the dialog was canceled. */
export function chooseColumns(
  table: Table,
  file: string,
  preview: (circles: Float64s) => Promise<Preview>,
): Promise<NamedColumns | undefined> {
  const dialog = byId('columns', HTMLDialogElement)
  const { heading, rows } = table
  let chosen = guessedColumns(table)
  /** The preview of the circles; `undefined` while it is computed. */
  let seen: Preview | Error | undefined
  let circles: Float64s = NONE

  /** The problem of the chosen columns; empty if there is none. */
  const problem = (): string => {
    const { x, y, r } = chosen
    if (x === y) return 'x and y are the same column.'
    const columns = typeof r === 'number' ? [x, y, r] : [x, y]
    const wrong = columns.find((column) => table.hasNumbers[column] === false)
    return wrong === undefined ? '' : `There are no numbers in column ${heading[wrong]}.`
  }

  const queue = new NewestQueue<Float64s, Preview>(preview)
  let turn = 0
  const change = (changed: Partial<Columns>) => {
    const before = chosen
    chosen = { ...before, ...changed }
    const isCenter = changed.x !== undefined || changed.y !== undefined
    // A column that becomes a coordinate is no radius any more.
    if (isCenter && (chosen.r === chosen.x || chosen.r === chosen.y)) chosen = { ...chosen, r: SAME }
    if (isCenter || changed.r !== undefined) chosen = { ...chosen, ...scaleOf(table, chosen) }
    show()
  }
  const show = async () => {
    turn += 1
    const now = turn
    circles = problem() === '' ? circlesOfTable(table, chosen) : NONE
    seen = undefined
    draw()
    if (circles.length === 0) return
    const next = await queue.add(circles.slice(), 'preview').catch((error: Error) => error)
    if (now !== turn || !dialog.open) return
    seen = next
    draw()
  }

  /** Returns a sentence about hidden circles and invalid rows. */
  const summary = (): string => {
    if (seen instanceof Error) return seen.message
    const count = circles.length / 3
    const left = rows.length - count
    const wrong = left === 1 ? '1 row is not a circle' : `${wholeNumber(left)} rows are not circles`
    const rest = left === 0 || count === 0 ? '' : ` ${wrong}.`
    if (seen === undefined) return rest.trim()
    const { length } = seen.hidden
    if (length === 0) return `No circle is hidden.${rest}`
    const hidden = length === 1 ? '1 circle is' : `${wholeNumber(length)} of ${wholeNumber(count)} circles are`
    return `${hidden} hidden inside ${length === 1 ? 'another' : 'others'}, without a cell.${rest}`
  }

  const select = (label: string, value: Columns['r'], set: (column: number) => void, more: unknown = undefined) => html`
    <label>${label}
      <select aria-label=${label} @change=${(event: Event) => set(Number((event.target as HTMLSelectElement).value))}>
        ${heading.map((name, k) => html`<option value=${k} .selected=${k === value}>${name}</option>`)}
        ${more}
      </select>
    </label>
  `
  const number = (label: string, value: number, set: (value: number) => void, least: 'min' | 'positive') => html`
    <label>${label}
      <input
        type="number"
        aria-label=${label}
        min=${least === 'min' ? '0' : String(Number.MIN_VALUE)}
        step="any"
        required
        .value=${String(value)}
        @input=${({ target }: Event) => {
          const input = target as HTMLInputElement
          if (input.checkValidity()) set(input.valueAsNumber)
        }}
        @change=${({ target }: Event) => (target as HTMLInputElement).reportValidity()}
      />
    </label>
  `
  const radius = () => {
    const { r } = chosen
    return typeof r === 'number' ? scale() : number('r', r.all, (all) => change({ r: { all } }), 'min')
  }
  const scale = () => html`
    <label>read as
      <select
        aria-label="read as"
        @change=${({ target }: Event) =>
          change(scaleOf(table, chosen, (target as HTMLSelectElement).value as RadiusKind))}
      >
        ${KINDS.map(([kind, label]) => html`<option value=${kind} .selected=${kind === chosen.kind}>${label}</option>`)}
      </select>
    </label>
    ${number('factor', chosen.factor, (factor) => change({ factor }), 'positive')}
  `
  const roleOf = (column: number) =>
    ['x', 'y', 'r'].filter((_, k) => [chosen.x, chosen.y, chosen.r][k] === column).join()

  const draw = () => {
    const wrong = problem()
    render(
      html`
        <form method="dialog">
          <header>
            <h2 id="columns-title">Which columns are the circles?</h2>
          </header>
          <p class="quiet">${file}: ${rows.length === 1 ? '1 row' : `${wholeNumber(rows.length)} rows`}</p>
          <div class="chosen">
            <div class="roles">
              ${select('x', chosen.x, (x) => change({ x }))} ${select('y', chosen.y, (y) => change({ y }))}
              ${select('radius', chosen.r, (r) => change({ r: r < 0 ? SAME : r }), html`<option value="-1" .selected=${typeof chosen.r !== 'number'}>the same for all</option>`)}
              ${radius()}
            </div>
            ${pictureOf(circles, seen)}
          </div>
          <p class=${wrong === '' ? 'quiet told' : 'wrong told'} aria-live="polite">${wrong || summary()}</p>
          <div class="preview">
            <table>
              <thead>
                <tr>
                  ${heading.map((name, k) => {
                    const role = roleOf(k)
                    return html`<th scope="col" class=${role && 'used'}>${name}${role === '' ? nothing : html`<span class="role" aria-hidden="true">${role}</span>`}</th>`
                  })}
                </tr>
              </thead>
              <tbody>
                ${rows
                  .slice(0, SHOWN)
                  .map(
                    (row) =>
                      html`<tr>${heading.map((_, k) => html`<td class=${roleOf(k) && 'used'}>${rounded(row[k] ?? '')}</td>`)}</tr>`,
                  )}
              </tbody>
            </table>
          </div>
          <div class="choices end">
            <button value="open" class="primary" autofocus ?disabled=${wrong !== ''}>Open</button>
            <button value="">Cancel</button>
          </div>
        </form>
      `,
      dialog,
    )
  }

  show()
  dialog.returnValue = ''
  dialog.showModal()
  return new Promise((resolve) => {
    const close = () => {
      // A preview that arrives later is not one of the next table.
      turn += 1
      // The next table starts with new controls.
      render(nothing, dialog)
      resolve(dialog.returnValue === 'open' ? named(table, chosen) : undefined)
    }
    dialog.addEventListener('close', close, { once: true })
  })
}

function named(table: Table, { x, y, r, kind, factor }: Columns): NamedColumns {
  const nameOf = (column: number) => nameOfColumn(table, column)
  return { x: nameOf(x), y: nameOf(y), radius: typeof r === 'number' ? nameOf(r) : r, kind, factor }
}

/** Rounds a number with many digits, so that several columns fit. */
function rounded(text: string): string {
  return /^-?\d+\.\d+$/.test(text) && text.length > MOST_LETTERS ? short(Number(text)) : text
}

/** The circles and their cells. Hidden circles stand out. */
function pictureOf(circles: Float64s, seen: Preview | Error | undefined) {
  const { shown, half } = previewFrame(circles)
  const count = circles.length / 3
  const hidden = new Set(seen === undefined || seen instanceof Error ? [] : seen.hidden)
  const step = Math.ceil(count / MOST_DRAWN)
  let [discs, hiddenDiscs] = ['', '']
  for (let i = 0; i < count; i += step) {
    const [x, y, r] = [at(shown, 3 * i), -at(shown, 3 * i + 1), at(shown, 3 * i + 2)].map((value) => value.toFixed(2))
    const disc = `M${x} ${y}h0M${x} ${y}m-${r} 0a${r} ${r} 0 1 0 ${2 * Number(r)} 0a${r} ${r} 0 1 0 -${2 * Number(r)} 0`
    if (hidden.has(i)) hiddenDiscs += disc
    else discs += disc
  }
  const edges = seen === undefined || seen instanceof Error ? '' : seen.edges
  return html`<svg class="picture" viewBox="${-half} ${-half} ${2 * half} ${2 * half}" role="img" aria-label="Preview of the circles">
    ${svg`<path class="edges" transform="scale(1 -1)" d=${edges} /><path class="discs" d=${discs} /><path class="discs hidden" d=${hiddenDiscs} />`}
  </svg>`
}
