// SPDX-License-Identifier: GPL-3.0-or-later

/** The colors of a drawing: on light or on dark paper. */
export type Scheme = 'light' | 'dark'
