// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * Disables or enables a button. A focused button passes the focus to the figure, because the body would get it
 * otherwise.
 */
export function disable(button: HTMLButtonElement, isDisabled: boolean, figure: HTMLElement): void {
  if (isDisabled && button.matches(':focus')) figure.focus()
  button.disabled = isDisabled
}
