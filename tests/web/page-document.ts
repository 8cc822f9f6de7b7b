// SPDX-License-Identifier: GPL-3.0-or-later
// The page without a browser, for tests in the environment happy-dom. Controls are found by their accessible names.
import { vi } from 'vitest'
import html from '../../web/index.html?raw'
import './happy-dom-fixes.ts'

const [BODY = ''] = /<main>.*<\/main>/s.exec(html) ?? []

const listen = document.addEventListener.bind(document)
let listening = new AbortController()

/** Fills the document, usually with the markup of the page. Tests end with `vi.unstubAllGlobals()`. */
export function openPage(body = BODY) {
  document.body.innerHTML = body
  document.body.className = ''
  localStorage.clear()
  listening.abort()
  listening = new AbortController()
  const { signal } = listening
  document.addEventListener = (type: string, listener: EventListener, options?: boolean | AddEventListenerOptions) =>
    listen(type, listener, { signal, ...(typeof options === 'object' ? options : { capture: options === true }) })
  const media = Object.assign(new EventTarget(), { matches: false })
  vi.stubGlobal('matchMedia', () => media)
  return { media }
}

export const element = <Kind extends HTMLElement>(id: string) => document.getElementById(id) as Kind

/** Creates an element with children. */
export function make<Name extends keyof HTMLElementTagNameMap>(
  name: Name,
  more: object = {},
  ...children: (Node | string)[]
) {
  const made = Object.assign(document.createElement(name), more)
  made.append(...children)
  return made
}

/** The button that opens a panel. */
export const buttonOf = (id: string) => document.querySelector(`[aria-controls="${id}"]`) as HTMLButtonElement

/** The text as it is read, without the white space of templates. */
export const textOf = (node: Node | null | undefined) => node?.textContent?.replace(/\s+/g, ' ').trim()

export function all<Name extends keyof HTMLElementTagNameMap>(
  within: Element,
  name: Name,
): HTMLElementTagNameMap[Name][]
export function all(within: Element, selectors?: string): HTMLElement[]
export function all(within: Element, selectors = '*') {
  return [...within.querySelectorAll<HTMLElement>(selectors)]
}

/** A control of any kind. Each has only some of the members. */
export type Control = HTMLInputElement & Pick<HTMLSelectElement, 'options' | 'selectedIndex'>

/** The accessible name. The choices of a menu are not part of it. */
function nameOf(control: Control): string {
  const name = control.getAttribute('aria-label')
  if (name !== null) return name
  if (control.localName === 'button') return textOf(control) ?? ''
  return (textOf(control.labels?.[0]) ?? '').replace(textOf(control) ?? '', '').trim()
}

/** The controls by their accessible names. */
export const controls = (within: Element) =>
  new Map((all(within, 'button, input, select, textarea') as Control[]).map((control) => [nameOf(control), control]))

export function control(within: Element, name: string): Control {
  const known = controls(within)
  const found = known.get(name)
  if (found === undefined) throw new Error(`There is no ${name}, but ${[...known.keys()].join(' | ')}.`)
  return found
}

export const press = (within: Element, name: string) => control(within, name).click()

/** Sends an event with further members, and returns it. */
export function send(target: EventTarget, type: string, more: object = {}) {
  const event = Object.assign(new Event(type, { bubbles: true, cancelable: true }), more)
  target.dispatchEvent(event)
  return event
}

/** Chooses files as a user does in the dialog of the browser. */
export function choose(input: HTMLInputElement, ...files: File[]) {
  Object.assign(input, { files })
  send(input, 'change')
}

/** The least and the largest number of a field, and its step. */
export const limitsOf = (field: Element) => ['min', 'max', 'step'].map((name) => field.getAttribute(name))

/** The choices of a menu. */
export const optionsOf = (menu: Element) => all(menu, 'option').map(textOf)

/** The chosen option of a menu. */
export const chosenOf = (menu: Control) => textOf(menu.options[menu.selectedIndex])

type Lengths = Pick<HTMLElement, 'clientWidth' | 'clientHeight' | 'offsetWidth' | 'offsetHeight'>

/** Gives an element lengths, which happy-dom does not compute. */
export function measure(element: HTMLElement, lengths: Partial<Lengths>) {
  for (const [name, value] of Object.entries(lengths)) {
    Object.defineProperty(element, name, { value, configurable: true })
  }
}
