// SPDX-License-Identifier: GPL-3.0-or-later
import { html, nothing, render, svg, type TemplateResult } from 'lit/html.js'
import { Diagram } from '../lib/diagram/diagram.ts'
import type { Circle } from '../lib/index.ts'
import { Trace, type TraceOptions, type TraceState } from '../lib/wasm/trace.ts'
import { ASK, BACK, DOT, FORTH, NEXT, PAUSE, PLAY, PREVIOUS } from '../view/icons.ts'
import type { Traced } from '../view/protocol.ts'
import { computedColors } from '../view/style.ts'
import type { View } from '../view/view.ts'
import { type RingMark, ringOf, testedAt, turnTo, waitingCount, waitingDiscs } from './discs.ts'
import { icon } from './icon.ts'
import { Playback } from './playback.ts'
import css from './player.css?inline'
import { type Question, questionAfter } from './prediction.ts'
import { PROGRAMS, type Program } from './program.ts'
import { numberOf, sentenceOf } from './sentences.ts'
import { type Colors, circlesAt, overlayOf, PLAYER_COLORS } from './step-overlay.ts'
import { concerns, kindOf, nextStep, programOf, type Step, stepsOf } from './steps.ts'
import { drawTimeline } from './timeline.ts'
import { ENGLISH_PLAYER, type Goal, type PlayerWords, type PseudocodeLine } from './words.ts'

/** The step to show. */
export interface PlayerPlace {
  /** The number of the step, which is clamped to the existing ones; `undefined` if the player is about to close. */
  readonly step: number | undefined
  /** The program line of the step, while its number in a new trace is unknown. */
  readonly stage?: string | undefined
}

export interface PlayerOptions {
  /** The view that shows the circles. Its diagram is hidden until the last step; the player draws an overlay on it. */
  readonly view: View
  /** The trace to play: the touching disc method, flips (`method: 'auto'`), or `edits`. */
  readonly options: TraceOptions
  /** Returns the current step. The player keeps none of its own. */
  place(): PlayerPlace
  /** Changes the current step. `stage` is the stage of `PlayerPlace`. */
  go(step: number, stage?: PseudocodeLine): void
  /** Called with each step shown and the number of steps. */
  onstep(step: number, steps: number): void
  /** Returns the player's texts, at each redraw. Default: English. */
  readonly words?: (() => PlayerWords | undefined) | undefined
}

export interface Player {
  /**
   * Resolves once there is a trace to play; rejects if the circles or the options are refused. Edits replace the
   * promise.
   */
  readonly ready: Promise<void>
  /** The number of steps; 0 while no trace is loaded. */
  readonly steps: number
  /** Starts playback, from the beginning if the last step is shown. */
  play(): void
  pause(): void
  /** Shows the current step. */
  follow(): void
  /** Redraws the player after a change that it cannot observe, such as another language. */
  redraw(): void
  /** Removes the player and shows the diagram again. */
  dispose(): void
}

/** Steps per second. */
const SPEEDS = [0.5, 1, 3, 10, 30]
const MOST_WAITING = 6
/** Space kept visible around the current line, in pixels. */
const REVEALED = 24
/** Delay after the last edit before the trace is loaded again, in milliseconds. */
const LOADING_DELAY = 150

let sheet: CSSStyleSheet | undefined

/** Mounts the player: controls and explanations in `container`, the overlay in the view. */
export function mountPlayer(container: HTMLElement, options: PlayerOptions): Player {
  return new MethodPlayer(container, options)
}

class MethodPlayer implements Player {
  readonly #root: HTMLElement
  readonly #view: View
  readonly #options: TraceOptions
  readonly #placeNow: () => PlayerPlace
  readonly #setPlace: (step: number, stage?: PseudocodeLine) => void
  readonly #onstep: (step: number, steps: number) => void
  readonly #wordsNow: () => PlayerWords | undefined
  readonly #watching = new AbortController()
  readonly #unlisten: readonly (() => void)[]
  readonly #resized: ResizeObserver
  /** Read from the style sheet on first use. */
  #colors: Colors | undefined
  /** Aborted when the trace that is loading is outdated. */
  #loading = new AbortController()
  /** Whether the trace of the current circles is loading. */
  #isLoading = false
  ready: Promise<void>

