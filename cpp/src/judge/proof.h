// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "at.h"
#include "circle_voronoi/circle.h"
#include "edge_order.h"

namespace circle_voronoi {

/// The record of a proof (judge.h) for one half-edge.
struct HalfEdgeProof {
  bool isLower : 1 = false;  ///< whether the disc of its face lies in the lower half, seen from its origin
  bool passes : 1 = false;   ///< whether the region of its origin passes the axis along its edge

  friend bool operator==(const HalfEdgeProof&, const HalfEdgeProof&) = default;
};

/// The data that prove a dual correct (judge.h). A builder fills in values of faces that it did not change, and the
/// judge computes the rest.
struct Proof {
  std::vector<FaceDisc> discs;      ///< of each face; the judge finds one that does not exist
  std::vector<std::int8_t> orders;  ///< of each half-edge: how the ends of its edge lie (orderOfEnds), or unknown
  std::vector<HalfEdgeProof> halfEdges;
};

/// Proves the faces and edges of a dual one by one. `Discs` gives the disc of a face by its number.
template <class Discs>
class Prover {
 public:
  /// The arguments must outlive the prover.
  Prover(const Dual& dual, std::span<const Circle> circles, Predicates& predicates, const Discs& discs,
         std::vector<HalfEdgeProof>& proof)
      : dual_(dual), circles_(circles), predicates_(predicates), discs_(discs), proof_(proof) {}

  /// Records in which half the disc of a face lies, seen from each corner. Returns whether the face has a disc.
  bool proveFace(int face) {
    const FaceDisc& disc = discs_[at(face)];
    if (!disc.exists) return false;
    const auto corners = cornersOf(dual_, 3 * face);
    for (int k = 0; k < 3; ++k) {
      if (corners[at(k)] == kPointAtInfinity) continue;
      proof_[at(3 * face + k)].isLower =
          predicates_.isLower(corners[at(k)], corners, predicates_.direction(corners[at(k)], disc));
    }
    return true;
  }

  /// Records whether the regions beside an edge, given by a half-edge, pass the axis along it, once both its faces are
  /// proven. Returns the order of its ends, which may be given. If that is negative, nothing is recorded.
  ///
  /// Around the origin of a half-edge, counter-clockwise, the face on its right comes before the face on its left. So
  /// the border of the origin's region turns from the right face's disc to the left one's, by less than a full turn. It
  /// passes the axis if the first disc is in the lower half and the second is not (Predicates::isLower). Around
  /// infinity nothing passes.
  int proveEdge(int h, int order = kUnknownOrder) {
    const int t = dual_.twin[at(h)];
    const int a = dual_.origin[at(h)];
    const int b = dual_.origin[at(t)];
    bool passesAtOrigin = false;
    bool passesAtTarget = false;
    const bool isBounded = a != kPointAtInfinity && b != kPointAtInfinity &&
                           dual_.origin[at(Dual::previous(h))] != kPointAtInfinity &&
                           dual_.origin[at(Dual::previous(t))] != kPointAtInfinity;
    if (isBounded) {
      if (order == kUnknownOrder) order = orderOfEnds(dual_, h, discs_, predicates_);
      if (order < 0) return order;
      // Seen from the larger circle, the turn is less than half a turn; from both if they are equal. Seen from the
      // smaller one, a turn that ends in the half where it begins may be nearly a full one. The smaller circle is
      // chosen without a branch, which the processor would often predict wrongly.
      passesAtOrigin = passesInOrder(h);
      passesAtTarget = passesInOrder(t);
      if (circles_[at(a)].r != circles_[at(b)].r) {
        const int isTarget = circles_[at(b)].r < circles_[at(a)].r ? 1 : 0;
        const int smaller = h + isTarget * (t - h);
        if (proof_[at(dual_.aroundClockwise(smaller))].isLower == proof_[at(smaller)].isLower && isLong(smaller)) {
          (isTarget != 0 ? passesAtTarget : passesAtOrigin) = true;
        }
      }
    } else {
      order = 1;
      passesAtOrigin = a != kPointAtInfinity && passes(h);
      passesAtTarget = b != kPointAtInfinity && passes(t);
    }
    proof_[at(h)].passes = passesAtOrigin;
    proof_[at(t)].passes = passesAtTarget;
    return order;
  }

 private:
  /// Returns whether a turn passes that is less than half a turn.
  bool passesInOrder(int h) const {
    const bool wasLower = proof_[at(dual_.aroundClockwise(h))].isLower;
    const bool isLower = proof_[at(h)].isLower;
    return wasLower > isLower;
  }

  /// Returns whether any turn passes: one within a half passes if it is nearly a full one.
  bool passes(int h) {
    const int before = dual_.aroundClockwise(h);
    return proof_[at(before)].isLower != proof_[at(h)].isLower ? proof_[at(before)].isLower : isLong(h);
  }

  /// Returns whether a turn is more than half a turn.
  bool isLong(int h) {
    const int before = dual_.aroundClockwise(h);
    return predicates_.turn(dual_.origin[at(h)], cornersOf(dual_, before), discs_[at(before / 3)], cornersOf(dual_, h),
                            discs_[at(h / 3)]) < 0;
  }

  const Dual& dual_;
  std::span<const Circle> circles_;
  Predicates& predicates_;
  const Discs& discs_;
  std::vector<HalfEdgeProof>& proof_;
};

}  // namespace circle_voronoi
