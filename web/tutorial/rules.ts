// SPDX-License-Identifier: GPL-3.0-or-later

/** Shows the rules below a figure one at a time, each with the place of the figure where it applies. */
export function stepRules(page: Document): void {
  for (const group of page.querySelectorAll<HTMLElement>('.rules')) new Rules(group)
}

class Rules {
  readonly #group: HTMLElement
  readonly #items: readonly HTMLElement[]
  readonly #place: HTMLOutputElement
  readonly #back: HTMLButtonElement
  readonly #forth: HTMLButtonElement
  readonly #show: HTMLButtonElement
  readonly #all: HTMLButtonElement
  #current = 0

  constructor(group: HTMLElement) {
    const page = group.ownerDocument
    const button = (textContent: string, act: () => void) => {
      const made = Object.assign(page.createElement('button'), { type: 'button', textContent })
      made.addEventListener('click', act)
      return made
    }
    this.#group = group
    this.#items = [...group.querySelectorAll('li')]
    this.#place = page.createElement('output')
    this.#back = button('Previous rule', () => this.#step(-1))
    this.#forth = button('Next rule', () => this.#step(1))
    this.#show = button(group.dataset.show as string, () => this.#showPlace())
    this.#all = button('All rules', () => this.#toggle())
    const bar = Object.assign(page.createElement('div'), { className: 'drive' })
    bar.append(this.#back, this.#forth, this.#show, this.#all, this.#place)
    group.prepend(bar)
    group.classList.add('stepped')
    this.#draw()
  }

  #step(by: number): void {
    this.#current += by
    this.#draw()
    this.#showPlace()
  }

  #toggle(): void {
    this.#group.classList.toggle('stepped')
    this.#draw()
  }

  #draw(): void {
    const isStepped = this.#group.classList.contains('stepped')
    for (const [k, item] of this.#items.entries()) item.classList.toggle('current', k === this.#current)
    this.#place.value = isStepped ? `Rule ${this.#current + 1} of ${this.#items.length}` : ''
    this.#back.disabled = !isStepped || this.#current === 0
    this.#forth.disabled = !isStepped || this.#current === this.#items.length - 1
    this.#show.disabled = !isStepped || this.#at === undefined
    this.#all.setAttribute('aria-pressed', String(!isStepped))
  }

  get #at(): string | undefined {
    return this.#items[this.#current]?.dataset.at
  }

  /** Moves the figure to the event of the rule, or breaks it so that the rule notices. */
  #showPlace(): void {
    const page = this.#group.ownerDocument
    const control = page.querySelector<HTMLInputElement | HTMLSelectElement>(
      `#${this.#group.dataset.figure} :is(input[type="range"], .corrupt > select)`,
    )
    if (control === null || this.#at === undefined) return
    control.value = this.#at
    control.dispatchEvent(new Event(control.localName === 'input' ? 'input' : 'change'))
  }
}
