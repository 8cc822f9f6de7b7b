// SPDX-License-Identifier: GPL-3.0-or-later

/** Disables a button, or no longer. Where it has the focus, that goes to the figure: it would fall to the body. */
export function disable(button: HTMLButtonElement, isDisabled: boolean, figure: HTMLElement): void {
  if (isDisabled && button.matches(':focus')) figure.focus()
  button.disabled = isDisabled
}
