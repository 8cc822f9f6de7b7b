// SPDX-License-Identifier: GPL-3.0-or-later
export function finishSite(folder: string): Promise<void>
export function writeServiceWorker(folder: string): Promise<void>
