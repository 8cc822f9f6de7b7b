// SPDX-License-Identifier: GPL-3.0-or-later

/** Has the browser keep the built site, so that it works without a network from now on. `site`: its address from the page. */
export async function workOffline(site = './'): Promise<void> {
  if (!import.meta.env.PROD || navigator.serviceWorker === undefined) return
  try {
    await navigator.serviceWorker.register(new URL(`${site}service-worker.js`, document.baseURI))
  } catch {
    // A browser may forbid it, as its storage; then the site needs a network, as others do.
  }
}
