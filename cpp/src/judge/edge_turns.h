// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "circle_voronoi/circle.h"
#include "edge_order.h"

namespace circle_voronoi {

/// What one edge says in a proof (judge.h). Around the origin of a half-edge, counter-clockwise, the face on its right
/// comes before the face on its left: the region of the origin turns from the disc of the one to that of the other, by
/// less than a full turn.
struct EdgeTurns {
  int endOrder = 1;             ///< of the ends (orderOfEnds); 1 if the edge is not bounded
  bool passesAtOrigin = false;  ///< whether the turn passes the axis (Predicates::isLower) from below
  bool passesAtTarget = false;  ///< the same around the other circle, by the twin
};

/// The turns of an edge, given by a half-edge; its faces have discs. If the order of the ends is negative, the rest is
/// not there. Around infinity nothing passes.
///
/// `discs` gives of a half-edge `toDisc(h)`, the direction from its origin to the disc of its face, and `isLower(h)`,
/// whether that lies in the lower half.
template <class Discs>
EdgeTurns turnsOf(const Discs& discs, const Dual& dual, std::span<const Circle> circles, Predicates& predicates,
                  int h) {
  const auto cornersOfFace = [&](int corner) { return cornersOf(dual, corner - corner % 3); };
  // The corner of the face on the right of a half-edge that is its origin.
  const auto cornerBefore = [&](int from) { return Dual::next(dual.twin[from]); };
  // Of a turn that is less than half a turn.
  const auto passesInOrder = [&](int from) { return discs.isLower(cornerBefore(from)) > discs.isLower(from); };
  // Of any turn: one within a half passes if it is nearly a full one.
  const auto passes = [&](int from) {
    const int before = cornerBefore(from);
    if (discs.isLower(before) != discs.isLower(from)) return discs.isLower(before) != 0;
    int sign = predicates.filteredCross(discs.toDisc(before), discs.toDisc(from));
    if (sign == 0) sign = predicates.exactCross(dual.origin[from], cornersOfFace(before), cornersOfFace(from));
    return sign < 0;
  };

  const int t = dual.twin[h];
  const int a = dual.origin[h];
  const int b = dual.origin[t];
  if (b == kPointAtInfinity) return {1, passes(h), false};
  if (a == kPointAtInfinity) return {1, false, passes(t)};
  const bool isBounded =
      dual.origin[Dual::previous(h)] != kPointAtInfinity && dual.origin[Dual::previous(t)] != kPointAtInfinity;
  if (!isBounded) return {1, passes(h), passes(t)};
  const int larger = fromLarger(dual, h, predicates);
  const int order = orderOfEnds(dual, larger, discs.toDisc(cornerBefore(larger)), discs.toDisc(larger), predicates);
  if (order < 0) return {order};
  // From the larger circle the turn is less than half a turn, and from both if they are equal.
  const bool areEqual = circles[a].r == circles[b].r;
  const auto passesAt = [&](int from) { return from == larger || areEqual ? passesInOrder(from) : passes(from); };
  return {order, passesAt(h), passesAt(t)};
}

}  // namespace circle_voronoi
