// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "arithmetic.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/point.h"

namespace circle_voronoi {

inline double cross(Vector u, Vector v) { return u.x * v.y - u.y * v.x; }
inline double dot(Vector u, Vector v) { return u.x * v.x + u.y * v.y; }

/// Below this, squares lose digits to underflow.
inline constexpr double kShort = 0x1p-400;
/// Lengths that are short become ones whose squares lose none: 2^-1074, the least of them, 2^-374.
inline constexpr double kLengthening = 0x1p700;

/// Right to a few units of rounding at any scale.
inline double length(Vector v) {
  const double square = dot(v, v);
  if (square >= kShort * kShort) return std::sqrt(square);
  const Vector longer = {v.x * kLengthening, v.y * kLengthening};
  return std::sqrt(dot(longer, longer)) / kLengthening;
}

/// Whether a vector is certainly longer than `reach`, which must not be negative. Returns true for every vector that is
/// longer by 2e-12 of the reach, and for none that is not longer, rounding of the arguments included.
///
/// Error: the square of a reach that is not short is right within u, and that of the vector within 3 u or, where it
/// underflows, far below the other. A short reach is compared 2^700 times as long, and so is the vector: the same holds
/// there. A vector that becomes infinite is longer.
inline bool isLonger(Vector v, double reach) {
  if (reach < kShort) {
    v = {v.x * kLengthening, v.y * kLengthening};
    reach *= kLengthening;
  }
  return dot(v, v) > reach * reach * (1 + 1e-12);
}

/// From the centre of one circle to the centre of another.
inline Vector between(const Circle& from, const Circle& to) { return {to.x - from.x, to.y - from.y}; }

}  // namespace circle_voronoi
