// SPDX-License-Identifier: GPL-3.0-or-later

/** Resolves once all that is seen in the element of a view has been painted. */
export function paintedOnce(figure: HTMLElement): Promise<void> {
  return new Promise((resolve) => {
    const observer = new MutationObserver(() => look())
    const look = () => {
      if (figure.ariaBusy !== 'false') return
      observer.disconnect()
      resolve()
    }
    observer.observe(figure, { attributeFilter: ['aria-busy'] })
    look()
  })
}
