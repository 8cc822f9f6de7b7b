// SPDX-License-Identifier: GPL-3.0-or-later
#include "judge.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "edge_turns.h"
#include "prefetch.h"

namespace circle_voronoi {
namespace {

/// What turnsOf asks of discs.
struct JudgedDiscs {
  const Dual& dual;
  const Predicates& predicates;
  const std::vector<FaceDisc>& discs;
  const std::vector<std::uint8_t>& lower;

  Direction toDisc(int corner) const { return predicates.direction(dual.origin[corner], discs[corner / 3]); }
  bool isLower(int corner) const { return lower[corner] != 0; }
};

class Judge {
 public:
  Judge(std::span<const Circle> circles, const Dual& dual, Predicates& predicates, std::vector<FaceDisc> discs,
        Threads threads)
      : circles_(circles),
        dual_(dual),
        predicates_(predicates),
        threads_(threads),
        circleCount_(static_cast<int>(circles.size())),
        hasDiscs_(!discs.empty()),
        discs_(std::move(discs)) {}

  Verdict run() {
    if (Verdict verdict = checkAdjacency(); !verdict.isRight()) return verdict;
    if (circleCount_ < 2) return {};
    if (Verdict verdict = checkFaces(); !verdict.isRight()) return verdict;
    Verdict verdict = checkWindings();
    if (verdict.isRight()) {
      verdict.ties = std::move(ties_);
      verdict.discs = std::move(discs_);
    }
    return verdict;
  }

 private:
  /// What some of the faces show.
  struct Findings {
    Verdict verdict;
    std::size_t check = std::numeric_limits<std::size_t>::max();  ///< at which the verdict was found: four a face
    int hullTurns = 0;
    std::vector<int> ties;
    std::vector<int> across;  ///< half-edges of these faces whose twins are in a range before
  };

  static bool isFinite(int corner) { return corner != kPointAtInfinity; }

  Verdict checkAdjacency() const {
    const int faceCount = circleCount_ < 2 ? 0 : 2 * circleCount_ - 2;
    if (dual_.faceCount() != faceCount) return {Flaw::eulerCount};
    const std::size_t found = threads_.firstWhere(dual_.origin.size(), [&](std::size_t i) {
      const auto h = static_cast<int>(i);
      const int t = dual_.twin[h];
      return t < 0 || t >= dual_.halfEdgeCount() || dual_.twin[t] != h || t / 3 == h / 3 ||
             dual_.origin[t] != dual_.target(h) || dual_.target(t) != dual_.origin[h] ||
             dual_.origin[h] == dual_.target(h);
    });
    if (found == dual_.origin.size()) return {};
    const auto h = static_cast<int>(found);
    const int t = dual_.twin[h];
    const bool isLoop = t >= 0 && t < dual_.halfEdgeCount() && dual_.twin[t] == h && t / 3 != h / 3 &&
                        dual_.origin[t] == dual_.target(h) && dual_.target(t) == dual_.origin[h];
    return {isLoop ? Flaw::badIndex : Flaw::adjacency, kNone, h / 3, h};
  }

  /// The disc of each face, and each edge once both its faces have one: in the order of the faces, so that the verdict
  /// is about the first that is wrong.
  Verdict checkFaces() {
    isLower_.resize(dual_.origin.size());
    discs_.resize(dual_.origin.size() / 3);
    windings_ = std::vector<std::atomic<int>>(static_cast<std::size_t>(circleCount_));
    std::vector<Findings> findings(threads_.rangesOf(discs_.size()) + 1);
    predicates_.forRanges(threads_, discs_.size(),
                          [&](std::size_t begin, std::size_t end, std::size_t range, Predicates& own) {
                            for (std::size_t face = begin; face < end && findings[range].verdict.isRight(); ++face) {
                              prefetchCircles(face + kPrefetchAhead);
                              checkFace(static_cast<int>(face), static_cast<int>(3 * begin), own, findings[range]);
                            }
                          });
    Findings all = std::move(findings.back());
    for (const Findings& part : findings) {
      if (part.check < all.check) {
        all.verdict = part.verdict;
        all.check = part.check;
      }
    }
    for (const Findings& part : findings) {
      for (const int t : part.across) checkEdge(t, predicates_, all);
      all.hullTurns += part.hullTurns;
      all.ties.insert(all.ties.end(), part.ties.begin(), part.ties.end());
    }
    hullWinding_ = all.hullTurns;
    ties_ = std::move(all.ties);
    // In the order of the faces beyond them.
    if (findings.size() > 2)
      std::sort(ties_.begin(), ties_.end(), [&](int g, int h) { return dual_.twin[g] < dual_.twin[h]; });
    return all.verdict;
  }

