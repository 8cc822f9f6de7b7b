// SPDX-License-Identifier: GPL-3.0-or-later
import { html, render } from 'lit/html.js'
import { type Columns, circlesFrom, guessedColumns, type Rows } from '../files/columns.ts'
import { byId } from './by-id.ts'

/** Number of rows in the preview. */
const SHOWN = 5
/** The choice of one radius for all circles in place of a column. */
const SAME = -1

export interface Chosen {
  readonly columns: Columns
  readonly isDiameter: boolean
}

/** Determines the columns of centers and radii, by their names or by a dialog. */
export async function chooseColumns(rows: Rows, file: string): Promise<Chosen | undefined> {
  const guess = guessedColumns(rows)
  const { x, y, r, name, isDiameter = false } = guess
  const isKnown = x !== undefined && y !== undefined && r !== undefined
  return isKnown ? { columns: { x, y, r, name }, isDiameter } : ask(rows, file)
}

/** Resolves to `undefined` if the dialog was canceled. */
function ask(rows: Rows, file: string): Promise<Chosen | undefined> {
  const dialog = byId('columns', HTMLDialogElement)
  const guess = guessedColumns(rows)
  let [x, y, r] = [guess.x ?? 0, guess.y ?? 1, typeof guess.r === 'number' ? guess.r : Math.min(2, rows.heading.length)]
  if (r === rows.heading.length) r = SAME
  let all = 1
  let isDiameter = guess.isDiameter === true
  const chosen = (): Chosen => ({
    columns: { x, y, r: r === SAME ? { all } : r, name: guess.name },
    isDiameter: isDiameter && r !== SAME,
  })
  /** The problem of the chosen columns; empty if there is none. */
  const problem = (): string => {
    if (x === y) return 'x and y are the same column.'
    try {
      const { columns, isDiameter } = chosen()
      circlesFrom(rows, columns, isDiameter, file)
      return ''
    } catch (error) {
      return (error as Error).message
    }
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
        ${rows.heading.map((heading, k) => html`<option value=${k} ?selected=${k === value}>${heading}</option>`)}
        ${more}
      </select>
    </label>
  `
  const number = (event: Event) => {
    const input = event.target as HTMLInputElement
    if (input.reportValidity()) all = input.valueAsNumber
    draw()
  }
  const draw = () => {
    const wrong = problem()
    render(
      html`
        <form method="dialog">
          <header>
            <h2 id="columns-title">Which columns are the circles?</h2>
          </header>
          <p class="quiet">${file} has ${rows.rows.length} rows.</p>
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
              html`<option value=${SAME} ?selected=${r === SAME}>the same for all</option>`,
            )}
            ${
              r === SAME
                ? html`<label>r <input type="number" aria-label="r" min="0" step="any" required .value=${String(all)} @change=${number} /></label>`
                : html`<label><input
                      type="checkbox"
                      .checked=${isDiameter}
                      @change=${(event: Event) => {
                        isDiameter = (event.target as HTMLInputElement).checked
                        draw()
                      }}
                    />diameters</label
                  >`
            }
          </div>
          <div class="preview">
            <table>
              <thead><tr>${rows.heading.map((heading, k) => html`<th scope="col" class=${used(k) ? 'used' : ''}>${heading}</th>`)}</tr></thead>
              <tbody>
                ${rows.rows
                  .slice(0, SHOWN)
                  .map(
                    (row) =>
                      html`<tr>${rows.heading.map((_, k) => html`<td class=${used(k) ? 'used' : ''}>${row[k] ?? ''}</td>`)}</tr>`,
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
