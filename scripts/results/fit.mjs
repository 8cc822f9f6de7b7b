// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * Fits a power law y = c x^slope by least squares of logarithms. Returns the slope, the half-width of its 95 %
 * confidence interval, and the value at any x.
 * @param {{ x: number, y: number }[]} points positive, at least three, with at least two different x
 */
export function fitPower(points) {
  const logs = points.map(({ x, y }) => [Math.log(x), Math.log(y)])
  const mean = (k) => logs.reduce((sum, log) => sum + log[k], 0) / logs.length
  const [meanX, meanY] = [mean(0), mean(1)]
  const spread = logs.reduce((sum, [x]) => sum + (x - meanX) ** 2, 0)
  const slope = logs.reduce((sum, [x, y]) => sum + (x - meanX) * (y - meanY), 0) / spread
  const residual = logs.reduce((sum, [x, y]) => sum + (y - meanY - slope * (x - meanX)) ** 2, 0)
  const degrees = logs.length - 2
  return {
    slope,
    halfWidth: studentQuantile(degrees) * Math.sqrt(residual / degrees / spread),
    at: (x) => Math.exp(meanY + slope * (Math.log(x) - meanX)),
  }
}

/** The 97.5 % quantile of Student's distribution (Abramowitz and Stegun, 26.7.5, and a table below 3). */
export function studentQuantile(degrees) {
  if (degrees === 1) return 12.7062
  if (degrees === 2) return 4.3027
  const z = 1.959964
  return (
    z +
    (z ** 3 + z) / 4 / degrees +
    (5 * z ** 5 + 16 * z ** 3 + 3 * z) / 96 / degrees ** 2 +
    (3 * z ** 7 + 19 * z ** 5 + 17 * z ** 3 - 15 * z) / 384 / degrees ** 3 +
    (79 * z ** 9 + 776 * z ** 7 + 1482 * z ** 5 - 1920 * z ** 3 - 945 * z) / 92160 / degrees ** 4
  )
}

export function median(values) {
  const sorted = [...values].sort((a, b) => a - b)
  return sorted[Math.floor(sorted.length / 2)]
}
