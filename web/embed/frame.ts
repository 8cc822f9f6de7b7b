// SPDX-License-Identifier: GPL-3.0-or-later
// A page of one figure, with the title and the question of its link. `embed.ts` shows it in a frame, `course.ts` in a
// course.
import type { CircleVoronoiElement } from '../element/circle-voronoi-element.ts'
import type { FrameMessage, FrameRequest } from '../element/frame-types.ts'
import {
  decodeLink,
  encodeLinkAtOnce,
  type LinkFrame,
  type LinkInput,
  type LinkState,
  type LinkView,
} from '../lib/link.ts'
import { frameOf } from '../lib/link-frame.ts'
import type { RegionShape } from '../lib/regions/region-shape.ts'
import { type FrameWords, frameWords } from './words.ts'

/** The circles of a data set, and its region if it has one. */
interface DataSetCircles {
  readonly circles: Float64Array
  readonly domain?: { readonly region: RegionShape | undefined } | undefined
}

export interface FrameOptions {
  /** Loads the data set that a link names. */
  load(dataSet: string): Promise<DataSetCircles>
  /** Called when the height, the circles or the check have changed. */
  tell(message: FrameMessage): void
}

export class Frame {
  readonly #main: HTMLElement
  readonly #figure: CircleVoronoiElement
  readonly #options: FrameOptions
  /** The latest call of `open` or `change`; earlier ones that are still loading are dropped. */
  #turn = 0
  #start: LinkState | undefined
  #texts: LinkFrame = {}
  #isShown = false
  #isChanged = false
  #met: boolean | undefined
  #error: string | undefined
  #height = 0
  /** The view that was told last. */
  #view: LinkView | undefined
  #isWaiting = false
  /** The number of states that are being shown. */
  #showing = 0

