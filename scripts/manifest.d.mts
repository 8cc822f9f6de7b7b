// SPDX-License-Identifier: GPL-3.0-or-later

/** What custom-elements.json says of the element. */
export function manifest(): object
