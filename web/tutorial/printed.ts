// SPDX-License-Identifier: GPL-3.0-or-later
// Shows beside a figure the result of the paper's rules as printed, for the figure's current circles.
import type { CircleVoronoiElement } from '../element/index.ts'
import type { CircleVoronoi } from '../lib/index.ts'
import { loadLibrary } from '../lib/wasm/loader.ts'
import { lookAt, pictureOf } from './printed-picture.ts'
import {
  type Comparison,
  compare,
  loadPrintedRules,
  MOST_CIRCLES,
  type PrintedRules,
  type Rule,
  sentenceOf,
} from './printed-rules.ts'

/** The empty comparison, before the first result. */
const NOTHING: Comparison = { found: [], wrong: [], missing: [], leftover: [], borders: 0 }
/** The events after which a figure's viewport may have changed. */
const MOVES = ['pointermove', 'pointerup', 'wheel', 'keydown', 'keyup', 'dblclick'] as const

interface Tools {
  readonly library: CircleVoronoi
  readonly printed: PrintedRules
}

export function followPrinted(page: Document): void {
  let tools: Promise<Tools> | undefined
  const load = () => {
    // A failed download is tried again next time.
    tools ??= loadTools().catch((error) => {
      tools = undefined
      throw error
    })
    return tools
  }
  for (const figure of page.querySelectorAll<HTMLElement>('figure.printed')) void follow(figure, load)
}

async function loadTools(): Promise<Tools> {
  const [library, printed] = await Promise.all([loadLibrary(), loadPrintedRules()])
  return { library, printed }
}

async function follow(around: HTMLElement, load: () => Promise<Tools>): Promise<void> {
  const figure = around.querySelector('circle-voronoi') as CircleVoronoiElement
  const picture = around.querySelector('.picture') as HTMLElement
  const output = around.querySelector('output') as HTMLOutputElement
  const rules = (around.dataset.rules as string).split(' ') as Rule[]
  const svg = around.ownerDocument.createElementNS('http://www.w3.org/2000/svg', 'svg')
  svg.classList.add('printed')
  svg.setAttribute('role', 'img')
  svg.setAttribute('aria-label', (picture.querySelector('img') as HTMLImageElement).alt)

  let comparison = NOTHING
  let isOther = true
  let isAsked = false
  const ask = () => {
    if (isAsked) return
    isAsked = true
    requestAnimationFrame(async () => {
      isAsked = false
      const { circles } = figure
      if (isOther) {
        isOther = false
        const found = await find(circles, rules, load)
        comparison = found.comparison
        output.value = found.sentence
      }
      const size = { width: figure.clientWidth, height: figure.clientHeight }
      const { view } = figure.getState()
      // A figure far out of sight has no size, so it has no viewport.
      if (view?.span === 0) return
      const { viewBox, content } = pictureOf(circles, comparison, lookAt(circles, view, size), size)
      svg.setAttribute('viewBox', viewBox)
      svg.innerHTML = content
      if (!svg.isConnected) picture.replaceChildren(svg)
    })
  }
  await figure.ready
  figure.addEventListener('circleschange', () => {
    isOther = true
    ask()
  })
  for (const name of MOVES) figure.addEventListener(name, ask, { passive: true })
  new ResizeObserver(ask).observe(figure)
}

async function find(circles: Float64Array, rules: readonly Rule[], load: () => Promise<Tools>) {
  if (circles.length > 3 * MOST_CIRCLES)
    return { comparison: NOTHING, sentence: `Here the rules are tried on ${MOST_CIRCLES} circles at most.` }
  try {
    const { library, printed } = await load()
    const comparison = compare(library.compute(circles), printed.run(circles, rules))
    return { comparison, sentence: sentenceOf(comparison) }
  } catch (error) {
    return { comparison: NOTHING, sentence: (error as Error).message }
  }
}
