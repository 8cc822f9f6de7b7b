// SPDX-License-Identifier: GPL-3.0-or-later

/** Rounds a length to 1, 2 or 5 times a power of ten, a step that keeps numbers short. */
export function roundStep(length: number): number {
  const power = 10 ** Math.floor(Math.log10(length))
  const share = length / power
  // Multiplies or divides by a power of ten that a double represents exactly, so that the result is 0.2 rather than
  // 0.2000…1.
  const times = share < Math.SQRT2 ? 1 : share < Math.sqrt(10) ? 2 : share < Math.sqrt(50) ? 5 : 10
  return Number((times * power).toPrecision(1))
}
