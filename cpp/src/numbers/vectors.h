// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "arithmetic.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/point.h"
#include "short_lengths.h"

namespace circle_voronoi {

inline double cross(Vector u, Vector v) { return u.x * v.y - u.y * v.x; }
inline double dot(Vector u, Vector v) { return u.x * v.x + u.y * v.y; }

/// Returns a number that grows with the angle of v from the x axis, from 0 to 4 for a full turn; 0 for the zero vector.
inline double pseudoAngle(Vector v) {
  const double size = std::abs(v.x) + std::abs(v.y);
  const double along = size > 0 ? v.x / size : 1;
  return v.y >= 0 ? 1 - along : 3 + along;
}

/// Returns the length of a vector, right to a few units of rounding at any scale.
inline double length(Vector v) {
  const double square = dot(v, v);
  if (square >= kShortLength * kShortLength) return std::sqrt(square);
  const double scale = scaleOf(std::max(std::abs(v.x), std::abs(v.y)));
  const Vector scaled = {v.x * scale, v.y * scale};
  return std::sqrt(dot(scaled, scaled)) / scale;
}

/// Returns whether a vector is certainly longer than `reach`, which must not be negative. Returns true for every vector
/// that is longer by 2e-12 of the reach, and for none that is not longer, rounding of the arguments included.
///
/// Error: the square of a reach that is not short is right within u, and that of the vector within 3 u or, where it
/// underflows, far below the other. With a short reach, the longer of the two is scaled into [1, 2) and the other one
/// likewise, so the same holds or the reach is far below the vector.
inline bool isLonger(Vector v, double reach) {
  if (reach < kShortLength) [[unlikely]] {
    const double scale = scaleOf(std::max({std::abs(v.x), std::abs(v.y), reach}));
    v = {v.x * scale, v.y * scale};
    reach *= scale;
  }
  return dot(v, v) > reach * reach * (1 + 1e-12);
}

/// Returns the vector from the center of one circle to the center of another.
inline Vector between(const Circle& from, const Circle& to) { return {to.x - from.x, to.y - from.y}; }

}  // namespace circle_voronoi
