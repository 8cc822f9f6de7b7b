// SPDX-License-Identifier: GPL-3.0-or-later

/** Returns a ring of any length from its least number on, so that it does not depend on where it begins. */
export function leastFirst(ring: readonly number[]): number[] {
  const start = ring.reduce((least, value, k) => (value < (ring[least] as number) ? k : least), 0)
  return [...ring.slice(start), ...ring.slice(0, start)]
}
