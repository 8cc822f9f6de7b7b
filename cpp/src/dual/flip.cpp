// SPDX-License-Identifier: GPL-3.0-or-later
#include "flip.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "at.h"
#include "edge_order.h"
#include "homogeneous_disc.h"
#include "settle_ties.h"
#include "wrong_faces.h"

namespace circle_voronoi {
namespace {

class Flipper {
 public:
  Flipper(Dual& dual, FaceDiscs& discs, FaceWatcher* watcher)
      : circles_(discs.circles()), dual_(dual), discs_(discs), predicates_(discs.predicates()), watcher_(watcher) {}

  Flips run() {
    // The limit is about four flips per circle. No family of circles needs more than slightly over three. A diagram
    // that exceeds the limit is left to insertion.
    const std::int64_t limit = 1000 + 2 * static_cast<std::int64_t>(dual_.faceCount());
    for (int first = 0; first < dual_.halfEdgeCount(); ++first) {
      if (discs_.isKnownRight(first) || first > dual_.twin[at(first)] || discs_.look(first) == Flaw::none) continue;
      stack_.push_back(first);
      settle(limit);
      if (flips_ == limit) return {flips_, wrongFaces(discs_)};
    }
    return {flips_, wrongFaces(discs_, left_)};
  }

  Flips runFrom(std::span<const int> edges) {
    const std::int64_t limit = 100 + 4 * static_cast<std::int64_t>(edges.size());
    stack_.assign(edges.begin(), edges.end());
    settle(limit);
    left_.insert(left_.end(), stack_.begin(), stack_.end());
    return {flips_, wrongFaces(discs_, left_)};
  }

  void runTies(std::span<const int> ties) {
    stack_.assign(ties.begin(), ties.end());
    while (!stack_.empty()) {
      const int h = stack_.back();
      stack_.pop_back();
      if (isTie(h) && !isSettledTie(dual_, h, circles_)) flipEdge(h);
    }
  }

 private:
  bool isTie(int h) const {
    const int t = dual_.twin[at(h)];
    if (!dual_.isFinite(h / 3) || !dual_.isFinite(t / 3)) return false;
    return orderOfEnds(dual_, h, discs_, predicates_) == 0;
  }

  /// The ends of an edge and the two opposite corners.
  using Quad = std::array<int, 4>;

  /// Flips edges until no edge on the stack needs a flip. Each wrong edge is on the stack, in `left_`, or still to come
  /// in `run`, because an edge changes only with its faces.
  void settle(std::int64_t limit) {
    // A cycle of flips reaches a milestone again if milestones are set ever more rarely (R. P. Brent, "An improved
    // Monte Carlo factorization algorithm", 1980).
    Quad milestone = {};
    const std::int64_t start = flips_;
    std::int64_t next = 0;
    while (!stack_.empty()) {
      const int h = stack_.back();
      stack_.pop_back();
      const Flaw flaw = discs_.look(h);
      if (flaw == Flaw::none) continue;
      const auto [a, b, c] = cornersOf(dual_, h);
      const Quad quad = {a, b, c, dual_.origin[at(Dual::previous(dual_.twin[at(h)]))]};
      if (!isToFlip(h, quad, flaw) || quad == milestone) {
        left_.push_back(h);
        continue;
      }
      if (flips_ == limit) {
        stack_.push_back(h);
        return;
      }
      if (flips_ - start == next) {
        milestone = quad;
        next = 2 * next + 1;
      }
      flipEdge(h);
      ++flips_;
    }
  }

  /// Returns whether an edge with a flaw should be flipped, because the edge across may be better.
  bool isToFlip(int h, const Quad& quad, Flaw flaw) const {
    const int t = dual_.twin[at(h)];
    const auto [a, b, c, d] = quad;
    if (c == d) return false;  // the flipped edge would be a loop
    if (flaw == Flaw::vertexWithoutDisc) {
      return (!discs_.exists(h / 3) && isTopOf(a, b, c) && predicates_.tangentSide(b, a, c) >= 0) ||
             (!discs_.exists(t / 3) && isTopOf(b, a, d) && predicates_.tangentSide(a, b, d) >= 0);
    }
    // A circle that leaves the hull gets a vertex with its neighbors there.
    if (b == kPointAtInfinity) return predicates_.disc({a, d, c}).exists;
    if (a == kPointAtInfinity) return predicates_.disc({b, c, d}).exists;
    return true;
  }

  /// Returns whether of three circles a and b have the longest common tangents. Where a disc is lost, its circles come
  /// to lie along one tangent line, and c, in the middle, crosses that of a and b.
  bool isTopOf(int a, int b, int c) const {
    const auto square = [this](int i, int j) {
      const Difference d(circles_[at(i)], circles_[at(j)]);
      return lorentzDot(d, d);
    };
    return square(a, b) >= std::max(square(b, c), square(c, a));
  }

  void flipEdge(int h) {
    const int t = dual_.twin[at(h)];
    if (watcher_ != nullptr) {
      for (const int changed : {h, t, dual_.twin[at(Dual::next(t))], dual_.twin[at(Dual::next(h))]}) {
        watcher_->willChange(changed / 3);
      }
    }
    dual_.flip(h);
    discs_.update(h / 3);
    discs_.update(t / 3);
    for (const int changed : {Dual::next(h), h, Dual::previous(h), t, Dual::previous(t)}) {
      stack_.push_back(changed);
    }
  }

  std::span<const Circle> circles_;
  Dual& dual_;
  FaceDiscs& discs_;
  Predicates& predicates_;
  FaceWatcher* watcher_;
  std::int64_t flips_ = 0;
  std::vector<int> stack_;
  std::vector<int> left_;  ///< edges that were wrong, but not to be flipped
};

}  // namespace

Flips flip(Dual& dual, FaceDiscs& discs, FaceWatcher* watcher) { return Flipper(dual, discs, watcher).run(); }

Flips flipFrom(Dual& dual, FaceDiscs& discs, std::span<const int> edges, FaceWatcher& watcher) {
  return Flipper(dual, discs, &watcher).runFrom(edges);
}

void flipTies(Dual& dual, FaceDiscs& discs, std::span<const int> ties, FaceWatcher& watcher) {
  Flipper(dual, discs, &watcher).runTies(ties);
}

}  // namespace circle_voronoi
