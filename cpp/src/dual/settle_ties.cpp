// SPDX-License-Identifier: GPL-3.0-or-later
#include "settle_ties.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "at.h"

namespace circle_voronoi {
namespace {

/// Returns whether the center of one circle is less than that of another, by x and then y. Circles with cells have
/// different centers.
bool isLess(std::span<const Circle> circles, int i, int j) {
  const Circle& a = circles[at(i)];
  const Circle& b = circles[at(j)];
  return std::pair(a.x, a.y) < std::pair(b.x, b.y);
}

class TieSettler {
 public:
  TieSettler(Dual& dual, std::span<const int> ties, std::span<const Circle> circles)
      : dual_(dual), ties_(ties), circles_(circles) {}

  std::vector<int> run() && {
    const auto isWrong = [&](int h) { return !isSettled(h); };
    const auto first = std::find_if(ties_.begin(), ties_.end(), isWrong);
    if (first == ties_.end()) return {};
    isTie_.assign(dual_.origin.size(), false);
    for (const int h : ties_) isTie_[at(h)] = isTie_[at(dual_.twin[at(h)])] = true;
    // The ties of a polygon that has been settled are no longer marked.
    for (const int h : ties_) {
      if (isTie_[at(h)] && isWrong(h)) settlePolygonOf(h);
    }
    return std::move(changed_);
  }

 private:
  bool isLess(int i, int j) const { return circle_voronoi::isLess(circles_, i, j); }
  bool isSettled(int h) const { return isSettledTie(dual_, h, circles_); }

  /// A side of the polygon: its corner, and the half-edge beyond the side from there to the next corner.
  struct Side {
    int corner;
    int beyond;
  };

  void settlePolygonOf(int tie) {
    collect(tie);
    changed_.insert(changed_.end(), faces_.begin(), faces_.end());
    // From the greatest corner to the third least each gets a face with the corners beside it, and leaves.
    std::vector<std::size_t> order(sides_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return isLess(sides_[j].corner, sides_[i].corner); });
    std::vector<std::size_t> before(sides_.size());
    std::vector<std::size_t> after(sides_.size());
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      after[i] = i + 1 < sides_.size() ? i + 1 : 0;
      before[after[i]] = i;
    }
    for (std::size_t k = 0; k < faces_.size(); ++k) {
      const std::size_t middle = order[k];
      const std::size_t from = before[middle];
      const std::size_t to = after[middle];
      const int h = 3 * faces_[k];
      set(h, sides_[from].corner, sides_[from].beyond);
      set(h + 1, sides_[middle].corner, sides_[middle].beyond);
      if (k + 1 == faces_.size()) {
        set(h + 2, sides_[to].corner, sides_[to].beyond);
      } else {
        dual_.origin[at(h + 2)] = sides_[to].corner;  // its twin comes with the face beyond
        sides_[from].beyond = h + 2;
        after[from] = to;
        before[to] = from;
      }
    }
  }

  void set(int h, int corner, int twin) {
    dual_.origin[at(h)] = corner;
    dual_.twin[at(h)] = twin;
    dual_.twin[at(twin)] = h;
  }

  /// The faces of the disc at a tie, and its sides, counter-clockwise. Its ties are no longer marked.
  ///
  /// The way along the sides and across the ties passes each half-edge of the polygon once.
  void collect(int tie) {
    sides_.clear();
    faces_.clear();
    int h = tie;
    do {
      if (h % 3 == 0) faces_.push_back(h / 3);
      const int twin = dual_.twin[at(h)];
      if (isTie_[at(h)]) {
        isTie_[at(h)] = false;
        h = Dual::next(twin);
      } else {
        sides_.push_back({dual_.origin[at(h)], twin});
        h = Dual::next(h);
      }
    } while (h != tie);
  }

  Dual& dual_;
  std::span<const int> ties_;
  std::span<const Circle> circles_;
  std::vector<bool> isTie_;  ///< of each half-edge
  std::vector<int> faces_;
  std::vector<Side> sides_;
  std::vector<int> changed_;
};

}  // namespace

std::vector<int> settleTies(Dual& dual, std::span<const int> ties, std::span<const Circle> circles) {
  return TieSettler(dual, ties, circles).run();
}

void settleTies(Dual& dual, Verdict& verdict, std::span<const Circle> circles, Predicates& predicates) {
  const std::vector<int> changed = settleTies(dual, verdict.ties, circles);
  Proof& proof = verdict.proof;
  Prover prover(dual, circles, predicates, proof.discs, proof.halfEdges);
  for (const int face : changed) {
    proof.discs[at(face)] = predicates.disc(cornersOf(dual, 3 * face));
    prover.proveFace(face);
  }
  for (const int face : changed) {
    for (int h = 3 * face; h < 3 * face + 3; ++h) prover.proveEdge(h);
  }
}

bool isSettledTie(const Dual& dual, int h, std::span<const Circle> circles) {
  const int t = dual.twin[at(h)];
  const auto less = [&](int i, int j) { return isLess(circles, i, j); };
  const int endOfBoth = std::max(dual.origin[at(h)], dual.origin[at(t)], less);
  const int beside = std::max(dual.origin[at(Dual::previous(h))], dual.origin[at(Dual::previous(t))], less);
  return isLess(circles, endOfBoth, beside);
}

}  // namespace circle_voronoi
