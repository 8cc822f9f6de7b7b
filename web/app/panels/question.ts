// SPDX-License-Identifier: GPL-3.0-or-later

import { html, nothing, type TemplateResult } from 'lit/html.js'
import type { Editing } from '../../editing/editing.ts'
import type { State } from '../../editing/state.ts'
import { holds, idsOf, numbersIn } from '../../element/check.ts'
import { ENGLISH_GOALS, goalRings, goalsOf } from '../../element/goals.ts'
import type { Check } from '../../lib/check-types.ts'
import type { LinkFrame } from '../../lib/link.ts'
import { icon } from '../../player/icon.ts'
import { ADD, BIN, CHAIN, CODE, DOWN, TARGET } from '../../view/icons.ts'
import type { CellFacts, Facts } from '../../view/protocol.ts'
import { Rings } from '../../view/rings.ts'
import { short } from '../../view/short.ts'
import type { Store } from '../../view/store.ts'
import type { View } from '../../view/view.ts'
import { selectedIn } from '../../view/view-state.ts'
import type { FileActions } from '../files/file-actions.ts'
import type { PageActions } from '../page-actions.ts'
import {
  type Comparison,
  type Condition,
  checkOf,
  comparisonsOf,
  conditionsOf,
  KINDS,
  type Kind,
  kindOf,
  newCondition,
  sentenceOf,
} from '../question/conditions.ts'
import { byId } from './by-id.ts'
import { toastCopied } from './toast.ts'

const COMPARED: Readonly<Record<Comparison, string>> = {
  is: 'exactly',
  min: 'at least',
  max: 'at most',
  between: 'between',
}
const LONGEST_TITLE = 200
const LONGEST_QUESTION = 2000

interface Draft {
  readonly title: string
  readonly question: string
  readonly conditions: readonly Condition[]
  readonly isAny: boolean
  /** A link's check that the form's conditions cannot express. */
  readonly ownCheck: Check | undefined
  readonly readonly: boolean
  readonly alt: string
  readonly lang: string
}

/** The form of the panel Share that turns the current state into a question. `redraw` draws the panel again. */
export class QuestionForm {
  readonly #store: Store<State>
  readonly #editing: Editing
  readonly #view: View
  readonly #files: FileActions
  readonly #actions: PageActions
  readonly #redraw: () => void
  #draft: Draft = draftOf({})
  /** The link that the draft came from. */
  #from: LinkFrame | undefined
  #facts: Facts | undefined
  #isOpen = false
  /** The field that takes the next circle that is clicked. */
  #picking: { readonly label: string; readonly set: (id: number) => void } | undefined
  #rings: Rings | undefined