  /** `main` is the element `main` of embed.html. */
  constructor(main: HTMLElement, options: FrameOptions) {
    this.#main = main
    this.#options = options
    this.#figure = main.querySelector('circle-voronoi') as CircleVoronoiElement
    this.#figure.addEventListener('circleschange', () => {
      this.#isChanged = true
      this.#tellSoon()
    })
    this.#figure.addEventListener('stepchange', () => this.#tellSoon())
    this.#figure.addEventListener('checkchange', ({ detail }) => {
      this.#met = detail.isMet
      this.#showMet()
      this.#tellSoon()
    })
    // No live region, because the values change with each step of a drag. The figure's description has them, too.
    this.#figure.addEventListener('goalschange', ({ detail }) => {
      this.#part('goals').textContent = detail.text
    })
    this.#part('again').addEventListener('click', () => this.startOver())
    const observer = new ResizeObserver(() => this.#resized())
    observer.observe(main)
    observer.observe(this.#part('texts'))
  }

  /** Opens a link, and shows a sentence if it cannot be shown. */
  async open(link: string): Promise<void> {
    const problem = this.#part('problem')
    await this.#show(async () => {
      const state = await decodeLink(link)
      return { circles: undefined, dataSet: state.circles === undefined ? '' : undefined, ...state }
    })
    problem.textContent = this.#error ?? ''
    problem.hidden = this.#error === undefined
  }

  /**
   * Shows the state of a request. Without circles, a state changes only the parts that it names; without a state,
   * nothing changes.
   */
  async request({ state }: Partial<FrameRequest>): Promise<void> {
    if (state === undefined) return this.#tellSoon()
    // Encoding checks all fields of a state that another page has sent.
    await this.#show(() => decodeLink(typeof state === 'string' ? state.replace(/^.*#/, '') : encodeLinkAtOnce(state)))
  }

  /** Shows circles of an earlier session, as if the reader had edited the circles of the link. */
  restore(circles: Float64Array): void {
    this.#figure.circles = circles
  }

  /** Shows the circles of the link again. */
  async startOver(): Promise<void> {
    const { region = null, ...start } = this.#start ?? {}
    await this.#show(async () => ({ region, ...start }))
    this.#figure.focus()
  }

  async #show(load: () => Promise<LinkInput>): Promise<void> {
    this.#turn += 1
    this.#showing += 1
    const turn = this.#turn
    this.#error = undefined
    const listening = new AbortController()
    try {
      const loaded = await this.#withCircles(await load())
      if (turn !== this.#turn) return
      const { circles, step } = loaded
      const isWhole = circles !== undefined
      // A check must not name circles that do not exist yet.
      if (isWhole || loaded.check !== undefined) this.#figure.check = undefined
      if (isWhole || step !== undefined) this.#figure.controls = step === undefined ? '' : 'player'
      this.#texts = isWhole ? frameOf(loaded) : { ...this.#texts, ...frameOf(loaded) }
      this.#showTexts()
      await this.#figure.setState(loaded)
      if (turn !== this.#turn) return
      const { signal } = listening
      this.#figure.addEventListener('error', ({ detail }) => this.#fail(detail.error), { signal })
      this.#figure.check = this.#texts.check
      if (isWhole) {
        this.#start = loaded as LinkState
        this.#isChanged = false
      }
      this.#isShown = true
    } catch (error) {
      if (turn === this.#turn) this.#fail(error as Error)
    } finally {
      listening.abort()
      this.#showing -= 1
      this.#showTexts()
      await this.#tellSoon()
    }
  }

  #fail({ message }: Error): void {
    this.#error = message
  }

  async #withCircles({ dataSet, ...state }: LinkInput): Promise<LinkInput> {
    if (dataSet === undefined) return state
    const { circles, domain } = await this.#options.load(dataSet)
    return { region: domain?.region, ...state, circles }
  }

  /** Reports the state of the figure once everything is computed. Changes until then are reported together. */
  async #tellSoon(): Promise<void> {
    // The circles of one state and the check of another do not belong together.
    if (this.#isWaiting || this.#showing > 0) return
    this.#isWaiting = true
    if (this.#isShown) await this.#figure.updateComplete
    this.#isWaiting = false
    this.#showTexts()
    if (this.#showing === 0) this.#tell()
  }

  #resized(): void {
    if (this.#isFitted) {
      // The figure learns its new size a moment later.
      setTimeout(() => {
        this.#figure.view = undefined
      })
    }
    // A pending report has the height, too.
    if (!this.#isWaiting && this.#naturalHeight() !== this.#height) this.#tell()
  }

  /** Whether all circles are visible. They then stay visible while the size changes. */
  get #isFitted(): boolean {
    return this.#isShown && this.#view === undefined
  }

  #tell(): void {
    this.#height = this.#naturalHeight()
    const state = this.#isShown ? this.#figure.getState() : undefined
    this.#view = state?.view
    const met = this.#isShown && this.#figure.check !== undefined ? this.#met : undefined
    const answer = state && JSON.stringify({ circles: state.circles, ...(met !== undefined && { check: met }) })
    this.#options.tell({
      type: 'circle-voronoi',
      height: this.#height,
      state,
      met,
      answer: answer ?? '',
      error: this.#error,
    })
  }

  /** The height of everything with a figure of its own aspect ratio. It does not depend on the height of the frame. */
  #naturalHeight(): number {
    this.#main.classList.add('natural')
    const height = Math.ceil(this.#main.getBoundingClientRect().height)
    this.#main.classList.remove('natural')
    return height
  }

  #showTexts(): void {
    const { title = '', question = '', readonly = false, alt = '', lang = '' } = this.#texts
    const words = this.#words
    document.documentElement.lang = lang === '' ? 'en' : lang
    document.title = title === '' ? words.title : title
    const heading = this.#part('title')
    heading.textContent = document.title
    heading.classList.toggle('visually-hidden', title === '')
    this.#part('question').textContent = question
    this.#part('question').hidden = question === ''
    const again = this.#part('again')
    again.textContent = words.startOver
    again.hidden = !this.#isChanged || !this.#isAsked
    this.#part('texts').classList.toggle('visually-hidden', title === '' && question === '' && !this.#isAsked)
    const open = this.#part('open')
    open.textContent = words.open
    // The link to the playground is hidden while the reader has a question to answer.
    open.hidden = this.#isAsked
    if (this.#figure.readonly !== readonly) this.#figure.readonly = readonly
    if (this.#figure.alt !== alt) this.#figure.alt = alt
    if (this.#figure.lang !== lang) this.#figure.lang = lang === '' ? undefined : lang
    this.#showMet()
  }

  #showMet(): void {
    const met = this.#part('met')
    const isMet = this.#met === true
    met.hidden = !this.#isAsked
    met.dataset.met = String(isMet)
    const text = isMet ? this.#words.met : this.#words.unmet
    // Assigning the text announces it again.
    if (met.textContent !== text) met.textContent = text
  }

  get #isAsked(): boolean {
    return this.#texts.check !== undefined
  }

  get #words(): FrameWords {
    return frameWords(this.#texts.lang ?? '')
  }

  #part(id: string): HTMLElement {
    return this.#main.querySelector(`#${id}`) as HTMLElement
  }
}
