// SPDX-License-Identifier: GPL-3.0-or-later

/** The message for a part of the page that failed to load. */
export const NOT_LOADED = 'This part of the page could not be loaded. Try again.'
