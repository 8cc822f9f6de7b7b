// SPDX-License-Identifier: GPL-3.0-or-later
import { html, render } from 'lit/html.js'
import { type Columns, type Guess, guessedColumns, nameOfColumn, type Table } from '../files/columns.ts'
import type { NamedColumns } from '../files/files-protocol.ts'
import { byId } from './by-id.ts'

/** Number of rows in the preview. */
const SHOWN = 5
/** The choice of one radius for all circles in place of a column. */
const SAME = -1

/** Determines the columns of centers and radii, by their names or by a dialog. */
export async function chooseColumns(table: Table, file: string): Promise<NamedColumns | undefined> {
  const { x, y, r, isDiameter, isSure } = guessedColumns(table)
  const isKnown = isSure && x !== undefined && y !== undefined && r !== undefined
  return isKnown ? named(table, { x, y, r }, isDiameter) : ask(table, file)
}

function named(table: Table, { x, y, r }: Columns, isDiameter: boolean): NamedColumns {
  const nameOf = (column: number) => nameOfColumn(table, column)
  const isColumn = typeof r === 'number'
  return { x: nameOf(x), y: nameOf(y), radius: isColumn ? nameOf(r) : r, isDiameter: isColumn && isDiameter }
}

/**
 * Returns the column of radii: by its name, or the first further one with numbers. A table whose centers are known by
 * their names has no other radii.
 */
function likelyRadius({ hasNumbers }: Table, guess: Guess, centers: readonly number[]): number {
  if (typeof guess.r === 'number') return guess.r
  if (guess.x !== undefined && guess.y !== undefined) return SAME
  const first = hasNumbers.findIndex((has, k) => has && !centers.includes(k))
  return first < 0 ? SAME : first
}

/** Resolves to `undefined` if the dialog was canceled. */
function ask(table: Table, file: string): Promise<NamedColumns | undefined> {
  const dialog = byId('columns', HTMLDialogElement)
  const { heading, rows } = table
  const guess = guessedColumns(table)
  let [x, y] = [guess.x ?? 0, guess.y ?? 1]
  let r = likelyRadius(table, guess, [x, y])
  let all = 1
  let { isDiameter } = guess
  const chosen = () => named(table, { x, y, r: r === SAME ? { all } : r }, isDiameter)
  /** The problem of the chosen columns; empty if there is none. */
  const problem = (): string => {
    if (x === y) return 'x and y are the same column.'
    const wrong = [x, y, r].find((column) => column !== SAME && table.hasNumbers[column] === false)
    return wrong === undefined ? '' : `There are no numbers in column ${heading[wrong]}.`
  }

  const select = (label: string, value: number, set: (column: number) => void, more: unknown = undefined) => html`
    <label>${label}
      <select
        aria-label=${label}
        @change=${(event: Event) => {
          set(Number((event.target as HTMLSelectElement).value))
          draw()
        }}
      >
        ${heading.map((name, k) => html`<option value=${k} .selected=${k === value}>${name}</option>`)}
        ${more}
      </select>
    </label>
  `
  const number = (event: Event) => {
    const input = event.target as HTMLInputElement
    if (input.reportValidity()) all = input.valueAsNumber
  }
  const draw = () => {
    const wrong = problem()
    render(
      html`
        <form method="dialog">
          <header>
            <h2 id="columns-title">Which columns are the circles?</h2>
          </header>
          <p class="quiet">${file} has ${rows.length} rows.</p>
          <div class="choices">
            ${select('x', x, (column) => {
              x = column
            })}
            ${select('y', y, (column) => {
              y = column
            })}
            ${select(
              'radius',
              r,
              (column) => {
                r = column
              },
              html`<option value=${SAME} .selected=${r === SAME}>the same for all</option>`,
            )}
            ${
              r === SAME
                ? html`<label>r <input type="number" aria-label="r" min="0" step="any" required .value=${String(all)} @change=${number} /></label>`
                : html`<label><input
                      type="checkbox"
                      .checked=${isDiameter}
                      @change=${(event: Event) => {
                        isDiameter = (event.target as HTMLInputElement).checked
                      }}
                    />diameters</label
                  >`
            }
          </div>
          <div class="preview">
            <table>
              <thead><tr>${heading.map((name, k) => html`<th scope="col" class=${used(k) ? 'used' : ''}>${name}</th>`)}</tr></thead>
              <tbody>
                ${rows
                  .slice(0, SHOWN)
                  .map(
                    (row) =>
                      html`<tr>${heading.map((_, k) => html`<td class=${used(k) ? 'used' : ''}>${row[k] ?? ''}</td>`)}</tr>`,
                  )}
              </tbody>
            </table>
          </div>
          <p class="wrong" aria-live="polite">${wrong}</p>
          <div class="choices">
            <button value="open" class="primary" ?disabled=${wrong !== ''}>Open</button>
            <button value="">Cancel</button>
          </div>
        </form>
      `,
      dialog,
    )
  }
  const used = (column: number) => [x, y, r].includes(column)

  draw()
  dialog.returnValue = ''
  dialog.showModal()
  return new Promise((resolve) => {
    dialog.addEventListener('close', () => resolve(dialog.returnValue === 'open' ? chosen() : undefined), {
      once: true,
    })
  })
}
