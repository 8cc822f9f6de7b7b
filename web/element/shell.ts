// SPDX-License-Identifier: GPL-3.0-or-later
import { spokenKeys } from '../editing/key-help.ts'
import theme from '../view/theme.css?inline'
import css from './shell.css?inline'
import type { Words } from './words.ts'

/** Of all figures of a page; a page without inline styles takes it. */
let sheet: CSSStyleSheet | undefined

/** What is inside of an element: without circles it shows its poster, or what stands between its tags. */
export class Shell {
  /** The picture, and what stands above it. */
  readonly frame = make('div', 'frame')
  /** The picture and its buttons. */
  readonly picture = make('div', 'picture')
  /** What is printed in place of pixels. */
  readonly paper = make('div', 'paper')
  readonly figure = make('div', 'figure circle-voronoi')
  readonly controls = make('div', 'controls')
  /** Where the method is told of, below the picture. */
  readonly player = make('div', 'player')
  readonly said = make('p', 'visually-hidden')
  readonly #fallback = make('div', 'fallback')
  readonly #poster = slot('poster')
  readonly #hint = make('p', 'hint')
  readonly #problem = make('p', 'problem')
  readonly #about = make('p', 'visually-hidden')
  readonly #keys = make('p', 'visually-hidden')
  /** Called where colors may be others. */
  onrestyle: () => void = () => {}
  #hiding: ReturnType<typeof setTimeout> | undefined

  constructor(root: ShadowRoot) {
    if (sheet === undefined) {
      sheet = new CSSStyleSheet()
      sheet.replaceSync(`${theme}\n${css}`)
    }
    root.adoptedStyleSheets = [sheet]
    this.#about.id = 'about'
    this.#keys.id = 'keys'
    this.figure.setAttribute('part', 'figure')
    // Its keys are its own, so a screen reader must pass them on.
    this.figure.role = 'application'
    this.figure.setAttribute('aria-describedby', 'about keys')
    this.controls.setAttribute('part', 'controls')
    this.controls.role = 'toolbar'
    this.player.setAttribute('part', 'player')
    this.player.role = 'region'
    this.player.hidden = true
    this.said.ariaLive = 'polite'
    this.#fallback.setAttribute('part', 'fallback')
    this.#fallback.append(this.#poster, slot(''))
    this.#hint.setAttribute('part', 'hint')
    this.#hint.ariaHidden = 'true'
    this.#hint.hidden = true
    this.#problem.setAttribute('part', 'problem')
    this.#problem.role = 'alert'
    this.#problem.hidden = true
    this.paper.hidden = true
    this.paper.ariaHidden = 'true'
    this.frame.append(this.figure, this.paper, this.#fallback, this.#hint, this.#problem)
    this.picture.append(this.frame, this.controls)
    // Its colors take a moment to change, which is told of: nothing else tells of a custom property, or of a page that turns dark.
    const probe = make('span', 'probe')
    probe.addEventListener('transitionrun', () => this.onrestyle())
    const stage = make('div', 'stage')
    const both = make('div', 'both')
    stage.append(both)
    both.append(this.picture, this.player)
    root.append(stage, probe, slot('caption'), this.#about, this.#keys, this.said)
    this.isRunning = false
  }

  /** Whether there are circles to be seen. */
  set isRunning(isRunning: boolean) {
    this.frame.dataset.running = String(isRunning)
    this.figure.inert = !isRunning
    this.figure.tabIndex = isRunning ? 0 : -1
  }

  /** There will be no figure: what stands between the tags is all that there is. */
  fail(): void {
    this.#poster.remove()
  }

  /** Whether there are pixels to be printed. */
  set isShown(isShown: boolean) {
    this.frame.dataset.shown = String(isShown)
  }

  /** What it is called in the language of its page, or else in that of the words, and what it shows. */
  describe(words: Words, label: string, about: string, isReadonly: boolean): void {
    this.controls.lang = words.lang
    for (const element of [this.#hint, this.#about, this.#keys, this.said, this.#problem]) speak(element, words.lang)
    this.player.lang = words.lang
    this.player.ariaLabel = words.player
    if (label === '') this.figure.lang = words.lang
    else this.figure.removeAttribute('lang')
    this.figure.ariaLabel = label === '' ? words.label : label
    this.controls.ariaLabel = this.figure.ariaLabel
    this.#about.textContent = about
    this.#keys.textContent = spokenKeys(words.keys, isReadonly)
  }

  /** What cannot be shown, and why, or nothing. */
  set problem(problem: string) {
    // It is read out whenever it is set.
    if (this.#problem.textContent !== problem) this.#problem.textContent = problem
    this.#problem.hidden = problem === ''
  }

  /** Says something for a moment. */
  hint(text: string): void {
    clearTimeout(this.#hiding)
    this.#hint.textContent = text
    this.#hint.hidden = false
    this.#hiding = setTimeout(() => {
      this.#hint.hidden = true
    }, 1500)
  }
}

/** Says in which language it is, which is written from left to right. */
function speak(element: HTMLElement, lang: string): void {
  element.lang = lang
  element.dir = 'ltr'
}

/** An element of some classes. */
export function make<Name extends keyof HTMLElementTagNameMap>(
  name: Name,
  classes: string,
): HTMLElementTagNameMap[Name] {
  const element = document.createElement(name)
  element.className = classes
  return element
}

function slot(name: string): HTMLSlotElement {
  const element = document.createElement('slot')
  if (name !== '') element.name = name
  return element
}
