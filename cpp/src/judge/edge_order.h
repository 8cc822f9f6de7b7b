// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dual.h"
#include "predicates.h"

namespace circle_voronoi {

/// The half-edge of an edge between circles from whose origin, the larger circle, its bisector is ordered.
inline int fromLarger(const Dual& dual, int h, const Predicates& predicates) {
  const int t = dual.twin[h];
  return predicates.looksFromFirst(dual.origin[h], dual.origin[t]) ? h : t;
}

/// How the discs at the ends of a bounded edge lie along its bisector: 1 in order, 0 the same, -1 out of order. That
/// they are not out of order is what makes an edge right, for the judge and for those who build.
///
/// Around the origin of half-edge h, counter-clockwise, the face on its right comes before the face on its left:
/// `before` and `after` are the directions to their discs from there, and h is `fromLarger`. In order, the turn between
/// them is less than half a turn.
inline int orderOfEnds(const Dual& dual, int h, const Direction& before, const Direction& after,
                       Predicates& predicates) {
  const int sign = predicates.filteredCross(before, after);
  if (sign != 0) return sign;
  const int t = dual.twin[h];
  return predicates.exactEdgeOrder(dual.origin[h], dual.origin[t], dual.origin[Dual::previous(h)],
                                   dual.origin[Dual::previous(t)]);
}

}  // namespace circle_voronoi
