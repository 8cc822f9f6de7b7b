// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * Returns Carlson's elliptic integrals R_F(x, y, z) and R_D(x, y, z) up to rounding, where x, y and z are the squares
 * of three numbers above 0. By his duplication theorem (DLMF 19.36), each step quarters the differences between the
 * arguments and their mean. A series in the last differences gives the rest.
 */
export function carlson(rootX: number, rootY: number, rootZ: number): readonly [number, number] {
  // The series omit sixth powers. For ratios of 2^1000 there are about fifteen steps.
  const near = 1e-3
  const mostSteps = 50
  let [x, y, z] = [rootX * rootX, rootY * rootY, rootZ * rootZ]
  let [sum, power] = [0, 1]
  for (let step = 0; step < mostSteps; step++) {
    const mean = (x + y + z) / 3
    if (Math.max(Math.abs(mean - x), Math.abs(mean - y), Math.abs(mean - z)) <= near * mean) break
    const lambda = rootX * rootY + rootZ * (rootX + rootY)
    sum += power / (rootZ * (z + lambda))
    power /= 4
    x = (x + lambda) / 4
    y = (y + lambda) / 4
    z = (z + lambda) / 4
    rootX = Math.sqrt(x)
    rootY = Math.sqrt(y)
    rootZ = Math.sqrt(z)
  }
  const mean = (x + y + z) / 3
  const u = 1 - x / mean
  const v = 1 - y / mean
  const e2 = u * v - (u + v) * (u + v)
  const e3 = -u * v * (u + v)
  const first = 1 - e2 / 10 + e3 / 14 + (e2 * e2) / 24 - (3 * e2 * e3) / 44

  const weighted = (x + y + 3 * z) / 5
  const p = 1 - x / weighted
  const q = 1 - y / weighted
  const r = -(p + q) / 3
  const d2 = p * q - 6 * r * r
  const d3 = (3 * p * q - 8 * r * r) * r
  const d4 = 3 * (p * q - r * r) * r * r
  const d5 = p * q * r * r * r
  const second = 1 - (3 * d2) / 14 + d3 / 6 + (9 * d2 * d2) / 88 - (3 * d4) / 22 - (9 * d2 * d3) / 52 + (3 * d5) / 26
  return [first / Math.sqrt(mean), (power * second) / (weighted * Math.sqrt(weighted)) + 3 * sum]
}