  #given: Pick<Traced, 'circles' | 'ids'> | undefined
  #trace: Trace | undefined
  #problem = ''
  #steps: readonly Step[] = []
  #program: Program = 'touching'
  /** The step in the picture. While a trace is loading, it is a step of the previous trace. */
  #shown = 0
  readonly #playback = new Playback(() => this.#next())
  #isPlaying = false
  #goal: Goal = 'stage'
  #selected: number | undefined
  readonly #breakpoints = new Set<number>()
  #asks = false
  #answer: { readonly step: number; readonly question: Question; readonly chosen: number } | undefined
  #score = { right: 0, asked: 0 }

  constructor(container: HTMLElement, { view, options, place, go, onstep, words }: PlayerOptions) {
    this.#root = container
    this.#view = view
    this.#options = options
    this.#placeNow = place
    this.#setPlace = go
    this.#onstep = onstep
    this.#wordsNow = words ?? (() => undefined)
    container.classList.add('cv-player')
    // The timeline runs from left to right in every language.
    container.dir = 'ltr'
    adopt(container.getRootNode() as Document | ShadowRoot)
    this.#unlisten = [
      view.on('changed', () => this.#playAnew()),
      view.on('style', () => {
        this.#colors = undefined
        this.#draw()
      }),
      view.on('marked', ({ selected }) => {
        if (selected?.id === this.#selected) return
        this.#selected = selected?.id
        this.#draw()
      }),
    ]
    container.addEventListener('keydown', (event) => this.#key(event), { signal: this.#watching.signal })
    this.#resized = new ResizeObserver(() => this.#drawTimeline())
    this.#resized.observe(container)
    this.#draw()
    this.ready = this.#load(0)
  }

  get steps(): number {
    return this.#steps.length
  }

  play(): void {
    if ((this.#steps.length === 0 && !this.#isLoading) || this.#isPlaying) return
    this.#isPlaying = true
    if (!this.#isLoading) this.#start()
    this.#draw()
  }

  pause(): void {
    this.#playback.stop()
    this.#isPlaying = false
    this.#draw()
  }

  follow(): void {
    const { step } = this.#placeNow()
    // A trace that is loading will be shown at the step that is current by then.
    if (step === undefined || this.#isLoading || this.#steps.length === 0) return
    const next = this.#nearest(step)
    if (next !== step) this.#setPlace(next)
    if (next !== this.#shown) this.#show(next)
  }

  redraw(): void {
    this.#draw()
  }

  dispose(): void {
    this.#isPlaying = false
    this.#playback.stop()
    this.#loading.abort()
    this.#watching.abort()
    for (const end of this.#unlisten) end()
    this.#resized.disconnect()
    this.#view.hasDiagram = true
    this.#view.overlays = []
    render(nothing, this.#root)
    this.#root.classList.remove('cv-player')
  }

  /** Plays the changed circles from the same stage. Steps within a stage have no counterpart after an edit. */
  #playAnew(): void {
    const { step } = this.#placeNow()
    if (!this.#isLoading && step !== undefined && this.#steps.length > 0) {
      const shown = this.#steps[this.#shown] as Step
      if (kindOf(shown) === 'stage') this.#setPlace(step, shown.line)
      else this.#setPlace(0)
    }
    this.pause()
    this.ready = this.#load(LOADING_DELAY)
  }

  /** Loads the trace once `rest` milliseconds pass without another request. The old explanation stays until then. */
  #load(rest: number): Promise<void> {
    this.#loading.abort()
    this.#loading = new AbortController()
    this.#isLoading = true
    this.#view.overlays = []
    const loaded = this.#loaded(this.#loading.signal, rest)
    // Callers that need the reason await `ready`; other callers must not cause an unhandled rejection.
    loaded.catch(() => {})
    return loaded
  }

  async #loaded(signal: AbortSignal, rest: number): Promise<void> {
    // A player that is about to close has no step.
    let isWanted = false
    try {
      if (rest > 0) await new Promise((resolve) => setTimeout(resolve, rest))
      if (signal.aborted) return
      const traced = await this.#view.scene.ask('trace', [this.#options], signal)
      if (signal.aborted) return
      if (traced === undefined) throw new Error(this.#words.notRun)
      const trace = new Trace(new Diagram(traced.diagram), traced.events)
      this.#given = traced
      this.#trace = trace
      this.#steps = stepsOf(trace)
      this.#program = programOf(trace)
      this.#problem = ''
      this.#breakpoints.clear()
      this.#answer = undefined
      this.#score = { right: 0, asked: 0 }
      this.#isLoading = false
      const { step, stage } = this.#placeNow()
      const wanted = stage === undefined ? step : this.#steps.findIndex(({ line }) => line === stage)
      this.#shown = this.#nearest(wanted ?? 0)
      isWanted = step !== undefined
      if (isWanted) this.#setPlace(this.#shown)
      this.#showsResult(this.#shown === this.#steps.length - 1)
      if (this.#isPlaying) this.#start()
    } catch (error) {
      if (signal.aborted) return
      this.#trace = undefined
      this.#steps = []
      this.#isLoading = false
      this.#isPlaying = false
      this.#showsResult(true)
      this.#problem = this.#words.localized?.(error as Error) ?? (error as Error).message
      throw error
    } finally {
      if (!signal.aborted) this.#draw()
    }
    if (isWanted) this.#onstep(this.#shown, this.#steps.length)
  }

  /** Clamps a number to the existing steps. */
  #nearest(step: number): number {
    return Math.min(Math.max(Math.round(step) || 0, 0), this.#steps.length - 1)
  }

  /** Shows the diagram at the last step only, or if there is no trace. */
  #showsResult(isShown: boolean): void {
    this.#view.hasDiagram = isShown
  }

  #start(): void {
    if (this.#at === this.#steps.length - 1) this.#go(0)
    this.#playback.start()
  }

  /** The current step. */
  get #at(): number {
    return this.#nearest(this.#placeNow().step ?? 0)
  }

  /** Changes the current step and shows it. */
  #go(step: number): void {
    // A player that is about to close shows no other step.
    if (this.#placeNow().step === undefined || this.#steps.length === 0) return
    this.#setPlace(this.#nearest(step))
    this.follow()
  }

  #show(step: number): void {
    this.#showsResult(step === this.#steps.length - 1)
    this.#shown = step
    // The feedback on an answer stays while the next step is shown.
    if (this.#answer !== undefined && step !== this.#answer.step + 1) this.#answer = undefined
    this.#draw()
    this.#onstep(step, this.#steps.length)
  }

  /** Shows the next step during playback. Returns whether to continue. */
  #next(): boolean {
    // The step may have changed since the last frame.
    this.follow()
    const isAsked = this.#question() !== undefined
    if (!isAsked) this.#go(this.#at + 1)
    const isStop = isAsked || this.#at === this.#steps.length - 1 || this.#breakpoints.has(this.#at)
    if (isStop) this.pause()
    return this.#isPlaying
  }

  /** The quiz question before the next step. */
  #question(): Question | undefined {
    const { trace, steps, step } = this.#now()
    if (!this.#asks || trace === undefined) return undefined
    return questionAfter(trace, steps, step, this.#words)
  }

  #now() {
    return { trace: this.#trace, steps: this.#steps, step: this.#shown }
  }

  #reply(question: Question, chosen: number): void {
    this.#answer = { step: this.#shown, question, chosen }
    this.#score = {
      right: this.#score.right + (chosen === question.right ? 1 : 0),
      asked: this.#score.asked + 1,
    }
    this.#go(this.#shown + 1)
    // The button that had the focus has been removed.
    this.#root.querySelector<HTMLElement>('[data-forth]')?.focus()
  }

  #jump(direction: 1 | -1): void {
    const target = this.#jumpTarget(direction)
    if (target === undefined) return
    this.pause()
    this.#go(target)
  }

  #jumpTarget(direction: 1 | -1): number | undefined {
    const { trace, steps, step } = this.#now()
    if (trace === undefined) return undefined
    const goal = this.#goal
    const selected = this.#selected
    return nextStep(steps, step, direction, (item, k) => {
      if (goal === 'breakpoint') return this.#breakpoints.has(k)
      if (goal === 'selected') return selected !== undefined && concerns(trace, steps, k, selected)
      return kindOf(item) === goal
    })
  }

  #key(event: KeyboardEvent): void {
    const target = event.target as HTMLElement
    if (event.altKey || event.ctrlKey || event.metaKey) return
    // Buttons and lists handle these keys themselves.
    const isOwn =
      event.key === ' ' ? target.closest('button, select, summary') !== null : target.closest('select') !== null
    if (isOwn) {
      event.stopPropagation()
      return
    }
    const last = this.#steps.length - 1
    const moves: Readonly<Record<string, () => void>> = {
      ' ': () => (this.#isPlaying ? this.pause() : this.play()),
      ArrowRight: () => this.#user(this.#at + 1),
      ArrowLeft: () => this.#user(this.#at - 1),
      Home: () => this.#user(0),
      End: () => this.#user(last),
      PageDown: () => this.#jump(1),
      PageUp: () => this.#jump(-1),
    }
    const move = moves[event.key]
    if (move === undefined) return
    // The surrounding page may use the same keys, as slides do.
    event.preventDefault()
    event.stopPropagation()
    move()
  }

  /** Shows a step at the reader's request, which ends playback. */
  #user(step: number): void {
    if (this.#isPlaying) this.pause()
    this.#go(step)
  }

  #colorsNow(): Colors {
    this.#colors ??= computedColors(this.#root, PLAYER_COLORS)
    return this.#colors
  }

  #drawTimeline(): void {
    const canvas = this.#root.querySelector('canvas')
    if (canvas !== null && this.#steps.length > 0) {
      drawTimeline(canvas, this.#steps, this.#shown, this.#breakpoints, this.#colorsNow())
    }
  }

  get #words(): PlayerWords {
    return this.#wordsNow() ?? ENGLISH_PLAYER
  }

