// SPDX-License-Identifier: GPL-3.0-or-later
#include "judge.h"

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "edge_turns.h"
#include "prefetch.h"

namespace circle_voronoi {
namespace {

class Judge {
 public:
  Judge(std::span<const Circle> circles, const Dual& dual, Predicates& predicates)
      : circles_(circles), dual_(dual), predicates_(predicates), circleCount_(static_cast<int>(circles.size())) {}

  Verdict run() {
    if (Verdict verdict = checkAdjacency(); !verdict.isRight()) return verdict;
    if (circleCount_ < 2) return {};
    if (Verdict verdict = checkFaces(); !verdict.isRight()) return verdict;
    Verdict verdict = checkWindings();
    if (verdict.isRight()) verdict.ties = std::move(ties_);
    return verdict;
  }

  // For turnsOf.
  Direction toDisc(int corner) const { return {toDisc_[corner].x, toDisc_[corner].y, error_[corner / 3]}; }
  bool isLower(int corner) const { return isLower_[corner] != 0; }

 private:
  Predicates::Triple triple(int face) const {
    return {dual_.origin[3 * face], dual_.origin[3 * face + 1], dual_.origin[3 * face + 2]};
  }

  static bool isFinite(int corner) { return corner != kPointAtInfinity; }

  Verdict checkAdjacency() const {
    const int faceCount = circleCount_ < 2 ? 0 : 2 * circleCount_ - 2;
    if (dual_.faceCount() != faceCount) return {Flaw::eulerCount};
    for (int h = 0; h < dual_.halfEdgeCount(); ++h) {
      const int t = dual_.twin[h];
      if (t < 0 || t >= dual_.halfEdgeCount() || dual_.twin[t] != h || t / 3 == h / 3 ||
          dual_.origin[t] != dual_.target(h) || dual_.target(t) != dual_.origin[h]) {
        return {Flaw::adjacency, kNone, h / 3, h};
      }
      if (dual_.origin[h] == dual_.target(h)) return {Flaw::badIndex, kNone, h / 3, h};
    }
    return {};
  }

  /// The disc of each face, and each edge once both its faces have one.
  Verdict checkFaces() {
    toDisc_.resize(dual_.halfEdgeCount());
    isLower_.resize(dual_.halfEdgeCount());
    error_.resize(dual_.faceCount());
    windings_.resize(circleCount_);
    for (int face = 0; face < dual_.faceCount(); ++face) {
      prefetchCircles(face + static_cast<int>(kPrefetchAhead));
      if (Verdict verdict = checkVisibility(face); !verdict.isRight()) return verdict;
      if (!findDisc(face)) return {Flaw::vertexWithoutDisc, kNone, face};
      for (int t = 3 * face; t < 3 * face + 3; ++t) {
        const int h = dual_.twin[t];
        if (h < t && !checkEdge(h)) return {Flaw::edgeOutOfOrder, kNone, h / 3, h};
      }
    }
    return {};
  }

  /// A diagram from outside has its circles in any order. Inlined, as a compiler may take a function that only does
  /// this for idle.
  [[gnu::always_inline]] void prefetchCircles(int face) const {
    if (face >= dual_.faceCount()) return;
    for (const int i : triple(face)) {
      if (isFinite(i)) prefetch(circles_, i);
    }
  }

  /// No corner of a face hides another. Each edge is looked at once, before the first of its faces gets its disc.
  Verdict checkVisibility(int face) {
    for (int h = 3 * face; h < 3 * face + 3; ++h) {
      if (dual_.twin[h] < h) continue;
      const int a = dual_.origin[h];
      const int b = dual_.target(h);
      if (a == kPointAtInfinity || b == kPointAtInfinity) continue;
      const Circle& one = circles_[a];
      const Circle& other = circles_[b];
      if (isLonger(between(one, other), std::abs(one.r - other.r))) continue;
      if (predicates_.contains(one, other)) return {Flaw::cellNotClosed, b};
      if (predicates_.contains(other, one)) return {Flaw::cellNotClosed, a};
    }
    return {};
  }

  bool findDisc(int face) {
    const Predicates::Triple corners = triple(face);
    const FaceDisc disc = predicates_.disc(corners);
    error_[face] = disc.error;
    for (int i = 0; i < 3 && disc.exists; ++i) {
      if (corners[i] == kPointAtInfinity) continue;
      const Direction toDisc = predicates_.direction(corners[i], disc);
      toDisc_[3 * face + i] = {toDisc.x, toDisc.y};
      isLower_[3 * face + i] = predicates_.isLower(corners[i], corners, toDisc);
    }
    return disc.exists;
  }

  /// Whether the ends of an edge are in order; notes how often the two regions beside it pass the axis along it.
  bool checkEdge(int h) {
    const EdgeTurns turns = turnsOf(*this, dual_, circles_, predicates_, h);
    if (turns.endOrder < 0) return false;
    if (turns.endOrder == 0) ties_.push_back(h);
    noteTurn(dual_.origin[h], dual_.target(h), turns.passesAtOrigin);
    noteTurn(dual_.target(h), dual_.origin[h], turns.passesAtTarget);
    return true;
  }

  void noteTurn(int around, int neighbor, bool passes) {
    if (!isFinite(around)) return;
    windings_[around] += passes;
    if (!isFinite(neighbor)) hullWinding_ += passes;
  }

  /// One full turn of every region, and of the hull.
  Verdict checkWindings() const {
    for (int circle = 0; circle < circleCount_; ++circle) {
      if (windings_[circle] != 1) return {Flaw::cellNotClosed, circle};
    }
    if (hullWinding_ != 1) return {Flaw::hullNotClosed};
    return {};
  }

  std::span<const Circle> circles_;
  const Dual& dual_;
  Predicates& predicates_;
  int circleCount_;
  std::vector<Vector> toDisc_;         ///< of each half-edge: from its origin to the disc of its face, of any length
  std::vector<double> error_;          ///< of each face: of the components of the three directions to its disc
  std::vector<std::uint8_t> isLower_;  ///< of each half-edge: whether that direction lies in the lower half
  std::vector<int> windings_;          ///< of each circle: how often its region passes the axis
  int hullWinding_ = 0;
  std::vector<int> ties_;
};

}  // namespace

Verdict judge(std::span<const Circle> circles, const Dual& dual, Predicates& predicates) {
  return Judge(circles, dual, predicates).run();
}

Verdict judgeHidden(std::span<const Circle> circles, std::span<const HiddenCircle> hidden) {
  const auto isIndex = [&](int i) { return i >= 0 && static_cast<std::size_t>(i) < circles.size(); };
  std::vector<std::uint8_t> isHidden(circles.size());
  for (const auto& [circle, by] : hidden) {
    if (!isIndex(circle) || !isIndex(by) || isHidden[circle] != 0) return {Flaw::badIndex, circle};
    isHidden[circle] = 1;
  }
  Predicates predicates(circles);
  for (const auto& [circle, by] : hidden) {
    if (isHidden[by] != 0 || !predicates.contains(circles[by], circles[circle])) {
      return {Flaw::hiddenWithoutHider, circle};
    }
  }
  return {};
}

}  // namespace circle_voronoi
