// SPDX-License-Identifier: GPL-3.0-or-later

/** A number that is none, or out of its range, does not stay in its field unused: the last one that was right comes back. */
export function restoreInvalidNumbers(around: Document): void {
  const last = new WeakMap<HTMLInputElement, string>()
  const keep = ({ target }: Event) => {
    if (isNumber(target) && target.checkValidity()) last.set(target, target.value)
  }
  around.addEventListener('focusin', keep)
  around.addEventListener('change', keep)
  around.addEventListener('focusout', ({ target }) => {
    if (!isNumber(target) || target.checkValidity()) return
    target.value = last.get(target) ?? target.value
  })
}

function isNumber(target: EventTarget | null): target is HTMLInputElement {
  return target instanceof HTMLInputElement && target.type === 'number'
}
