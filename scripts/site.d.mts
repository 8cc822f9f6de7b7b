// SPDX-License-Identifier: GPL-3.0-or-later
/** Writes the service worker of the site in a folder. */
export function writeServiceWorker(folder: string): Promise<void>
