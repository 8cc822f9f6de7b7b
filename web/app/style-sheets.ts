// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * Resolves once the style sheets of the page have been loaded or could not be. Other engines run the modules of a page only
 * then; WebKit runs them earlier, when nothing has its size or its color yet.
 */
export async function styleSheetsLoaded(): Promise<void> {
  const links = [...document.querySelectorAll<HTMLLinkElement>('link[rel=stylesheet]')]
  const loaded = (link: HTMLLinkElement) =>
    new Promise((resolve) => {
      for (const kind of ['load', 'error']) link.addEventListener(kind, resolve, { once: true })
    })
  await Promise.all(links.filter(({ sheet }) => sheet === null).map(loaded))
}
