// SPDX-License-Identifier: GPL-3.0-or-later
#include "judge.h"

#include <vector>

namespace circle_voronoi {
namespace {

class Judge {
 public:
  Judge(std::span<const Circle> circles, const Dual& dual, Predicates& predicates)
      : circles_(circles), dual_(dual), predicates_(predicates), circleCount_(static_cast<int>(circles.size())) {}

  Verdict run() {
    if (Verdict verdict = checkAdjacency(); !verdict.isRight()) return verdict;
    if (circleCount_ < 2) return {};
    if (Verdict verdict = checkDiscs(); !verdict.isRight()) return verdict;
    if (Verdict verdict = checkEdges(); !verdict.isRight()) return verdict;
    if (Verdict verdict = checkTurns(); !verdict.isRight()) return verdict;
    return checkConnected();
  }

 private:
  Predicates::Triple triple(int face) const {
    return {dual_.origin[3 * face], dual_.origin[3 * face + 1], dual_.origin[3 * face + 2]};
  }

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

  Verdict checkDiscs() {
    discs_.reserve(dual_.faceCount());
    quadrants_.resize(dual_.halfEdgeCount());
    for (int face = 0; face < dual_.faceCount(); ++face) {
      const Predicates::Triple corners = triple(face);
      const FaceDisc disc = predicates_.disc(corners);
      if (!disc.exists) return {Flaw::vertexWithoutDisc, kNone, face};
      for (int i = 0; i < 3; ++i) {
        if (corners[i] == kInfinity) continue;
        quadrants_[3 * face + i] = static_cast<signed char>(predicates_.quadrant(corners[i], corners, disc));
      }
      discs_.push_back(disc);
    }
    return {};
  }

  Verdict checkEdges() {
    for (int h = 0; h < dual_.halfEdgeCount(); ++h) {
      const int t = dual_.twin[h];
      if (h < t && isOutOfOrder(h, t)) return {Flaw::edgeOutOfOrder, kNone, h / 3, h};
    }
    return {};
  }

  bool isOutOfOrder(int h, int t) {
    const int a = dual_.origin[h];
    const int b = dual_.origin[t];
    const int c = dual_.origin[Dual::previous(h)];
    const int d = dual_.origin[Dual::previous(t)];
    if (a == kInfinity || b == kInfinity || c == kInfinity || d == kInfinity) return false;
    // Seen from the larger circle the edge spans less than half a turn: from one quadrant into the next it is in order,
    // into the one before it is not, and else the predicate tells.
    const bool fromA = circles_[a].r >= circles_[b].r;
    const int from = fromA ? quadrants_[Dual::next(t)] : quadrants_[Dual::next(h)];
    const int to = fromA ? quadrants_[h] : quadrants_[t];
    const int quarters = (to - from) & 3;
    if (quarters % 2 == 1) return quarters == 3;
    return predicates_.edgeOrder(a, b, c, d, discs_[h / 3], discs_[t / 3]) < 0;
  }

  /// The quarter turns, counted by quadrants entered, from the face of half-edge h to the next face around its origin.
  /// Summed over a closed boundary they are four times its winding number.
  int turn(int h, int next) {
    const int quarters = (quadrants_[next] - quadrants_[h]) & 3;
    if (quarters != 0) return quarters;
    // Within one quadrant: hardly a turn, or nearly a full one. Around the larger circle of a bisector it is under half
    // a turn, as its ends are in order; around the smaller one, or along the hull, the cross product tells.
    const int circle = dual_.origin[h];
    const int across = dual_.target(next);
    if (across != kInfinity && dual_.isFinite(h / 3) && dual_.isFinite(next / 3) &&
        circles_[circle].r >= circles_[across].r) {
      return 0;
    }
    return predicates_.cross(circle, triple(h / 3), discs_[h / 3], triple(next / 3), discs_[next / 3]) < 0 ? 4 : 0;
  }

  Verdict checkTurns() {
    std::vector<int> first(circleCount_, kNone);
    int finiteCorners = 0;
    for (int h = 0; h < dual_.halfEdgeCount(); ++h) {
      const int circle = dual_.origin[h];
      if (circle == kInfinity) continue;
      ++finiteCorners;
      first[circle] = h;
    }

    int hullTurn = 0;
    int corners = 0;
    for (int circle = 0; circle < circleCount_; ++circle) {
      const int start = first[circle];
      if (start == kNone) return {Flaw::cellNotClosed, circle};
      int sum = 0;
      int h = start;
      do {
        const int next = dual_.twin[Dual::previous(h)];
        const int quarters = turn(h, next);
        sum += quarters;
        if (dual_.target(next) == kInfinity) {
          hullTurn += quarters;
        }
        ++corners;
        h = next;
      } while (h != start);
      if (sum != 4) return {Flaw::cellNotClosed, circle};
    }
    // A circle with two cells would leave corners that its one walk does not meet.
    if (corners != finiteCorners) return {Flaw::eulerCount};
    if (hullTurn != 4) return {Flaw::hullNotClosed};
    return {};
  }

  Verdict checkConnected() const {
    std::vector<bool> seen(dual_.faceCount(), false);
    std::vector<int> stack = {0};
    seen[0] = true;
    int reached = 0;
    while (!stack.empty()) {
      const int face = stack.back();
      stack.pop_back();
      ++reached;
      for (int i = 0; i < 3; ++i) {
        const int neighbor = dual_.twin[3 * face + i] / 3;
        if (!seen[neighbor]) {
          seen[neighbor] = true;
          stack.push_back(neighbor);
        }
      }
    }
    if (reached != dual_.faceCount()) return {Flaw::eulerCount};
    return {};
  }

  std::span<const Circle> circles_;
  const Dual& dual_;
  Predicates& predicates_;
  int circleCount_;
  std::vector<FaceDisc> discs_;
  std::vector<signed char> quadrants_;  ///< of each half-edge: of its face, seen from its origin
};

}  // namespace

Verdict judge(std::span<const Circle> circles, const Dual& dual, Predicates& predicates) {
  return Judge(circles, dual, predicates).run();
}

}  // namespace circle_voronoi
