// SPDX-License-Identifier: GPL-3.0-or-later
// Adds to happy-dom for an element: internals of form fields, visibility, sizes, and threads that can be held.
import { measure } from './page-document.ts'
import { ThreadHere } from './page-threads.ts'

/** The internals of a field, as far as the element uses them. */
class Internals {
  readonly states = new Set<string>()
  value = ''
  validationMessage = ''
  anchor: HTMLElement | undefined
  readonly #field: HTMLElement
  constructor(field: HTMLElement) {
    this.#field = field
  }
  get form(): HTMLFormElement | null {
    return this.#field.closest('form')
  }
  setFormValue(value: string) {
    this.value = value
  }
  setValidity(_: object, message = '', anchor?: HTMLElement) {
    this.validationMessage = message
    this.anchor = anchor
  }
  checkValidity(): boolean {
    return this.validationMessage === ''
  }
}

const internals = new WeakMap<HTMLElement, Internals>()
Object.assign(HTMLElement.prototype, {
  attachInternals(this: HTMLElement) {
    const own = new Internals(this)
    internals.set(this, own)
    return own
  },
})

const { attachShadow } = Element.prototype
Element.prototype.attachShadow = function (this: Element, options) {
  const root = attachShadow.call(this, options)
  // Sizes are measured once the figure is in the shadow.
  queueMicrotask(() => {
    const figure = root.querySelector<HTMLElement>('.figure')
    if (figure !== null) measure(figure, { clientWidth: 300, clientHeight: 200 })
  })
  return root
}

/** Tells new elements that they are near, unless a test says otherwise. */
export class Observer {
  static areNear = true
  readonly #tell: (entries: readonly object[]) => void
  readonly #isForNear: boolean
  constructor(tell: (entries: readonly object[]) => void, { rootMargin }: { readonly rootMargin: string }) {
    this.#tell = tell
    this.#isForNear = rootMargin.startsWith('25%')
  }
  observe(target: Element) {
    queueMicrotask(() => {
      if (Observer.areNear && this.#isForNear && target.isConnected) this.#tell([{ target, isIntersecting: true }])
    })
  }
  unobserve() {}
}
Object.assign(globalThis, { IntersectionObserver: Observer })

/** Messages to threads that wait. */
const waiting: (() => void)[] = []
let isHolding = false
const { postMessage } = ThreadHere.prototype
ThreadHere.prototype.postMessage = function (this: ThreadHere, data) {
  if (isHolding) waiting.push(() => postMessage.call(this, data))
  else postMessage.call(this, data)
}

export const held = {
  of: (field: HTMLElement) => ({ internals: internals.get(field) as Internals }),
  /** Holds messages to threads until they are released. */
  hold() {
    isHolding = true
  },
  release() {
    isHolding = false
    for (const post of waiting.splice(0)) post()
  },
  /** Resolves once a message is held. */
  async isFull() {
    while (waiting.length === 0) await new Promise((resolve) => requestAnimationFrame(resolve))
  },
}
