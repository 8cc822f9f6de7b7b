// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "at.h"
#include "branchless.h"
#include "circle_voronoi/certificate.h"
#include "circle_voronoi/circle.h"
#include "dual.h"
#include "edge_order.h"
#include "predicates.h"
#include "proof.h"

namespace circle_voronoi {

/// The discs of the faces of a dual, and the flaws of its edges that they show. Code that changes the dual must keep
/// this object in step.
class FaceDiscs {
 public:
  /// Finds all discs, and the orders of all edges, which `update` alone keeps in step. The arguments must outlive this
  /// object.
  FaceDiscs(std::span<const Circle> circles, const Dual& dual, Predicates& predicates, Threads threads = Threads())
      : circles_(circles),
        dual_(dual),
        predicates_(predicates),
        discs_(dual.origin.size() / 3),
        orders_(dual.origin.size(), kUnknownOrder) {
    // Each edge once both its faces have a disc; between two ranges, once both ranges are done. A few faces at a time
    // stay in the cache.
    std::vector<std::vector<int>> across(threads.rangesOf(discs_.size()));
    predicates.forRanges(
        threads, discs_.size(), [&](std::size_t begin, std::size_t end, std::size_t range, Predicates& own) {
          std::array<int, 3 * kFacesAtATime> halves;
          for (std::size_t from = begin; from < end; from += kFacesAtATime) {
            const auto first = static_cast<int>(from);
            const auto last = static_cast<int>(std::min(from + kFacesAtATime, end));
            for (int face = first; face < last; ++face) discs_[at(face)] = own.disc(cornersOf(dual, 3 * face));
            const std::size_t count = select(3 * first, 3 * last, halves, [&](int t) { return dual.twin[at(t)] < t; });
            for (std::size_t k = 0; k < count; ++k) {
              const int h = dual.twin[at(halves[k])];
              if (h < 0) continue;  // an edge may be open
              if (h < 3 * static_cast<int>(begin)) {
                across[range].push_back(h);
              } else {
                noteOrder(h, own);
              }
            }
          }
        });
    for (const auto& edges : across) {
      for (const int h : edges) noteOrder(h, predicates);
    }
  }

  std::span<const Circle> circles() const { return circles_; }
  const Dual& dual() const { return dual_; }
  Predicates& predicates() const { return predicates_; }

  /// Finds the disc of a face again after its corners have changed, or the disc of a face that was added after the
  /// last.
  void update(int face) {
    if (face == static_cast<int>(discs_.size())) discs_.emplace_back();
    discs_[at(face)] = predicates_.disc(cornersOf(dual_, 3 * face));
    if (orders_.empty()) return;
    changed_.push_back(face);
    for (int h = 3 * face; h < 3 * face + 3; ++h) orders_[at(h)] = orders_[at(dual_.twin[at(h)])] = kUnknownOrder;
  }

  /// Notes that a face has no disc, for example because one of its circles hides another. The face may be one added
  /// after the last.
  void clear(int face) {
    if (face == static_cast<int>(discs_.size())) discs_.emplace_back();
    discs_[at(face)] = {};
  }

  /// Sets the number of faces. Added faces have no disc.
  void resize(std::size_t count) { discs_.resize(count); }

  void set(int face, const FaceDisc& disc) { discs_[at(face)] = disc; }

  /// Sets the circles again after they have moved in memory or more were added.
  void setCircles(std::span<const Circle> circles) { circles_ = circles; }

  const FaceDisc& operator[](std::size_t face) const { return discs_[face]; }

  /// Moves out the discs and orders of the faces that `update` has not changed. The judge finds the others itself, so
  /// that its verdict does not depend on a face being updated after each change.
  Proof takeProof() {
    for (const int face : changed_) {
      discs_[at(face)] = {};
      for (int h = 3 * face; h < 3 * face + 3; ++h) orders_[at(h)] = orders_[at(dual_.twin[at(h)])] = kUnknownOrder;
    }
    return {std::move(discs_), std::move(orders_), {}};
  }

  /// Returns the direction from the origin of a half-edge to the disc of its face.
  Vector direction(int h) const {
    const auto [x, y, error] = predicates_.direction(dual_.origin[at(h)], discs_[at(h / 3)]);
    return {x, y};
  }

  /// Returns whether an edge is known to have no flaw.
  bool isKnownRight(int h) const { return !orders_.empty() && orders_[at(h)] >= 0; }

