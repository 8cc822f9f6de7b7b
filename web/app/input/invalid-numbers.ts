// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * Restores the last valid number when a field is left with an invalid one, which would otherwise stay visible without
 * effect.
 */
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
