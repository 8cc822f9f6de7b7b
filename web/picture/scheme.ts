// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * The colors of a drawing, for light or dark paper.
 *
 * @category Pictures
 */
export type Scheme = 'light' | 'dark'
