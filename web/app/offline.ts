// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * Registers the service worker, so that the built site works without a network. `site` is its address relative to the
 * page.
 */
export async function workOffline(site = './'): Promise<void> {
  if (!import.meta.env.PROD || navigator.serviceWorker === undefined) return
  try {
    await navigator.serviceWorker.register(new URL(`${site}service-worker.js`, document.baseURI))
  } catch {
    // Registration may be forbidden, like storage. The site then needs a network.
  }
}
