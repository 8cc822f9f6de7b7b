// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "dual_keeper.h"
#include "flip.h"
#include "insert_cell.h"
#include "shrink_cell.h"
#include "wrong_faces.h"

namespace circle_voronoi {
namespace {

class Repairer : private DualKeeper {
 public:
  Repairer(Dual& dual, FaceDiscs& discs)
      : dual_(dual),
        discs_(discs),
        edgeOf_(discs.circles().size(), kPointAtInfinity),
        isHidden_(discs.circles().size()),
        shrinker_({dual, discs, edgeOf_, isHidden_, *this}),
        inserter_({dual, discs, edgeOf_, isHidden_, *this}) {
    for (int h = 0; h < dual.halfEdgeCount(); ++h) {
      if (dual.origin[h] != kPointAtInfinity) edgeOf_[dual.origin[h]] = h;
    }
  }

  std::optional<std::int64_t> run(std::vector<int> wrong) {
    std::int64_t count = 0;
    for (int round = 0; round < kMostRounds && !wrong.empty(); ++round) {
      const std::vector<int> circles = cornersOf(dual_, wrong);
      count += static_cast<std::int64_t>(circles.size());
      if (!putAnew(circles)) return std::nullopt;
      wrong = flipChanged();
    }
    return count;
  }

 private:
  /// After these there is but a spot in many where more help.
  static constexpr int kMostRounds = 4;

  static constexpr std::size_t kMostAround = 256;
  static constexpr int kManyEdges = 64;

  struct Taken {
    int circle;
    int neighbor;
  };

  /// Whether all went well.
  bool putAnew(std::vector<int> circles) {
    // What is wrong about a circle with many neighbors comes right with those beside the spot.
    std::erase_if(circles, [&](int circle) { return hasManyEdges(circle); });
    if (circles.empty()) return false;
    std::vector<Taken> taken;
    // One may be in the way of another: that one goes once this one is gone.
    while (!circles.empty()) {
      const std::size_t before = circles.size();
      if (taken.size() + before + 2 > edgeOf_.size()) return false;  // two have to stay
      std::erase_if(circles, [&](int circle) {
        const int neighbor = neighborOf(circle);
        if (!shrinker_.takeOut(circle)) return false;
        taken.push_back({circle, neighbor});
        return true;
      });
      if (circles.size() == before && !addNeighbors(circles)) return false;
    }
    // The last one first: when it was taken out its neighbor stayed, or is there again.
    for (; !taken.empty(); taken.pop_back()) {
      const auto [circle, neighbor] = taken.back();
      if (inserter_.insert(circle, edgeOf_[neighbor]) != CellInserter::Outcome::inserted) return false;
    }
    return true;
  }

  bool hasManyEdges(int circle) const {
    int count = 0;
    int h = edgeOf_[circle];
    do {
      h = dual_.twin[Dual::previous(h)];
    } while (h != edgeOf_[circle] && ++count < kManyEdges);
    return count == kManyEdges;
  }

  /// Adds the neighbors of circles. Whether there are others, and not too many.
  bool addNeighbors(std::vector<int>& circles) const {
    std::vector<int> all = circles;
    for (const int circle : circles) {
      const int first = edgeOf_[circle];
      int h = first;
      do {
        if (dual_.target(h) != kPointAtInfinity) all.push_back(dual_.target(h));
        h = dual_.twin[Dual::previous(h)];
      } while (h != first);
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    std::swap(all, circles);
    return circles.size() > all.size() && circles.size() < kMostAround;
  }

  /// Flips what is wrong among the faces that have changed, and returns those that stay so.
  std::vector<int> flipChanged() {
    std::vector<int> edges;
    for (const int face : changed_) edges.insert(edges.end(), {3 * face, 3 * face + 1, 3 * face + 2});
    std::vector<int> wrong = flipFrom(dual_, discs_, edges, *this).wrong;
    for (const int face : changed_) {
      for (int h = 3 * face; h < 3 * face + 3; ++h) {
        if (dual_.origin[h] != kPointAtInfinity) edgeOf_[dual_.origin[h]] = h;
      }
    }
    changed_.clear();
    return wrong;
  }

  int neighborOf(int circle) const {
    const int h = edgeOf_[circle];
    const int neighbor = dual_.target(h);
    return neighbor != kPointAtInfinity ? neighbor : dual_.target(dual_.twin[Dual::previous(h)]);
  }

  // Each circle that goes leaves the two faces that it takes when it comes again.
  int addFace() override {
    const int face = places_.back();
    places_.pop_back();
    changed_.push_back(face);
    return face;
  }
  void removeFace(int face) override { places_.push_back(face); }
  void willChange(int face) override { changed_.push_back(face); }
  void willHide(int) override {}
  void replaceEdge(int, int) override {}
  void dropEdge(int) override {}

  Dual& dual_;
  FaceDiscs& discs_;
  std::vector<int> edgeOf_;  ///< of each circle in the dual a half-edge that starts from it
  std::vector<char> isHidden_;
  CellShrinker shrinker_;
  CellInserter inserter_;
  std::vector<int> places_;   ///< of faces that are not in use
  std::vector<int> changed_;  ///< faces that have changed in a round
};

}  // namespace

std::optional<std::int64_t> repair(Dual& dual, FaceDiscs& discs, std::vector<int> wrong) {
  return Repairer(dual, discs).run(std::move(wrong));
}

}  // namespace circle_voronoi
