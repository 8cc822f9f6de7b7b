// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "circle_voronoi/certificate.h"
#include "circle_voronoi/circle.h"
#include "dual.h"
#include "edge_order.h"
#include "predicates.h"

namespace circle_voronoi {

/// The discs of the faces of a dual, and what they show to be wrong with its edges. Flips and repair keep it in step
/// with the dual that they change.
class FaceDiscs {
 public:
  /// What is given must outlive this, and the number of faces stays.
  FaceDiscs(std::span<const Circle> circles, const Dual& dual, Predicates& predicates)
      : circles_(circles), dual_(dual), predicates_(predicates) {
    discs_.reserve(dual.faceCount());
    for (int face = 0; face < dual.faceCount(); ++face) discs_.push_back(predicates.disc(cornersOf(dual, 3 * face)));
  }

  std::span<const Circle> circles() const { return circles_; }
  const Dual& dual() const { return dual_; }
  Predicates& predicates() const { return predicates_; }

  /// Finds the disc of a face anew, whose corners have changed.
  void update(int face) { discs_[face] = predicates_.disc(cornersOf(dual_, 3 * face)); }

  /// Whether a face has a disc.
  bool exists(int face) const { return discs_[face].exists; }

  /// What the discs beside an edge show to be wrong: vertexWithoutDisc, edgeOutOfOrder, or hullNotClosed for an edge to
  /// infinity whose circle lies strictly within the tangent line of its neighbours on the hull. An edge without a flaw
  /// need not be one of the right dual: only all of them together prove it (judge.h).
  Flaw flawOf(int h) const {
    const int t = dual_.twin[h];
    if (!exists(h / 3) || !exists(t / 3)) return Flaw::vertexWithoutDisc;
    const int a = dual_.origin[h];
    const int b = dual_.origin[t];
    const int c = dual_.origin[Dual::previous(h)];
    const int d = dual_.origin[Dual::previous(t)];
    // Counter-clockwise the hull goes d, a, c or c, b, d.
    if (b == kInfinity) return flawAtInfinity(d, a, c);
    if (a == kInfinity) return flawAtInfinity(c, b, d);
    if (c == kInfinity || d == kInfinity) return Flaw::none;
    const int larger = fromLarger(dual_, h, predicates_);
    const int smaller = larger == h ? t : h;
    const int from = dual_.origin[larger];
    const auto toDisc = [&](int face) { return predicates_.direction(from, discs_[face]); };
    const bool isRight = isInOrder(dual_, larger, toDisc(smaller / 3), toDisc(larger / 3), predicates_);
    return isRight ? Flaw::none : Flaw::edgeOutOfOrder;
  }

 private:
  Flaw flawAtInfinity(int before, int circle, int after) const {
    if (before == after || predicates_.tangentSide(after, before, circle) >= 0) return Flaw::none;
    return Flaw::hullNotClosed;
  }

  std::span<const Circle> circles_;
  const Dual& dual_;
  Predicates& predicates_;
  std::vector<FaceDisc> discs_;
};

}  // namespace circle_voronoi
