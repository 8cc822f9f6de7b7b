// SPDX-License-Identifier: GPL-3.0-or-later

/** Marks the page while the focus moves by the keyboard. The figure is too large for a frame at each shortcut. */
export function markTabbing(): void {
  const { classList } = document.body
  addEventListener('keydown', ({ key }) => key === 'Tab' && classList.add('tabbing'), { capture: true })
  addEventListener('pointerdown', () => classList.remove('tabbing'), { capture: true })
}