  #draw(): void {
    this.#root.lang = this.#words.lang
    const focused = this.#root.querySelector(':focus')
    this.#drawParts()
    // Focus would fall to the body when its button is disabled or removed.
    const isLost = focused !== null && (!focused.isConnected || focused.matches(':disabled'))
    if (isLost) this.#root.querySelector('input')?.focus()
  }

  #drawParts(): void {
    const { trace, steps, step } = this.#now()
    if (trace === undefined) {
      this.#view.overlays = []
      const text = this.#problem || this.#words.running
      render(html`<p class="sentence" role="status">${text}</p>`, this.#root)
      return
    }
    const { circles: given, ids } = this.#given as Traced
    const current = steps[step] as Step
    const state = trace.at(current.end)
    const circles = circlesAt(trace, given, state, ids)
    const circleOf = (id: number) => circles.get(id)
    const tested = testedAt(trace, current, state, circleOf)
    render(this.#page(trace, current, state, tested, circleOf), this.#root)
    this.#drawTimeline()
    this.#reveal()
    // The overlay is empty at the last step, and while the trace of changed circles is loading.
    const isNothing = step === steps.length - 1 || this.#isLoading
    this.#view.overlays = isNothing ? [] : overlayOf(trace, current, state, tested, circles, this.#colorsNow())
  }

  /** Scrolls the current line, or the question below a head that scrolls, into the visible part of the player. */
  #reveal(): void {
    const root = this.#root
    const head = root.querySelector('.head') as HTMLElement
    // If the head is not sticky, scrolling to the line would move its buttons out of view.
    const isSticky = getComputedStyle(head).position === 'sticky'
    const shown = root.querySelector(isSticky ? '[aria-current]' : '.question')
    if (shown === null || root.scrollHeight <= root.clientHeight || shown.getClientRects().length === 0) return
    const [{ top, bottom }, around] = [shown.getBoundingClientRect(), root.getBoundingClientRect()]
    const above = isSticky ? head.getBoundingClientRect().bottom - top : 0
    const below = bottom - around.bottom
    if (above > 0) root.scrollTop -= above + REVEALED
    // The head fills the room above a question.
    else if (below > 0 || !isSticky) root.scrollTop += below + REVEALED
  }

  #page(
    trace: Trace,
    current: Step,
    state: TraceState,
    tested: readonly number[],
    circleOf: (id: number) => Circle | undefined,
  ): TemplateResult {
    const steps = this.#steps
    const step = this.#shown
    const last = steps.length - 1
    const isPlaying = this.#isPlaying
    const words = this.#words
    const sentence = sentenceOf(trace, current, tested, words)
    return html`
      <div class="head">
      <div class="timeline">
        <canvas aria-hidden="true"></canvas>
        <input
          type="range"
          aria-label=${words.stepLabel}
          aria-valuetext=${words.stepOf(step, last)}
          min="0"
          max=${last}
          .value=${String(step)}
          @input=${(event: Event) => this.#user(Number((event.target as HTMLInputElement).value))}
        />
      </div>
      <div class="row">
        ${this.#button(words.back, icon(BACK, true), () => this.#user(step - 1), step === 0)}
        ${this.#button(isPlaying ? words.pause : words.play, isPlaying ? icon(PAUSE) : icon(PLAY, true), () => (isPlaying ? this.pause() : this.play()))}
        <button
          type="button"
          data-forth
          aria-label=${words.forth}
          title=${words.forth}
          ?disabled=${step === last}
          @click=${() => this.#user(step + 1)}
        >
          ${icon(FORTH, true)}
        </button>
        <select aria-label=${words.speed} @change=${(event: Event) => this.#setSpeed(Number((event.target as HTMLSelectElement).value))}>
          ${SPEEDS.map((speed) => html`<option value=${speed} ?selected=${speed === this.#playback.speed}>${speed} / s</option>`)}
        </select>
        <span class="where">${step}<span class="of"> / ${last}</span></span>
        <span class="jump">
        ${this.#toggle(words.ask, icon(ASK), this.#asks, () => {
          this.#asks = !this.#asks
        })}
        ${this.#toggle(words.breakHere, icon(DOT, true), this.#breakpoints.has(step), () => {
          if (!this.#breakpoints.delete(step)) this.#breakpoints.add(step)
        })}
        ${this.#button(words.previous, icon(PREVIOUS), () => this.#jump(-1), this.#jumpTarget(-1) === undefined)}
        <select
          aria-label=${words.goal}
          @change=${(event: Event) => {
            this.#goal = (event.target as HTMLSelectElement).value as Goal
            this.#draw()
          }}
        >
          ${Object.entries(words.goals).map(([goal, text]) => html`<option value=${goal} ?selected=${goal === this.#goal}>${text}</option>`)}
        </select>
        ${this.#button(words.next, icon(NEXT), () => this.#jump(1), this.#jumpTarget(1) === undefined)}
        </span>
      </div>
      <p class="sentence" aria-live=${isPlaying ? 'off' : 'polite'}>${sentence}</p>
      ${this.#questionPart()}
      </div>
      <div class="parts">
        <details class="code" open>
          <summary>${words.howItWorks}</summary>
          ${this.#code(current)}
        </details>
        ${this.#program === 'touching' ? this.#queuePart(trace, current, state) : nothing}
        ${this.#program === 'touching' ? this.#ringPart(trace, current, state, circleOf) : nothing}
      </div>
    `
  }

  #button(label: string, picture: TemplateResult, act: () => void, isDisabled = false): TemplateResult {
    return html`<button type="button" aria-label=${label} title=${label} ?disabled=${isDisabled} @click=${act}>${picture}</button>`
  }

  #toggle(label: string, picture: TemplateResult, isOn: boolean, act: () => void): TemplateResult {
    const change = () => {
      act()
      this.#draw()
    }
    return html`<button type="button" aria-label=${label} title=${label} aria-pressed=${isOn} @click=${change}>${picture}</button>`
  }

  #setSpeed(speed: number): void {
    this.#playback.speed = speed
  }

  #questionPart(): TemplateResult | typeof nothing {
    const words = this.#words
    const answered = this.#answer
    if (answered !== undefined && answered.step + 1 === this.#shown) {
      const { question, chosen } = answered
      const isRight = chosen === question.right
      const text = isRight ? words.right : words.wrong(question.answers[question.right] as string)
      return html`<div class="question" role="status">
        <p>${text} ${words.score(this.#score.right, this.#score.asked)}</p>
      </div>`
    }
    const question = this.#question()
    if (question === undefined) return nothing
    return html`<div class="question" role="group" aria-label=${words.whatNext}>
      <p>${question.text}</p>
      <div class="row">
        ${question.answers.map((text, k) => html`<button type="button" @click=${() => this.#reply(question, k)}>${text}</button>`)}
      </div>
    </div>`
  }

  #code(current: Step): TemplateResult {
    const words = this.#words
    return html`${PROGRAMS[this.#program].map(
      ({ title, lines }) => html`<p class="title">${words.titles[title]}</p>
        <ol aria-label=${words.titles[title]}>
          ${lines.map(
            ([line, depth]) =>
              html`<li class=${`deep-${depth}`} aria-current=${line === current.line ? 'step' : nothing}>${words.lines[line]}</li>`,
          )}
        </ol>`,
    )}`
  }

  #queuePart(trace: Trace, current: Step, state: TraceState): TemplateResult {
    const hasBegun = state.pairs.length > 0
    const waiting = hasBegun ? waitingDiscs(trace, state, current.end, MOST_WAITING) : []
    const count = hasBegun ? waitingCount(trace, state, current.end) : 0
    const rest = count - waiting.length
    return html`<details class="queue" open>
      <summary>${this.#words.queue(count)}</summary>
      <ol>
        ${waiting.map(({ r, circles }) => html`<li><span>${circles.join(circles.length === 2 ? '–' : '·')}</span><span>${numberOf(r)}</span></li>`)}
      </ol>
      ${rest > 0 ? html`<p class="note">${this.#words.more(rest)}</p>` : nothing}
    </details>`
  }

  /** The unrolled ring of directed edges of the selected circle, or of the first circle of the step. */
  #ringPart(
    trace: Trace,
    current: Step,
    state: TraceState,
    circleOf: (id: number) => Circle | undefined,
  ): TemplateResult | typeof nothing {
    const words = this.#words
    const event = current.event < trace.length ? trace.event(current.event) : undefined
    const id = this.#selected ?? (kindOf(current) === 'stage' ? undefined : event?.circles[0])
    const circle = id === undefined ? undefined : circleOf(id)
    if (id === undefined || circle === undefined) {
      return html`<details class="ring" open>
        <summary>${words.around}</summary>
        <p class="note">${words.selectOne}</p>
      </details>`
    }
    const { marks, unused } = ringOf(trace, state, id, circle)
    const x = (turn: number) => `${(3 + 94 * turn).toFixed(2)}%`
    const arcs = unused.flatMap(({ from, to }) =>
      to > 1
        ? [
            [from, 1],
            [0, to - 1],
          ]
        : [[from, to]],
    ) as [number, number][]
    const disc = event?.circles.includes(id) === true ? event.disc : undefined
    // An outgoing edge points away from the circle, an incoming edge toward it.
    const mark = ({ angle, isOut, other }: RingMark) => svg`<svg x=${x(angle)} overflow="visible">
      <path class="mark" d=${isOut ? 'M-3 50V24m-4 6l4-6 4 6' : 'M3 24V50m-4-6l4 6 4-6'} />
      <text y=${isOut ? 18 : 68} text-anchor="middle">${other}</text>
    </svg>`
    return html`<details class="ring" open>
      <summary>${words.aroundCircle(id, this.#selected !== undefined)}</summary>
      <svg class="ring" role="img" aria-label=${words.ring(id, marks)}>
        <line class="base" x1="3%" x2="97%" y1="52" y2="52" />
        ${arcs.map(([from, to]) => svg`<line class="unused" x1=${x(from)} x2=${x(to)} y1="52" y2="52" />`)}
        ${marks.map(mark)}
        ${disc === undefined ? nothing : svg`<circle class="foot" cx=${x(turnTo(circle, disc.x, disc.y))} cy="52" r="4" />`}
      </svg>
      <p class="note">${words.ringNote}</p>
    </details>`
  }
}

/** Adopted style sheets work under a strict Content-Security-Policy and in shadow roots. */
function adopt(root: Document | ShadowRoot): void {
  if (sheet === undefined) {
    sheet = new CSSStyleSheet()
    sheet.replaceSync(css)
  }
  if (!root.adoptedStyleSheets.includes(sheet)) root.adoptedStyleSheets = [...root.adoptedStyleSheets, sheet]
}
