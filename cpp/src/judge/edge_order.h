// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "at.h"
#include "dual.h"
#include "portable.h"
#include "predicates.h"

namespace circle_voronoi {

/// Returns the half-edge of an edge between circles that starts from the larger circle. The bisector of the edge is
/// ordered as seen from that circle.
inline int fromLarger(const Dual& dual, int h, const Predicates& predicates) {
  const int t = dual.twin[at(h)];
  // The processor would often predict a branch wrongly here.
  const int isSecond = predicates.looksFromFirst(dual.origin[at(h)], dual.origin[at(t)]) ? 0 : 1;
  return h + isSecond * (t - h);
}

/// Stands for an order of ends that has not been found yet.
inline constexpr std::int8_t kUnknownOrder = -2;

/// Returns the order of the discs at the ends of a bounded edge along its bisector: 1 if in order, 0 if equal, -1 if
/// out of order. The judge and the builders both accept an edge if its ends are not out of order. `Discs` returns the
/// disc of a face by its number.
///
/// Seen from the larger circle, counter-clockwise, the face on the right of its half-edge comes before the face on the
/// left. In order, the turn between the directions to their discs is less than half a turn.
template <class Discs>
CIRCLE_VORONOI_ALWAYS_INLINE inline int orderOfEnds(const Dual& dual, int h, const Discs& discs,
                                                    Predicates& predicates) {
  const int larger = fromLarger(dual, h, predicates);
  const int t = dual.twin[at(larger)];
  const int from = dual.origin[at(larger)];
  const Direction before = predicates.direction(from, discs[at(t / 3)]);
  const Direction after = predicates.direction(from, discs[at(larger / 3)]);
  if (const int sign = predicates.filteredCross(before, after); sign != 0) return sign;
  return predicates.exactEdgeOrder(from, dual.origin[at(t)], dual.origin[at(Dual::previous(larger))],
                                   dual.origin[at(Dual::previous(t))]);
}

}  // namespace circle_voronoi
