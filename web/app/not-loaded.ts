// SPDX-License-Identifier: GPL-3.0-or-later

/** What is said of a part that did not come. */
export const NOT_LOADED = 'This part of the page could not be loaded. Try again.'
