// SPDX-License-Identifier: GPL-3.0-or-later
import { spokenKeys } from '../editing/key-help.ts'
import theme from '../view/theme.css?inline'
import css from './shell.css?inline'
import type { Words } from './words.ts'

/** The style sheet shared by all figures of a page. Adopted sheets work under policies without inline styles. */
let sheet: CSSStyleSheet | undefined

/** The contents of an element's shadow root. Without circles it shows the poster, or the fallback between the tags. */
export class Shell {
  /** The picture with its overlays. */
  readonly frame = make('div', 'frame')
  /** The picture with its buttons. */
  readonly picture = make('div', 'picture')
  /** The drawing that is printed in place of pixels. */
  readonly print = make('div', 'paper')
  readonly figure = make('div', 'figure circle-voronoi')
  readonly controls = make('div', 'controls')
  /** The player below the picture. */
  readonly player = make('div', 'player')
  readonly said = make('p', 'visually-hidden')
  readonly #fallback = make('div', 'fallback')
  readonly #poster = slot('poster')
  readonly #hint = make('p', 'hint')
  readonly #problem = make('p', 'problem')
  readonly #about = make('p', 'visually-hidden')
  readonly #keys = make('p', 'visually-hidden')
  /** Called when colors may have changed. */
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
    // The figure handles keys itself, so screen readers must pass them on.
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
    this.print.hidden = true
    this.print.ariaHidden = 'true'
    this.frame.append(this.figure, this.print, this.#fallback, this.#hint, this.#problem)
    this.picture.append(this.frame, this.controls)
    // The probe's colors have transitions, whose events report changes of custom properties and of the color scheme.
    // Browsers report these changes in no other way.
    const probe = make('span', 'probe')
    probe.addEventListener('transitionrun', () => this.onrestyle())
    const stage = make('div', 'stage')
    const both = make('div', 'both')
    stage.append(both)
    both.append(this.picture, this.player)
    root.append(stage, probe, slot('caption'), this.#about, this.#keys, this.said)
    this.isRunning = false
  }

  /** Whether circles are visible. */
  set isRunning(isRunning: boolean) {
    this.frame.dataset.running = String(isRunning)
    this.figure.inert = !isRunning
    this.figure.tabIndex = isRunning ? 0 : -1
  }

  /** Shows the fallback for good, because the figure cannot run. */
  fail(): void {
    this.#poster.remove()
  }

  /** Whether there are pixels to print. */
  set isShown(isShown: boolean) {
    this.frame.dataset.shown = String(isShown)
  }

  /** Sets the accessible name, in the language of the page or else of the texts, and the description. */
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

  /** The current error message, or an empty text. */
  set problem(problem: string) {
    // Assigning the text announces it again.
    if (this.#problem.textContent !== problem) this.#problem.textContent = problem
    this.#problem.hidden = problem === ''
  }

  /** Shows a hint for a moment. */
  hint(text: string): void {
    clearTimeout(this.#hiding)
    this.#hint.textContent = text
    this.#hint.hidden = false
    this.#hiding = setTimeout(() => {
      this.#hint.hidden = true
    }, 1500)
  }
}

/** Sets the language, whose direction is left to right. */
function speak(element: HTMLElement, lang: string): void {
  element.lang = lang
  element.dir = 'ltr'
}

/** Creates an element with classes. */
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
