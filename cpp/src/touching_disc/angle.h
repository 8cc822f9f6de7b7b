// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "vectors.h"

namespace circle_voronoi {

/// Directions that differ by less than this angle in radians count as a tie. The angle is far above the rounding error
/// of a three-touch disc and far below the difference of distinct discs.
inline constexpr double kSameDirection = 0x1p-30;

inline bool sameDirection(Vector u, Vector v) {
  const double along = dot(u, v);
  return along > 0 && std::abs(cross(u, v)) <= kSameDirection * along;
}

/// The sign of angle(v) - angle(u), both measured from `axis` in (-pi, pi); 0 if they agree within kSameDirection.
inline int compareAngles(Vector axis, Vector u, Vector v) {
  if (sameDirection(u, v)) return 0;
  const bool uLeft = cross(axis, u) >= 0;
  const bool vLeft = cross(axis, v) >= 0;
  if (uLeft != vLeft) return vLeft ? 1 : -1;
  return cross(u, v) > 0 ? 1 : -1;
}

/// Returns whether v is met strictly before w when turning counter-clockwise from u, and is not u itself. With w equal
/// to u nothing is before it.
inline bool strictlyBetween(Vector u, Vector v, Vector w) {
  const auto half = [u](Vector t) {
    const double side = cross(u, t);
    return side > 0 || (side == 0 && dot(u, t) > 0) ? 0 : 1;
  };
  if (cross(u, v) == 0 && dot(u, v) > 0) return false;
  return half(v) != half(w) ? half(v) < half(w) : cross(v, w) > 0;
}

}  // namespace circle_voronoi
