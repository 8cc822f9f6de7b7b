// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "vectors.h"

namespace circle_voronoi {

/// Squares of less are no longer exact.
inline constexpr double kTiny = 0x1p-500;

/// The unit normal n, pointing to the right, of the common tangent of two circles that has both on its left and is
/// directed from i to j: n . c_i + r_i = n . c_j + r_j. Neither circle contains the other.
inline Vector tangentNormal(const Circle& i, const Circle& j) {
  const Vector v = between(i, j);
  const double d = length(v);
  if (d < kTiny && (v.x != 0 || v.y != 0)) {
    // A power of two grows both without rounding.
    return tangentNormal({i.x / kTiny, i.y / kTiny, i.r / kTiny}, {j.x / kTiny, j.y / kTiny, j.r / kTiny});
  }
  const double difference = i.r - j.r;
  const double along = difference / d;
  const double across = std::sqrt(std::max((d - difference) * (d + difference), 0.0)) / d;
  return {(v.x * along + v.y * across) / d, (v.y * along - v.x * across) / d};
}

/// The point of a circle in the direction of a unit vector.
inline Point pointOn(const Circle& c, Vector direction) { return {c.x + c.r * direction.x, c.y + c.r * direction.y}; }

}  // namespace circle_voronoi
