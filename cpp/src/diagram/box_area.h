// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "circle_voronoi/periodic_diagram.h"
#include "two_part.h"

namespace circle_voronoi {

/// Returns the area |a x b| of a lattice's box, right to a few units of rounding. The periods of a strongly sheared box
/// are nearly parallel, so the products are taken in two parts.
inline double boxArea(const Lattice& lattice) {
  const auto& [a, b] = lattice;
  int exponent = 0;
  std::frexp(std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)}), &exponent);
  const auto scaled = [&](double x) { return std::ldexp(x, -exponent); };
  const TwoPart p = product(scaled(a.x), scaled(b.y));
  const TwoPart q = product(scaled(a.y), scaled(b.x));
  const TwoPart difference = sum(p.value, -q.value);
  return std::ldexp(std::abs(difference.value + (difference.rest + (p.rest - q.rest))), 2 * exponent);
}

}  // namespace circle_voronoi
