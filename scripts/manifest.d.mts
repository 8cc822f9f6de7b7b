// SPDX-License-Identifier: GPL-3.0-or-later

/** Returns the contents of custom-elements.json. */
export function manifest(): object
