// SPDX-License-Identifier: GPL-3.0-or-later
// A diagram that the reader corrupts, drawn with its claimed edges and vertices, and the verdict of the judge.
import type { CircleVoronoiElement } from '../element/index.ts'
import type { CircleVoronoi, Diagram } from '../lib/index.ts'
import { loadLibrary } from '../lib/wasm/loader.ts'
import { claimedLayer, flawOf, type Marked, markedLayer, markedVertex } from './claimed-diagram.ts'
import { CORRUPTIONS } from './corruptions.ts'
import { numberCircles } from './numbers.ts'

/** The part of a diagram that can be corrupted: one circle of a vertex. */
interface Place {
  /** An index into `vertexCircles`. */
  readonly index: number
  readonly name: string
}

const RIGHT = 'This is the right diagram. Choose a change.'
const OWN = 'You changed a vertex.'
const IMPOSSIBLE = 'These circles leave nothing to be changed so. Drag a circle and try again.'

export function letCorrupt(page: Document): void {
  for (const figure of page.querySelectorAll<HTMLElement>('[data-corrupt]')) new CorruptFigure(page, figure)
}

class CorruptFigure {
  readonly #page: Document
  readonly #figure: CircleVoronoiElement
  readonly #choice: HTMLSelectElement
  readonly #about: HTMLParagraphElement
  readonly #table: HTMLTableElement
  readonly #verdict: HTMLOutputElement
  #library: Promise<CircleVoronoi> | undefined
  #diagram: Diagram | undefined
  /** The part that the judge rejects; `undefined` for the right diagram. */
  #flaw: Marked | undefined

  constructor(page: Document, figure: HTMLElement) {
    this.#page = page
    this.#figure = figure.querySelector('circle-voronoi') as CircleVoronoiElement
    this.#choice = page.createElement('select')
    this.#choice.append(
      new Option('Nothing: the right diagram', ''),
      ...CORRUPTIONS.map(({ name }, k) => new Option(name, `${k}`)),
    )
    this.#choice.addEventListener('change', () => void this.#begin(this.#choice.value))
    this.#about = page.createElement('p')
    this.#table = page.createElement('table')
    this.#verdict = page.createElement('output')
    this.#choice.id = `${figure.id}-change`
    const label = Object.assign(page.createElement('label'), { htmlFor: this.#choice.id, textContent: 'Change' })
    const restore = Object.assign(page.createElement('button'), { type: 'button', textContent: 'Make it right again' })
    restore.addEventListener('click', () => void this.#begin())
    const details = page.createElement('details')
    details.append(
      Object.assign(page.createElement('summary'), { textContent: 'Choose the circles of each vertex yourself' }),
      this.#table,
    )
    const box = Object.assign(page.createElement('div'), { className: 'corrupt' })
    box.append(label, ' ', this.#choice, this.#about, this.#verdict, details, restore)
    figure.querySelector('figcaption')?.before(box)
    numberCircles(this.#figure)
    this.#figure.addEventListener('circleschange', () => void this.#begin())
    for (const leave of ['focusout', 'pointerleave']) this.#table.addEventListener(leave, () => this.#mark(undefined))
    void this.#begin()
  }

  /** Shows the correct diagram of the current circles, or a corrupted one. */
  async #begin(choice = ''): Promise<void> {
    this.#choice.value = choice
    try {
      this.#library ??= loadLibrary()
      const library = await this.#library
      await this.#figure.ready
      const right = library.compute(this.#figure.circles)
      const corruption = CORRUPTIONS[choice === '' ? -1 : Number(choice)]
      const wrong = corruption?.make(right, library)
      this.#diagram = wrong ?? right
      this.#about.textContent = corruption === undefined ? RIGHT : wrong === undefined ? IMPOSSIBLE : corruption.about
    } catch (error) {
      this.#library = undefined
      this.#verdict.value = `${(error as Error).message}`
      return
    }
    this.#show(this.#diagram)
    await this.#judge()
  }

  #show(diagram: Diagram): void {
    const circles = Array.from(diagram.circles.subarray(0, diagram.circles.length / 3), (_, i) => i)
    const vertices = Array.from(diagram.vertexCircles.subarray(0, diagram.vertexCircles.length / 3), (_, v) => v)
    const rows = [
      this.#heading(['Vertex', 'touches these circles']),
      ...vertices.map((v) =>
        this.#row(
          `${v}`,
          [0, 1, 2].map((k) => ({ index: 3 * v + k, name: `vertex ${v}, circle ${k + 1}` })),
          circles,
          v,
        ),
      ),
    ]
    this.#table.replaceChildren(...rows)
  }

  #heading(titles: string[]): HTMLTableRowElement {
    const row = this.#page.createElement('tr')
    row.append(
      ...titles.map((textContent, k) =>
        Object.assign(this.#page.createElement('th'), { textContent, scope: 'col', colSpan: k === 0 ? 1 : 3 }),
      ),
    )
    return row
  }

  #row(title: string, places: Place[], choices: number[], vertex: number): HTMLTableRowElement {
    const row = this.#page.createElement('tr')
    for (const come of ['focusin', 'pointerenter']) row.addEventListener(come, () => this.#mark(vertex))
    row.append(Object.assign(this.#page.createElement('th'), { textContent: title, scope: 'row' }))
    for (const place of places) {
      const select = this.#page.createElement('select')
      select.setAttribute('aria-label', place.name)
      const { vertexCircles } = this.#diagram as Diagram
      for (const choice of choices) {
        const isNow = choice === vertexCircles[place.index]
        select.append(new Option(`${choice}`, `${choice}`, isNow, isNow))
      }
      select.addEventListener('change', () => {
        vertexCircles[place.index] = Number(select.value)
        this.#about.textContent = OWN
        void this.#judge(vertex)
      })
      const cell = this.#page.createElement('td')
      cell.append(select)
      row.append(cell)
    }
    return row
  }

  /** Draws the claimed diagram, and marks a vertex of the table or, without one, the flaw. */
  #mark(vertex: number | undefined): void {
    const diagram = this.#diagram as Diagram
    const isRight = this.#flaw === undefined
    const marked = vertex === undefined ? this.#flaw : markedVertex(diagram, vertex)
    const data = [
      ...(isRight ? [] : [claimedLayer(diagram)]),
      ...(marked === undefined ? [] : [markedLayer(diagram, marked)]),
    ]
    const { layers } = this.#figure
    this.#figure.layers = { ...layers, edges: isRight, vertices: isRight, cells: isRight ? 'auto' : 'none', data }
  }

  /** Shows the verdict of the judge. `vertex` is a vertex of the table that stays marked. */
  async #judge(vertex?: number): Promise<void> {
    const library = await (this.#library as Promise<CircleVoronoi>)
    const diagram = this.#diagram as Diagram
    try {
      const certificate = library.certify(diagram)
      this.#flaw = certificate.certified ? undefined : flawOf(diagram, certificate)
      this.#verdict.value = certificate.certified
        ? 'The judge: this diagram is right.'
        : `The judge: no. ${certificate.message}`
    } catch (error) {
      this.#flaw = { circles: [], vertices: [], edges: [] }
      this.#verdict.value = `The judge: no. ${(error as Error).message}`
    }
    this.#mark(vertex)
  }
}
