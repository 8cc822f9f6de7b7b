// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "arithmetic.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/point.h"

namespace circle_voronoi {

/// The order in which a line from left to right meets points; one of the same x from below.
inline bool isBefore(Point p, Point q) { return p.x < q.x || (p.x == q.x && p.y < q.y); }

inline double cross(Vector u, Vector v) { return u.x * v.y - u.y * v.x; }
inline double dot(Vector u, Vector v) { return u.x * v.x + u.y * v.y; }

/// Returns a number that grows with the angle of v from the x axis, from 0 to 4 for a full turn; 0 for the zero vector.
inline double pseudoAngle(Vector v) {
  const double size = std::abs(v.x) + std::abs(v.y);
  const double along = size > 0 ? v.x / size : 1;
  return v.y >= 0 ? 1 - along : 3 + along;
}

/// Returns the length of a vector. It is right to a few units of rounding for differences of circles, whose squares are
/// 0 or between 2^-192 and 2^194 (limits.h), and wherever no square overflows or underflows.
inline double length(Vector v) { return std::sqrt(dot(v, v)); }

/// Returns whether a vector is certainly longer than `reach`, which must not be negative. Returns true for every vector
/// that is longer by 2e-12 of the reach, and for none that is not longer, rounding of the arguments included.
///
/// Error: both are differences of circles, so that nothing underflows (limits.h). The square of the reach is right
/// within u, and that of the vector within 3 u.
inline bool isLonger(Vector v, double reach) { return dot(v, v) > reach * reach * (1 + 1e-12); }

/// Returns the vector from the center of one circle to the center of another.
inline Vector between(const Circle& from, const Circle& to) { return {to.x - from.x, to.y - from.y}; }

}  // namespace circle_voronoi
