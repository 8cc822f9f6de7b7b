// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * Resolves once all style sheets have loaded or failed. WebKit, unlike other engines, may run modules earlier, when
 * elements have neither size nor color.
 */
export async function styleSheetsLoaded(): Promise<void> {
  const links = [...document.querySelectorAll<HTMLLinkElement>('link[rel=stylesheet]')]
  const loaded = (link: HTMLLinkElement) =>
    new Promise((resolve) => {
      for (const kind of ['load', 'error']) link.addEventListener(kind, resolve, { once: true })
    })
  await Promise.all(links.filter(({ sheet }) => sheet === null).map(loaded))
}