  void checkFace(int face, int firstHalfEdge, Predicates& predicates, Findings& found) {
    const int hidden = hiddenCorner(face, predicates);
    if (hidden != kNone || !findDisc(face, predicates)) {
      found.check = 4 * static_cast<std::size_t>(face);
      found.verdict =
          hidden != kNone ? Verdict{Flaw::cellNotClosed, hidden} : Verdict{Flaw::vertexWithoutDisc, kNone, face};
      return;
    }
    for (int t = 3 * face; t < 3 * face + 3; ++t) {
      const int h = dual_.twin[t];
      if (h > t) continue;
      if (h < firstHalfEdge) {
        found.across.push_back(t);
      } else {
        checkEdge(t, predicates, found);
      }
    }
  }

  /// A diagram from outside has its circles in any order. Inlined, as a compiler may take a function that only does
  /// this for idle.
  [[gnu::always_inline]] void prefetchCircles(std::size_t face) const {
    if (face >= discs_.size()) return;
    for (const int i : cornersOf(dual_, static_cast<int>(3 * face))) {
      if (isFinite(i)) prefetch(circles_, i);
    }
  }

  /// A corner of a face that another hides, or kNone. Each edge is looked at once, before the first of its faces gets
  /// its disc.
  int hiddenCorner(int face, Predicates& predicates) const {
    for (int h = 3 * face; h < 3 * face + 3; ++h) {
      if (dual_.twin[h] < h) continue;
      const int a = dual_.origin[h];
      const int b = dual_.target(h);
      if (a == kPointAtInfinity || b == kPointAtInfinity) continue;
      const Circle& one = circles_[a];
      const Circle& other = circles_[b];
      if (isLonger(between(one, other), std::abs(one.r - other.r))) continue;
      if (predicates.contains(one, other)) return b;
      if (predicates.contains(other, one)) return a;
    }
    return kNone;
  }

  bool findDisc(int face, Predicates& predicates) {
    const Predicates::Triple corners = cornersOf(dual_, 3 * face);
    if (!hasDiscs_) discs_[face] = predicates.disc(corners);
    const FaceDisc& disc = discs_[face];
    for (int i = 0; i < 3 && disc.exists; ++i) {
      if (corners[i] == kPointAtInfinity) continue;
      isLower_[3 * face + i] = predicates.isLower(corners[i], corners, predicates.direction(corners[i], disc));
    }
    return disc.exists;
  }

  /// Whether the ends of an edge, given by its second half, are in order, and how often the two regions beside it pass
  /// the axis along it. What comes after the first that is wrong is not looked at.
  void checkEdge(int t, Predicates& predicates, Findings& found) {
    const std::size_t check = 4 * static_cast<std::size_t>(t / 3) + 1 + static_cast<std::size_t>(t % 3);
    if (check > found.check) return;
    const int h = dual_.twin[t];
    const EdgeTurns turns = turnsOf(JudgedDiscs{dual_, predicates, discs_, isLower_}, dual_, circles_, predicates, h);
    if (turns.endOrder < 0) {
      found.verdict = {Flaw::edgeOutOfOrder, kNone, h / 3, h};
      found.check = check;
      return;
    }
    if (turns.endOrder == 0) found.ties.push_back(h);
    noteTurn(dual_.origin[h], dual_.target(h), turns.passesAtOrigin, found);
    noteTurn(dual_.target(h), dual_.origin[h], turns.passesAtTarget, found);
  }

  void noteTurn(int around, int neighbor, bool passes, Findings& found) {
    if (!passes || !isFinite(around)) return;
    windings_[around].fetch_add(1, std::memory_order_relaxed);
    if (!isFinite(neighbor)) ++found.hullTurns;
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
  Threads threads_;
  int circleCount_;
  bool hasDiscs_;                           ///< whether the discs were given
  std::vector<FaceDisc> discs_;             ///< of each face
  std::vector<std::uint8_t> isLower_;       ///< of each half-edge: whether the disc of its face lies in the lower half
  std::vector<std::atomic<int>> windings_;  ///< of each circle: how often its region passes the axis
  int hullWinding_ = 0;
  std::vector<int> ties_;
};

}  // namespace

Verdict judge(std::span<const Circle> circles, const Dual& dual, Predicates& predicates, std::vector<FaceDisc> discs,
              Threads threads) {
  return Judge(circles, dual, predicates, std::move(discs), threads).run();
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