  constructor(
    store: Store<State>,
    editing: Editing,
    view: View,
    files: FileActions,
    actions: PageActions,
    redraw: () => void,
  ) {
    this.#store = store
    this.#editing = editing
    this.#view = view
    this.#files = files
    this.#actions = actions
    this.#redraw = redraw
    let edited = store.get().edited
    store.subscribe((state) => {
      const selected = selectedIn(state)
      if (this.#picking !== undefined && selected !== undefined) {
        const { set } = this.#picking
        this.#picking = undefined
        set(selected)
      }
      if (state.edited === edited || !this.#isOpen) return
      edited = state.edited
      this.#measure()
    })
  }

  /** Rings the circles of the conditions in the picture, as the frame does, while the form is visible. */
  ring(isPanelOpen: boolean): void {
    const isShown = isPanelOpen && this.#isOpen
    if (!isShown) this.#picking = undefined
    const check = isShown ? this.#check : undefined
    if (check !== undefined) this.#rings ??= new Rings(byId('figure', HTMLElement), this.#view)
    if (this.#facts === undefined) return
    this.#rings?.show(
      check === undefined ? [] : goalRings(check, goalsOf(check, this.#facts), this.#isMet === true, ENGLISH_GOALS),
    )
  }

  /** Loads the question of the last opened link into the form. */
  take(): void {
    const from = this.#actions.data.frame
    if (from === this.#from) return
    this.#from = from
    if (from === undefined) return
    this.#draft = draftOf(from)
    if (from.question !== undefined || from.check !== undefined) this.#isOpen = true
    this.#measure()
  }

  get isOpen(): boolean {
    return this.#isOpen
  }

  body(): TemplateResult {
    return html`<div id="make-question" ?hidden=${!this.#isOpen}>${this.#isOpen ? this.#form() : nothing}</div>`
  }

  /** Shows or hides the form. */
  toggle(): void {
    this.#isOpen = !this.#isOpen
    // Most questions have a condition.
    if (this.#isOpen && this.#draft.conditions.length === 0 && this.#draft.ownCheck === undefined) this.#add()
    this.#redraw()
    if (this.#isOpen) this.#measure()
  }

  #form(): TemplateResult {
    const { title, question, conditions, isAny, ownCheck, readonly, alt, lang } = this.#draft
    const set = (change: Partial<Draft>) => this.#set(change)
    const text = (event: Event) => (event.target as HTMLInputElement | HTMLTextAreaElement | HTMLSelectElement).value
    return html`
      <label class="field">Question
        <textarea rows="3" maxlength=${LONGEST_QUESTION} .value=${question} placeholder=${this.#suggestion}
          @input=${(event: Event) => set({ question: text(event) })}></textarea>
      </label>
      <fieldset>
        <legend>Solved when
          ${
            conditions.length < 2
              ? nothing
              : html`<select aria-label="How many conditions are needed" @change=${(event: Event) => set({ isAny: text(event) === 'any' })}>
                  <option value="all" .selected=${!isAny}>all of these are met</option>
                  <option value="any" .selected=${isAny}>one of these is met</option>
                </select>`
          }
        </legend>
        ${ownCheck === undefined ? nothing : this.#own(ownCheck)}
        ${conditions.map((condition, k) => this.#condition(condition, k))}
        <div class="choices">
          <button type="button" @click=${() => this.#add()}>${icon(ADD)}Add a condition</button>
        </div>
      </fieldset>
      <p id="question-now" class=${this.#warning === '' ? 'quiet' : 'wrong'} aria-live="polite">${this.#warning || this.#now}</p>
      <div class="fields two">
        <label class="field">Readers may
          <select @change=${(event: Event) => set({ readonly: text(event) === 'look' })}>
            <option value="edit" .selected=${!readonly}>edit circles</option>
            <option value="look" .selected=${readonly}>only look</option>
          </select>
        </label>
        <label class="field">Language
          <select @change=${(event: Event) => set({ lang: text(event) })}>
            <option value="en" .selected=${lang !== 'de'}>English</option>
            <option value="de" .selected=${lang === 'de'}>German</option>
          </select>
        </label>
      </div>
      <label class="field">Title
        <input type="text" maxlength=${LONGEST_TITLE} .value=${title} placeholder="none" autocomplete="off" @input=${(event: Event) => set({ title: text(event) })} />
      </label>
      <label class="field">Description for screen readers
        <input type="text" maxlength=${LONGEST_TITLE} .value=${alt} placeholder="none" autocomplete="off" @input=${(event: Event) => set({ alt: text(event) })} />
      </label>
      <div class="choices">
        <button type="button" class="primary" title="Copy HTML for a frame that asks the question in another page" @click=${() => this.#copy('code')}>
          ${icon(CODE)}Copy question code
        </button>
        <button type="button" title="Copy the address of the frame, for sites that embed addresses" @click=${() => this.#copy('link')}>
          ${icon(CHAIN)}Copy question link
        </button>
        <button type="button" title="Save a SCORM 1.2 file for Moodle, ILIAS and other course systems, which reports who has solved the question" @click=${() => this.#files.saveCourse(this.#frame)}>
          ${icon(DOWN)}SCORM file
        </button>
        <button type="button" data-prints title="Print the circles without their cells to draw on, a key, and a code that opens the frame on a phone" @click=${() => this.#print()}>
          Worksheet
        </button>
        <button type="button" title="Open the frame in a new tab" @click=${() => this.#files.openQuestion(this.#frame)}>Try it</button>
      </div>
    `
  }

  #own(check: Check): TemplateResult {
    return html`<div class="condition">
      <code>${JSON.stringify(check)}</code>
      <button type="button" class="icon" aria-label="Remove this condition" title="Remove" @click=${() => this.#set({ ownCheck: undefined })}>
        ${icon(BIN)}
      </button>
    </div>`
  }

  #condition(condition: Condition, k: number): TemplateResult {
    const kind = kindOf(condition)
    const change = (changes: Partial<Condition>) => this.#change(k, changes)
    const value = (event: Event) => (event.target as HTMLSelectElement).value
    const place = `condition ${k + 1}`
    const optionsOf = (of: Kind['of']) =>
      KINDS.filter((kind) => kind.of === of).map(
        ({ key, label }) => html`<option value=${key} .selected=${key === kind.key}>${label}</option>`,
      )
    return html`<div class="condition" role="group" aria-label=${`Condition ${k + 1}`}>
      <div class="row">
        <select aria-label=${`What ${place} is about`} @change=${(event: Event) => this.#chooseKind(k, value(event))}>
          <optgroup label="A circle">${optionsOf('cell')}</optgroup>
          <optgroup label="The diagram">${optionsOf('diagram')}</optgroup>
        </select>
        <button type="button" class="icon" aria-label=${`Remove ${place}`} title="Remove" @click=${() => this.#remove(k)}>${icon(BIN)}</button>
      </div>
      <div class="row">
        ${
          kind.of === 'cell'
            ? html`<span>of circle</span>${this.#circleField(condition.circle, `Circle of ${place}`, (circle) => change({ circle }))}`
            : html`<span>of the diagram</span>`
        }
        <small>${this.#valueNow(condition, kind)}</small>
      </div>
      <div class="row">${this.#valueFields(condition, kind, place, change)}</div>
    </div>`
  }

  #valueFields(
    condition: Condition,
    kind: Kind,
    place: string,
    change: (changes: Partial<Condition>) => void,
  ): TemplateResult {
    const { comparison, value, most, flag, other } = condition
    const text = (event: Event) => (event.target as HTMLSelectElement).value
    if (kind.type === 'flag') {
      return html`<select aria-label=${`Value of ${place}`} @change=${(event: Event) => change({ flag: text(event) === 'yes' })}>
        <option value="yes" .selected=${flag}>yes</option>
        <option value="no" .selected=${!flag}>no</option>
      </select>`
    }
    if (kind.type === 'circle')
      return html`<span>circle</span>${this.#circleField(other, `Neighbor of ${place}`, (other) => change({ other }))}`
    return html`<select aria-label=${`Comparison of ${place}`} @change=${(event: Event) => change({ comparison: text(event) as Comparison })}>
        ${comparisonsOf(kind).map(
          (name) => html`<option value=${name} .selected=${name === comparison}>${COMPARED[name]}</option>`,
        )}
      </select>
      ${numberField(value, `Value of ${place}`, kind, (value) => change({ value }))}
      ${
        comparison === 'between'
          ? html`<span>and</span>${numberField(most, `Upper value of ${place}`, kind, (most) => change({ most }))}`
          : nothing
      }`
  }

  #circleField(id: number, label: string, set: (id: number) => void): TemplateResult {
    const change = (event: Event) => {
      const input = event.target as HTMLInputElement
      if (input.reportValidity()) set(input.valueAsNumber)
      else input.value = String(id)
    }
    const isPicking = this.#picking?.label === label
    const [what = '', place] = label.split(' of ')
    return html`<input type="number" min="0" step="1" required aria-label=${label} .value=${String(id)} @change=${change} autocomplete="off" />
      <button type="button" class="pick" aria-pressed=${String(isPicking)} aria-label=${`Choose the ${what.toLowerCase()} for ${place} in the picture`}
        title="Click a circle in the picture to choose it" @click=${() => this.#pick(label, set)}>
        ${icon(TARGET)}${isPicking ? 'Click a circle' : 'Choose'}
      </button>`
  }

  /** Takes the next circle that is selected, or cancels that. */
  #pick(label: string, set: (id: number) => void): void {
    const isPicking = this.#picking?.label === label
    // A click on the selected circle has to select it anew.
    if (!isPicking) this.#actions.selection.select([])
    this.#picking = isPicking ? undefined : { label, set }
    this.#redraw()
  }

  #chooseKind(k: number, key: string): void {
    const kind = kindOf({ kind: key })
    const [first] = comparisonsOf(kind)
    const { comparison } = this.#draft.conditions[k] as Condition
    const isAllowed = comparisonsOf(kind).includes(comparison)
    this.#change(k, { kind: key, comparison: isAllowed ? comparison : (first as Comparison) })
  }

  #add(): void {
    const selected = selectedIn(this.#store.get())
    const first = this.#editing.circles.next(0, 1) ?? 0
    this.#set({ conditions: [...this.#draft.conditions, newCondition(selected ?? first)] })
  }

  #remove(k: number): void {
    this.#set({ conditions: this.#draft.conditions.filter((_, i) => i !== k) })
  }

  #change(k: number, changes: Partial<Condition>): void {
    const conditions = this.#draft.conditions.map((condition, i) =>
      i === k ? { ...condition, ...changes } : condition,
    )
    this.#set({ conditions })
  }

