// SPDX-License-Identifier: GPL-3.0-or-later

/** The methods whose times are compared: their names in the benchmark and on the page, in the order of the legend. */
export const METHODS = {
  auto: 'auto (this library, certified)',
  'touching-disc-1': 'dynamic sampling, N_s = 1',
  'touching-disc-uniform-50': 'uniform sampling, m = 50',
  'touching-disc-all-pairs': 'all pairs',
  'cgal-hierarchy': 'CGAL, filtered hierarchy',
  'cgal-exact': 'CGAL, exact',
}
