// SPDX-License-Identifier: GPL-3.0-or-later
import { MAP_COLORS, SHADES, type Style } from '../../web/view/style.ts'

/** A style whose colors are the names of its properties. */
export const NAMED_STYLE = new Proxy(
  {},
  {
    get(_, name) {
      const count = { map: MAP_COLORS, ramp: SHADES }[String(name)]
      return count === undefined ? String(name) : Array(count).fill(name)
    },
  },
) as Style
