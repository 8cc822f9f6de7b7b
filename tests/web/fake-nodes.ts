// SPDX-License-Identifier: GPL-3.0-or-later
// Nodes of a page without a browser: only attributes, children and listeners. Events do not bubble.

export class FakeNode extends EventTarget {
  readonly tag: string
  readonly ownerDocument: FakePage | undefined
  readonly attributes = new Map<string, string>()
  readonly dataset: Record<string, string | undefined> = {}
  readonly style: Record<string, string> = {}
  readonly classes = new Set<string>()
  children: (FakeNode | string)[] = []
  parentElement: FakeNode | undefined
  id = ''
  lang: string | undefined = ''
  hidden = false
  value = ''

  constructor(tag: string, page?: FakePage) {
    super()
    this.tag = tag
    this.ownerDocument = page
  }

  readonly classList = {
    add: (...names: string[]) => {
      for (const name of names) this.classes.add(name)
    },
    remove: (name: string) => this.classes.delete(name),
    contains: (name: string) => this.classes.has(name),
    toggle: (name: string, isOn: boolean) => (isOn ? this.classes.add(name) : this.classes.delete(name)),
  }
  get className(): string {
    return [...this.classes].join(' ')
  }
  set className(names: string) {
    this.classes.clear()
    for (const name of names.split(' ')) this.classes.add(name)
  }
  get textContent(): string {
    return this.children.map((child) => (typeof child === 'string' ? child : child.textContent)).join('')
  }
  set textContent(text: string) {
    this.replaceChildren(text)
  }
  setAttribute(name: string, value: string): void {
    this.attributes.set(name, value)
  }
  getAttribute(name: string): string | null {
    return this.attributes.get(name) ?? null
  }
  append(...children: (FakeNode | string)[]): void {
    for (const child of children) {
      if (typeof child === 'string') this.children.push(child)
      else this.appendChild(child)
    }
  }
  appendChild<Child extends FakeNode>(child: Child): Child {
    child.remove()
    child.parentElement = this
    this.children.push(child)
    return child
  }
  replaceChildren(...children: (FakeNode | string)[]): void {
    for (const child of this.children) if (typeof child !== 'string') child.parentElement = undefined
    this.children = []
    this.append(...children)
  }
  before(node: FakeNode): void {
    this.#insert(node, 0)
  }
  after(node: FakeNode): void {
    this.#insert(node, 1)
  }
  #insert(node: FakeNode, offset: number): void {
    const siblings = this.parentElement?.children ?? []
    siblings.splice(siblings.indexOf(this) + offset, 0, node)
    node.parentElement = this.parentElement
  }
  remove(): void {
    const siblings = this.parentElement?.children
    siblings?.splice(siblings.indexOf(this), 1)
    this.parentElement = undefined
  }
  contains(other: FakeNode): boolean {
    for (let node: FakeNode | undefined = other; node !== undefined; node = node.parentElement)
      if (node === this) return true
    return false
  }
  closest(selector: string): FakeNode | null {
    return this.matches(selector) ? this : (this.parentElement?.closest(selector) ?? null)
  }
  /** Whether the node itself meets the last part of one of the selectors: a tag, an id, classes and attributes. */
  matches(selectors: string): boolean {
    return selectors.split(',').some((selector) => {
      const last = selector.trim().split(/[ >]+/).at(-1) as string
      return (last.match(/[#.]?[\w-]+|\[[^\]]+\]/g) ?? []).every((part) => {
        const name = part.replace(/^[#.[]|\]$/g, '')
        if (part.startsWith('#')) return this.id === name
        if (part.startsWith('.')) return this.classes.has(name)
        if (!part.startsWith('[')) return this.tag === name
        const key = name.replace(/^data-/, '').replace(/-(\w)/g, (_, letter: string) => letter.toUpperCase())
        return name.startsWith('data-') ? this.dataset[key] !== undefined : this.attributes.has(name)
      })
    })
  }
  querySelectorAll(selector: string): FakeNode[] {
    return this.children.flatMap((child) =>
      typeof child === 'string'
        ? []
        : [...(child.matches(selector) ? [child] : []), ...child.querySelectorAll(selector)],
    )
  }
  querySelector(selector: string): FakeNode | null {
    return this.querySelectorAll(selector)[0] ?? null
  }
  /** Returns the listed event after all its listeners. */
  fire(name: string, more: object = {}): Event {
    const event = Object.assign(new Event(name, { cancelable: true }), more)
    this.dispatchEvent(event)
    return event
  }
  click(): void {
    this.fire('click')
  }
  focus(): void {
    if (this.ownerDocument !== undefined) this.ownerDocument.activeElement = this
  }
}

export class FakePage extends FakeNode {
  readonly documentElement = new FakeNode('html')
  activeElement: FakeNode | undefined
  title = ''
  constructor() {
    super('document')
  }
  createElement(tag: string): FakeNode {
    return new FakeNode(tag, this)
  }
  createElementNS(_: string, tag: string): FakeNode {
    return new FakeNode(tag, this)
  }
  /** Creates an element with classes, an id and children. */
  make(
    tag: string,
    more: Partial<Pick<FakeNode, 'id' | 'className' | 'hidden' | 'value'>> = {},
    ...children: FakeNode[]
  ): FakeNode {
    const node = Object.assign(this.createElement(tag), more)
    node.append(...children)
    return node
  }
}
