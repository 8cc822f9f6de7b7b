// SPDX-License-Identifier: GPL-3.0-or-later
// A document for panels without a browser. Templates become trees of elements, which tests search by labels.
import { vi } from 'vitest'
import { INITIAL_STATE, type State } from '../../web/editing/state.ts'
import type { Store } from '../../web/editing/store.ts'

/** lit's value for nothing. Importing it here would wait for the module that this one replaces. */
const nothing = Symbol.for('lit-nothing')

/** The parts of a template that `render` reads. */
interface Template {
  readonly strings: readonly string[]
  readonly values: readonly unknown[]
}

class ClassList extends Set<string> {
  remove(name: string): void {
    this.delete(name)
  }
  contains(name: string): boolean {
    return this.has(name)
  }
  toggle(name: string, isOn = !this.has(name)): boolean {
    if (isOn) this.add(name)
    else this.delete(name)
    return isOn
  }
}

/** A stub of an element, with the attributes and children that templates and panels give it. */
export class PageElement extends EventTarget {
  readonly localName: string
  readonly attributes = new Map<string, string>()
  readonly classList = new ClassList()
  readonly style: Record<string, string> = {}
  parent: PageElement | undefined
  id = ''
  hidden = false
  disabled = false
  checked = false
  selected = false
  selectedIndex = 0
  readOnly = false
  value = ''
  title = ''
  type = ''
  placeholder = ''
  name = ''
  isValid = true
  files: readonly unknown[] = []
  labels: readonly PageElement[] = []
  offsetWidth = 0
  offsetHeight = 0
  clientWidth = 0
  clientHeight = 0
  nodes: readonly (PageElement | string)[] = []

  constructor(localName = 'div') {
    super()
    this.localName = localName
  }

  get valueAsNumber(): number {
    return this.value === '' ? Number.NaN : Number(this.value)
  }
  get elements(): PageElement[] {
    return this.nodes.flatMap((child) => (typeof child === 'string' ? [] : [child, ...child.elements]))
  }
  get textContent(): string {
    return this.nodes.map((child) => (typeof child === 'string' ? child : child.textContent)).join('')
  }
  set textContent(text: string) {
    this.replaceChildren(text)
  }
  set className(names: string) {
    for (const name of names.split(' ')) this.classList.add(name)
  }
  /** The text as it is read, without the white space of templates. */
  get text(): string {
    return this.textContent.replace(/\s+/g, ' ').trim()
  }
  /** The accessible name. The choices of a menu are not part of it. */
  get label(): string {
    if (this.attributes.has('aria-label')) return this.attributes.get('aria-label') as string
    if (this.localName === 'button') return this.text
    const isNamed = (other: PageElement) => other.attributes.get('for') === this.id
    const named = this.closest('label') ?? (this.id === '' ? undefined : this.root.elements.find(isNamed))
    return (named?.text ?? '').replace(this.text, '').trim()
  }
  /** The least and the largest number of a field, and its step. */
  get limits(): readonly (string | null)[] {
    return ['min', 'max', 'step'].map((name) => this.getAttribute(name))
  }
  /** The choices of a menu, and the chosen one. */
  get options(): readonly string[] {
    return this.querySelectorAll('option').map(({ text }) => text)
  }
  get chosen(): string | undefined {
    return this.querySelectorAll('option').find(({ selected }) => selected)?.text
  }
  get root(): PageElement {
    return this.parent?.root ?? this
  }
  append(...children: (PageElement | string)[]): void {
    for (const child of children) if (typeof child !== 'string') child.parent = this
    this.nodes = [...this.nodes, ...children]
  }
  replaceChildren(...children: (PageElement | string)[]): void {
    this.nodes = []
    this.append(...children)
  }
  setAttribute(name: string, value: string): void {
    this.attributes.set(name, value)
  }
  getAttribute(name: string): string | null {
    return this.attributes.get(name) ?? null
  }
  contains(other: unknown): boolean {
    return other === this || this.elements.includes(other as PageElement)
  }
  closest(selectors: string): PageElement | null {
    return this.matches(selectors) ? this : (this.parent?.closest(selectors) ?? null)
  }
  /** Knows names, classes and descendants. */
  matches(selectors: string): boolean {
    return selectors.split(/,\s*/).some((selector) => {
      const parts = selector.split(' ')
      const [, localName = '', name] = /^([\w-]*)(?:\.([\w-]+))?$/.exec(parts.at(-1) as string) ?? ['', '?']
      const isOwn = ['', this.localName].includes(localName) && (name === undefined || this.classList.has(name))
      const above = parts.slice(0, -1).join(' ')
      return isOwn && (above === '' || (this.parent?.closest(above) ?? null) !== null)
    })
  }
  querySelectorAll(selectors: string): PageElement[] {
    return this.elements.filter((element) => element.matches(selectors))
  }
  querySelector(selectors: string): PageElement | null {
    return this.querySelectorAll(selectors)[0] ?? null
  }
  focus(): void {
    Object.assign(document, { activeElement: this })
  }
  click(): void {
    this.dispatchEvent(new Event('click'))
  }
  reportValidity(): boolean {
    return this.isValid
  }

  /** The controls by their accessible names. */
  get controls(): Map<string, PageElement> {
    const kinds = ['button', 'input', 'select', 'textarea']
    return new Map(
      this.elements.filter((el) => kinds.includes(el.localName)).map((element) => [element.label, element]),
    )
  }
  control(label: string): PageElement {
    const control = this.controls.get(label)
    if (control === undefined) throw new Error(`There is no ${label}, but ${[...this.controls.keys()].join(' | ')}.`)
    return control
  }
  press(label: string): void {
    this.control(label).click()
  }
  /** Enters a value as a user does. */
  enter(label: string, entered: string | boolean, types: readonly string[] = ['input', 'change']): void {
    const control = this.control(label)
    Object.assign(control, typeof entered === 'string' ? { value: entered } : { checked: entered })
    for (const type of types) control.dispatchEvent(new Event(type))
  }
}

