// SPDX-License-Identifier: GPL-3.0-or-later
// Corrections of happy-dom 21.0.4.

const menus = HTMLSelectElement.prototype as unknown as Record<symbol, (option?: unknown) => void>
const update = Object.getOwnPropertySymbols(menus).find(({ description }) => description === 'updateSelectedness')
const updated = menus[update as symbol]
const former = new WeakMap<HTMLSelectElement, HTMLOptionElement | undefined>()
// Where a selected option is inserted, another one stays selected. Browsers select the inserted one.
menus[update as symbol] = function (this: HTMLSelectElement, option?: unknown) {
  const selected = [...this.options].filter((one) => one.selected)
  updated?.call(this, option ?? selected.find((one) => one !== former.get(this)) ?? selected[0])
  former.set(this, this.selectedOptions[0])
}

// ARIA attributes are not reflected.
const REFLECTED =
  'Busy ColCount ColIndex Hidden Invalid Label Live MultiSelectable Pressed ReadOnly RowCount RowIndex Selected Sort'
for (const name of REFLECTED.split(' ')) {
  const attribute = `aria-${name.toLowerCase()}`
  Object.defineProperty(Element.prototype, `aria${name}`, {
    get(this: Element) {
      return this.getAttribute(attribute)
    },
    set(this: Element, value: string | null) {
      if (value === null) this.removeAttribute(attribute)
      else this.setAttribute(attribute, value)
    },
  })
}

Object.defineProperty(Element.prototype, 'role', {
  get(this: Element) {
    return this.getAttribute('role')
  },
  set(this: Element, value: string) {
    this.setAttribute('role', value)
  },
})

// Options have no constructor.
Object.assign(globalThis, {
  Option: function Option(text: string, value: string, defaultSelected = false, selected = false) {
    return Object.assign(document.createElement('option'), { text, value, defaultSelected, selected })
  },
})

// Replaced addresses cause hashchange, which browsers send for other changes of the address alone.
const replaced = new Set<string>()
const { replaceState } = History.prototype
History.prototype.replaceState = function (...values) {
  const before = location.href
  replaceState.apply(this, values)
  if (location.href !== before) replaced.add(location.href)
}
window.addEventListener('hashchange', (event) => {
  if (replaced.delete(event.newURL)) event.stopImmediatePropagation()
})

// Every color is supported, also an empty text.
const supports = (_name: string, value = '') => /^(#[\da-f]{3,8}|[a-z]+|[a-z]+\(.*\))$/i.test(value)
Object.defineProperty(globalThis, 'CSS', { value: { supports } })
