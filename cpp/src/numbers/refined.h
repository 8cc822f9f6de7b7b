// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimate.h"
#include "exact.h"
#include "homogeneous_disc.h"

namespace circle_voronoi {

/// The second stage of the predicates. Its estimates rest on the lengths of common tangents, which have twice the
/// digits here, and on discs as seen from one of their circles. They decide near ties, and cases where discs or circles
/// are far larger than the distances between circles. If a tangent length is lost to rounding nevertheless, errors are
/// unknown. The preconditions are the same as in exact.h.

/// Computes the disc of three circles in counter-clockwise order, with the smallest as its corner.
CornerDisc refinedDiscOf(const Circle& c0, const Circle& c1, const Circle& c2);

/// Returns how far circle c reaches beyond the tangent line to the left of a -> b, times 2 |d|^2 (homogeneous_disc.h).
Estimate refinedReach(const Circle& a, const Circle& b, const Circle& c);

/// Estimates that decide exact::crossSign of two faces that share an edge.
struct RefinedTurn {
  Estimate cross;
  /// Positive if the first direction lies to the left of the axis of the second disc, as it does where both nearly
  /// agree. Then the sign is `side` times exact::overlapSign(first, added, from), which is the product of the signs of
  /// `factor` and `norm`.
  Estimate left;
  Estimate factor;  ///< not zero in a tie
  Estimate norm;    ///< its sign is exact::touchSign(first, added, from)
  int side = 0;
  const Circle* added = nullptr;  ///< the corner of the second face that the first does not have

  /// Returns the sign of the cross product, or 0 if the estimates do not decide.
  int sign() const {
    if (const int sign = cross.sign(); sign != 0) return sign;
    return left.sign() > 0 ? side * factor.sign() * norm.sign() : 0;
  }
};

RefinedTurn refinedTurn(const exact::Face& first, const exact::Face& second, const Circle& from);

}  // namespace circle_voronoi
