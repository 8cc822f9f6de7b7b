// SPDX-License-Identifier: GPL-3.0-or-later

/** A ring of points from a flat list of coordinates. */
export function ring(...coordinates: readonly number[]): [number, number][] {
  return Array.from({ length: coordinates.length / 2 }, (_, k) => [
    coordinates[2 * k] as number,
    coordinates[2 * k + 1] as number,
  ])
}

/** A rectangle as a counter-clockwise ring. */
export function box(minX: number, minY: number, maxX: number, maxY: number): [number, number][] {
  return ring(minX, minY, maxX, minY, maxX, maxY, minX, maxY)
}