/** Renders a template as lit does, but anew each time. */
export function render(content: unknown, place: PageElement): void {
  place.replaceChildren(...nodesOf(content))
}

const MARK = '\u0001'
const TOKEN =
  /<!--[\s\S]*?-->|<\/([\w-]+)\s*>|<([\w-]+)((?:\s+[^\s=>/]+(?:\s*=\s*(?:"[^"]*"|[^\s>"]+))?)*)\s*(\/?)>|([^<]+)/g
const VOID = ['input', 'br', 'img']

function nodesOf(content: unknown): (PageElement | string)[] {
  if (content === nothing || content === undefined || content === null) return []
  if (Array.isArray(content)) return content.flatMap(nodesOf)
  if (typeof content !== 'object') return [String(content)]
  if ('strings' in content) return treeOf(content as Template)
  // Directives such as `keyed`.
  return nodesOf((content as Template).values.at(-1))
}

function treeOf({ strings, values }: Template): (PageElement | string)[] {
  const text = strings.map((part, k) => (k === 0 ? part : `${MARK}${k - 1}${MARK}${part}`)).join('')
  const top = new PageElement()
  let at = top
  for (const [, closed, opened, attributes = '', isClosed, plain] of text.matchAll(TOKEN)) {
    if (plain !== undefined) {
      at.append(...plain.split(MARK).flatMap((part, k) => (k % 2 === 0 ? [part] : nodesOf(values[Number(part)]))))
    } else if (closed !== undefined) {
      at = at.parent as PageElement
    } else if (opened !== undefined) {
      const element = new PageElement(opened)
      at.append(element)
      for (const [, name = '', quoted, bare = ''] of attributes.matchAll(/([^\s=]+)(?:\s*=\s*(?:"([^"]*)"|(\S+)))?/g)) {
        const parts = (quoted ?? bare).split(MARK)
        const isValue = parts.length === 3 && parts[0] === '' && parts[2] === ''
        const written = parts.map((part, k) => (k % 2 === 0 ? part : String(values[Number(part)]))).join('')
        give(element, name, isValue ? values[Number(parts[1])] : written)
      }
      if (isClosed === '' && !VOID.includes(opened)) at = element
    }
  }
  return [...top.nodes]
}

function give(element: PageElement, name: string, value: unknown): void {
  const [kind, rest] = [name[0], name.slice(1)]
  if (kind === '@') element.addEventListener(rest, value as EventListener)
  else if (kind === '.') Object.assign(element, { [rest]: value })
  else if (kind === '?') Object.assign(element, { [rest]: Boolean(value) })
  else if (value !== nothing) {
    element.setAttribute(name, String(value))
    if (name === 'class') element.className = String(value)
    else if (name in element && !['label', 'style'].includes(name))
      Object.assign(element, { [name]: value === '' ? true : value })
  }
}

/** Makes a document whose elements exist once they are asked for. Tests end with `vi.unstubAllGlobals()`. */
export function stubPage() {
  const known = new Map<string, PageElement>()
  const element = (id: string): PageElement => {
    const made = [...known.values()].flatMap(({ elements }) => elements).find((other) => other.id === id)
    if (made !== undefined) return made
    if (!known.has(id)) known.set(id, Object.assign(new PageElement(), { id }))
    return known.get(id) as PageElement
  }
  const stored = new Map<string, string>()
  const media = Object.assign(new EventTarget(), { matches: false })
  const page = Object.assign(new EventTarget(), {
    body: new PageElement('body'),
    documentElement: new PageElement('html'),
    activeElement: undefined as PageElement | undefined,
    title: 'circle-voronoi',
    baseURI: 'https://a.example/b/',
    getElementById: element,
    createElement: (name: string) => new PageElement(name),
    /** Finds the button of a panel. */
    querySelector: (selector: string) => element(`${/aria-controls="(.*)"/.exec(selector)?.[1]}-button`),
  })
  vi.stubGlobal('document', page)
  vi.stubGlobal('localStorage', {
    getItem: (name: string) => stored.get(name) ?? null,
    setItem: (name: string, text: string) => stored.set(name, text),
  })
  vi.stubGlobal('matchMedia', () => media)
  for (const kind of [
    '',
    'HTML',
    'HTMLInput',
    'HTMLButton',
    'HTMLParagraph',
    'HTMLHeading',
    'HTMLUList',
    'HTMLSelect',
  ]) {
    vi.stubGlobal(`${kind}Element`, PageElement)
  }
  for (const kind of ['Dialog', 'Anchor']) vi.stubGlobal(`HTML${kind}Element`, PageElement)
  return { page, element, media, stored }
}

/** An object whose functions note their calls. `known` has other members. */
export function noting<Known extends object>(done: unknown[], known: Known) {
  return new Proxy(known, {
    get: (_, name: string) =>
      name in known
        ? known[name as keyof Known]
        : (...values: unknown[]) => {
            done.push([name, ...values])
          },
  })
}

/** A store that notifies its subscribers at once. */
export function stateOf(initial: Partial<State> = {}) {
  let state: State = { ...INITIAL_STATE, ...initial }
  const listeners: ((state: State) => void)[] = []
  const update = (change: (state: State) => State) => {
    state = change(state)
    for (const listener of listeners) listener(state)
  }
  const store: Store<State> = {
    get: () => state,
    update,
    subscribe(listener) {
      listeners.push(listener)
      listener(state)
      return () => false
    },
  }
  return { store, change: (more: Partial<State>) => update((before) => ({ ...before, ...more })) }
}
