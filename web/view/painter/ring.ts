// SPDX-License-Identifier: GPL-3.0-or-later

/** Rotates a ring so that its smallest number comes first, which makes equal rings equal arrays. */
export function leastFirst(ring: readonly number[]): number[] {
  const start = ring.reduce((least, value, k) => (value < (ring[least] as number) ? k : least), 0)
  return [...ring.slice(start), ...ring.slice(0, start)]
}