  /// Returns the same flaw as `flawOf`, but caches the order of the ends of an edge until a face beside the edge
  /// changes.
  Flaw look(int h) {
    if (orders_.empty()) return flawOf(h);
    if (orders_[at(h)] == kUnknownOrder) {
      if (const Flaw flaw = noteOrder(h, predicates_); flaw != Flaw::edgeOutOfOrder) return flaw;
    }
    return orders_[at(h)] >= 0 ? Flaw::none : Flaw::edgeOutOfOrder;
  }

  /// Returns whether a ray from the center of the origin of a half-edge goes through its sector, between the rays to
  /// the discs beside it. Returns false if rounding hides whether the sector is almost empty or almost a full turn.
  bool spans(int h, Vector ray) const {
    const int right = dual_.twin[at(h)] / 3;
    const Direction before = predicates_.direction(dual_.origin[at(h)], discs_[at(right)]);
    const Direction after = predicates_.direction(dual_.origin[at(h)], discs_[at(h / 3)]);
    const Vector u = {before.x, before.y};
    const Vector v = {after.x, after.y};
    const int turn = crossOf(before, after).sign();
    if (turn == 0 && dot(u, v) >= 0) return false;
    const bool isAfter = cross(u, ray) >= 0;
    const bool isBefore = cross(ray, v) >= 0;
    return turn < 0 ? isAfter || isBefore : isAfter && isBefore;
  }

  /// Returns whether a face has a disc.
  bool exists(int face) const { return discs_[at(face)].exists; }

  /// Returns the flaw that the discs beside an edge show: vertexWithoutDisc, edgeOutOfOrder, or hullNotClosed for an
  /// edge to infinity whose circle lies strictly within the tangent line of its neighbors on the hull. An edge without
  /// a flaw need not belong to the correct dual. Only all edges together prove it (judge.h).
  Flaw flawOf(int h) const { return flawOf(h, predicates_); }

  /// Returns the flaw of an edge, computed by other predicates on the same circles. Sets `order`, if given, to the
  /// order of the ends of a bounded edge.
  Flaw flawOf(int h, Predicates& predicates, std::int8_t* order = nullptr) const {
    const int t = dual_.twin[at(h)];
    if (!exists(h / 3) || !exists(t / 3)) return Flaw::vertexWithoutDisc;
    const int a = dual_.origin[at(h)];
    const int b = dual_.origin[at(t)];
    const int c = dual_.origin[at(Dual::previous(h))];
    const int d = dual_.origin[at(Dual::previous(t))];
    // Counter-clockwise the hull goes d, a, c or c, b, d.
    if (b == kPointAtInfinity) return flawAtInfinity(d, h, c, predicates);
    if (a == kPointAtInfinity) return flawAtInfinity(c, t, d, predicates);
    if (c == kPointAtInfinity || d == kPointAtInfinity) return Flaw::none;
    const int found = orderOfEnds(dual_, h, discs_, predicates);
    if (order != nullptr) *order = static_cast<std::int8_t>(found);
    return found >= 0 ? Flaw::none : Flaw::edgeOutOfOrder;
  }

 private:
  static constexpr std::size_t kFacesAtATime = 128;

  Flaw noteOrder(int h, Predicates& predicates) {
    std::int8_t order = 1;
    const Flaw flaw = flawOf(h, predicates, &order);
    if (flaw == Flaw::none || flaw == Flaw::edgeOutOfOrder) orders_[at(h)] = orders_[at(dual_.twin[at(h)])] = order;
    return flaw;
  }

  /// Returns the flaw of the edge h from a circle to infinity, between its neighbors on the hull. If one neighbor
  /// occurs on the right hull again between the circle and the other neighbor, the circle may lie within the tangent
  /// line of the two neighbors, but then its own tangent lines are in order.
  Flaw flawAtInfinity(int before, int h, int after, Predicates& predicates) const {
    const int circle = dual_.origin[at(h)];
    if (before == after || predicates.tangentSide(after, before, circle) >= 0) return Flaw::none;
    const int right = dual_.aroundClockwise(h);
    const int turn =
        predicates.turn(circle, cornersOf(dual_, right), discs_[at(right / 3)], cornersOf(dual_, h), discs_[at(h / 3)]);
    return turn < 0 ? Flaw::hullNotClosed : Flaw::none;
  }

  std::span<const Circle> circles_;
  const Dual& dual_;
  Predicates& predicates_;
  std::vector<FaceDisc> discs_;
  std::vector<std::int8_t> orders_;
  std::vector<int> changed_;  ///< the faces that were updated, if there are orders
};

}  // namespace circle_voronoi