  #set(change: Partial<Draft>): void {
    this.#draft = { ...this.#draft, ...change }
    this.#redraw()
    if ('conditions' in change || 'ownCheck' in change) this.#measure()
  }

  get #check(): Check | undefined {
    const { conditions, isAny, ownCheck } = this.#draft
    return checkOf(conditions, isAny, ownCheck)
  }

  get #suggestion(): string {
    return this.#sentence(false)
  }

  /** A sentence with the numbers that the circles have in the frame. */
  #sentence(isOnPaper: boolean): string {
    const { conditions, isAny, lang } = this.#draft
    const { circles } = this.#editing
    const numbered = conditions.map((condition) => ({
      ...condition,
      circle: circles.countBelow(condition.circle),
      other: circles.countBelow(condition.other),
    }))
    return sentenceOf(numbered, isAny, lang, isOnPaper)
  }

  #print(): void {
    const own = this.#draft.question.trim()
    void this.#files.printWorksheet(this.#frame, own === '' ? this.#sentence(true) : own)
  }

  get #frame(): LinkFrame {
    const { title, question, readonly, alt, lang } = this.#draft
    const check = this.#check
    const asked = question.trim() === '' ? this.#suggestion : question.trim()
    return {
      ...(title.trim() !== '' && { title: title.trim() }),
      ...(asked !== '' && { question: asked }),
      ...(check !== undefined && { check }),
      ...(readonly && { readonly }),
      ...(alt.trim() !== '' && { alt: alt.trim() }),
      ...(lang !== 'en' && { lang }),
    }
  }

  async #copy(what: 'code' | 'link'): Promise<void> {
    const length = await this.#files.copyQuestion(what, this.#frame)
    if (length !== undefined) toastCopied(`The ${what} of the question`, length)
  }

  /** Requests the values for the conditions. */
  async #measure(): Promise<void> {
    const check = this.#check
    const facts = await this.#view.scene.ask('tell', [check === undefined ? [] : idsOf(check)])
    if (check !== undefined && JSON.stringify(check) !== JSON.stringify(this.#check)) return
    this.#facts = facts
    this.#redraw()
  }

  /** The current value of a condition's quantity. */
  #valueNow({ circle }: Condition, kind: Kind): string {
    if (this.#facts === undefined) return ''
    if (kind.of === 'diagram') return `now ${this.#facts[kind.name]}`
    const facts = this.#facts.cells.get(circle)
    if (facts === undefined) return 'no such circle'
    const value = measureOf(facts, kind)
    return typeof value === 'number' ? `now ${Number.isFinite(value) ? short(value) : 'infinite'}` : `now ${value}`
  }

  get #isMet(): boolean | undefined {
    const check = this.#check
    if (check === undefined || this.#facts === undefined) return undefined
    return holds(check, this.#facts)
  }

  get #now(): string {
    if (this.#check === undefined) return 'Without a condition, the frame shows the text alone.'
    return this.#isMet === false ? 'The circles do not meet this yet, so there is something to do.' : ''
  }

  /** The reason why the question cannot be solved, or is solved already. */
  get #warning(): string {
    const check = this.#check
    if (check === undefined) return ''
    const missing = numbersIn(check).find((id) => this.#editing.circles.get(id) === undefined)
    if (missing !== undefined) return `There is no circle ${missing}.`
    if (this.#isMet === true) return 'The circles meet this already. Move them, so that there is something to do.'
    if (this.#draft.readonly) return 'Readers who may only look cannot solve this.'
    return ''
  }
}

function numberField(value: number, label: string, { type }: Kind, set: (value: number) => void): TemplateResult {
  const change = (event: Event) => {
    const input = event.target as HTMLInputElement
    if (input.reportValidity()) set(input.valueAsNumber)
    else input.value = String(value)
  }
  const step = type === 'count' ? '1' : 'any'
  return html`<input type="number" required step=${step} aria-label=${label} .value=${String(value)} @change=${change} autocomplete="off" />`
}

function measureOf(facts: CellFacts, { name }: Kind): number | string {
  switch (name) {
    case 'neighbors':
      return facts.neighbors.length
    case 'neighbor':
      return facts.neighbors.length === 0 ? 'none' : [...facts.neighbors].sort((a, b) => a - b).join(', ')
    case 'bounded':
      return facts.bounded ? 'yes' : 'no'
    case 'hidden':
      return facts.hidden ? 'yes' : 'no'
    default:
      return facts[name as 'edges' | 'area' | 'x' | 'y' | 'r']
  }
}

function draftOf({ title = '', question = '', check, readonly = false, alt = '', lang = 'en' }: LinkFrame): Draft {
  const listed = check && conditionsOf(check)
  return {
    title,
    question,
    conditions: listed?.conditions ?? [],
    isAny: listed?.isAny ?? false,
    ownCheck: listed === undefined ? check : undefined,
    readonly,
    alt,
    lang: /^de\b/i.test(lang) ? 'de' : 'en',
  }
}
