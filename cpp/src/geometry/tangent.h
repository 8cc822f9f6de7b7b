// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "vectors.h"

namespace circle_voronoi {

/// The unit normal n, pointing to the right, of the common tangent of two circles that has both on its left and is
/// directed from i to j: n . c_i + r_i = n . c_j + r_j. Neither circle contains the other.
inline Vector tangentNormal(const Circle& i, const Circle& j) {
  const Vector v = between(i, j);
  const double d = length(v);
  const double difference = i.r - j.r;
  const double along = difference / d;
  const double across = std::sqrt(std::max((d - difference) * (d + difference), 0.0)) / d;
  return {(v.x * along + v.y * across) / d, (v.y * along - v.x * across) / d};
}

/// The point of a circle in the direction of a unit vector.
inline Point pointOn(const Circle& c, Vector direction) { return {c.x + c.r * direction.x, c.y + c.r * direction.y}; }

}  // namespace circle_voronoi
