// SPDX-License-Identifier: GPL-3.0-or-later
#include "hiders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>

#include "circle_voronoi/index.h"
#include "infinity.h"
#include "predicates.h"
#include "vectors.h"

namespace circle_voronoi {
namespace {

constexpr std::size_t kFanOut = 8;

/// A box around centers, and the range of their radii.
struct BoxOfCircles {
  Point low = {kInfinite, kInfinite};
  Point high = {-kInfinite, -kInfinite};
  double smallest = kInfinite;
  double largest = -kInfinite;

  void include(const BoxOfCircles& other) {
    low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y)};
    high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y)};
    smallest = std::min(smallest, other.smallest);
    largest = std::max(largest, other.largest);
  }

  static BoxOfCircles of(const Circle& c) { return {{c.x, c.y}, {c.x, c.y}, c.r, c.r}; }

  /// Returns whether a circle of this box may contain one of the other box. The result is false only if none does,
  /// rounding included.
  bool mayHide(const BoxOfCircles& other) const {
    const double reach = largest - other.smallest;
    if (reach < 0) return false;
    const double x = std::max({0.0, low.x - other.high.x, other.low.x - high.x});
    const double y = std::max({0.0, low.y - other.high.y, other.low.y - high.y});
    return !isLonger({x, y}, reach);
  }
};

/// The growth of circles along a direction. A circle that hides circle c reaches at least as far against any direction:
/// r - u . center >= c.r - u . c.center for any unit vector u. With the direction in which the circles grow, this
/// decides where a box does not: if most circles almost hide one another, as circles do that touch one common circle.
class Slope {
 public:
  Slope() = default;

  explicit Slope(std::span<const Circle> circles) {
    const auto [smallest, largest] =
        std::minmax_element(circles.begin(), circles.end(), [](const Circle& a, const Circle& b) { return a.r < b.r; });
    origin_ = {largest->x, largest->y};
    const Vector v = between(*smallest, *largest);
    const double l = length(v);
    if (l > 0) u_ = {v.x / l, v.y / l};
    for (const Circle& c : circles) most_ = std::max(most_, reach(c));
  }

  /// Returns whether one of the circles may contain c. The result is false only if none does, rounding included.
  bool mayHide(const Circle& c) const {
    const double size = std::abs(c.r) + std::abs(c.x - origin_.x) + std::abs(c.y - origin_.y) + std::abs(most_);
    return reach(c) <= most_ + 1e-14 * size;
  }

 private:
  double reach(const Circle& c) const { return c.r - (u_.x * (c.x - origin_.x) + u_.y * (c.y - origin_.y)); }

  Point origin_;
  Vector u_;
  double most_ = -kInfinite;
};

/// The precedence of a circle as a hider: larger circles come first, and of equal circles the one with the lower index.
/// A circle that contains another comes before it, so the first one that contains a given circle is visible.
struct Rank {
  double r = 0;
  int index = 0;

  bool isBefore(const Rank& other) const { return r != other.r ? r > other.r : index < other.index; }
};

Rank rankOf(NumberedCircles circles, std::size_t i) { return {circles.circles[i].r, circles.indices[i]}; }

/// A tree of boxes, with circles as its leaves.
class BoxTree {
 public:
  /// A circle, or a box over kFanOut nodes of the level below.
  struct Node {
    BoxOfCircles box;
    Slope slope;
    Rank first;                                      ///< the rank of the first of its circles
    std::array<std::uint8_t, kFanOut> childOrder{};  ///< its children, sorted by `first`
  };

  BoxTree(NumberedCircles circles, Threads threads) {
    const std::size_t count = circles.circles.size();
    std::vector<Node> below(count);
    threads.forEach(count, [&](std::size_t i) {
      below[i] = {BoxOfCircles::of(circles.circles[i]), {}, rankOf(circles, i), {}};
    });
    std::size_t width = 1;
    do {
      width *= kFanOut;
      std::vector<Node> level((below.size() + kFanOut - 1) / kFanOut);
      threads.forEach(level.size(), [&](std::size_t i) {
        level[i] = over(below, i);
        level[i].slope = Slope(circles.circles.subspan(i * width, std::min(width, count - i * width)));
      });
      levels_.push_back(std::move(below));
      below = std::move(level);
    } while (below.size() > 1);
    levels_.push_back(std::move(below));
  }

  /// Returns the levels of the tree, from the circles up to one root.
  const std::vector<std::vector<Node>>& levels() const { return levels_; }

 private:
  static Node over(const std::vector<Node>& below, std::size_t index) {
    const std::size_t begin = index * kFanOut;
    const std::size_t count = std::min(below.size() - begin, kFanOut);
    Node node;
    for (std::size_t child = 0; child < count; ++child) {
      const Node& added = below[begin + child];
      node.box.include(added.box);
      std::size_t place = child;
      for (; place > 0 && added.first.isBefore(below[begin + node.childOrder[place - 1]].first); --place) {
        node.childOrder[place] = node.childOrder[place - 1];
      }
      node.childOrder[place] = static_cast<std::uint8_t>(child);
    }
    node.first = below[begin + node.childOrder[0]].first;
    return node;
  }

  std::vector<std::vector<Node>> levels_;
};

/// Searches a tree for the hiders of some circles.
class Search {
 public:
  Search(NumberedCircles circles, NumberedCircles inner, const BoxTree& tree, std::vector<int>& hider)
      : circles_(circles), inner_(inner), predicates_(circles.circles), levels_(tree.levels()), hider_(hider) {}

  /// Finds the hiders of the inner circles from `begin` to before `end`, unless it takes more than `limit` steps.
  /// Returns the number of steps.
  std::int64_t find(std::size_t begin, std::size_t end, std::int64_t limit) && {
    for (first_ = begin; first_ < end && steps_ <= limit; first_ = last_) {
      last_ = std::min(first_ + kFanOut, end);
      query_ = {};
      for (std::size_t j = first_; j < last_; ++j) query_.include(BoxOfCircles::of(inner_.circles[j]));
      noteLastBound();
      descend(levels_.size() - 1, 0);
    }
    return steps_;
  }

 private:
  using Node = BoxTree::Node;

  /// Returns the rank before which a circle must come to be a better hider of inner circle j.
  Rank bound(std::size_t j) const {
    return hider_[j] == kNone ? rankOf(inner_, j) : rankOf(circles_, static_cast<std::size_t>(hider_[j]));
  }

  void noteLastBound() {
    lastBound_ = bound(first_);
    for (std::size_t j = first_ + 1; j < last_; ++j) {
      if (lastBound_.isBefore(bound(j))) lastBound_ = bound(j);
    }
  }

  void descend(std::size_t level, std::size_t index) {
    const Node& node = levels_[level][index];
    const std::size_t begin = index * kFanOut;
    const std::size_t count = std::min(levels_[level - 1].size() - begin, kFanOut);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t child = begin + node.childOrder[i];
      const Node& below = levels_[level - 1][child];
      if (!below.first.isBefore(lastBound_)) return;
      ++steps_;
      if (!below.box.mayHide(query_) || (level > 1 && !mayHide(below.slope))) continue;
      if (level == 1) {
        tryHider(child);
      } else {
        descend(level - 1, child);
      }
    }
  }

  bool mayHide(const Slope& slope) const {
    const auto query = inner_.circles.subspan(first_, last_ - first_);
    return std::any_of(query.begin(), query.end(), [&](const Circle& c) { return slope.mayHide(c); });
  }

  void tryHider(std::size_t i) {
    const Circle& outer = circles_.circles[i];
    bool hides = false;
    for (std::size_t j = first_; j < last_; ++j) {
      // A circle does not come before itself.
      if (!rankOf(circles_, i).isBefore(bound(j))) continue;
      const Circle& c = inner_.circles[j];
      if (isLonger(between(outer, c), outer.r - c.r) || !predicates_.contains(outer, c)) continue;
      hider_[j] = static_cast<int>(i);
      hides = true;
    }
    if (hides) noteLastBound();
  }

  NumberedCircles circles_;
  NumberedCircles inner_;
  Predicates predicates_;
  const std::vector<std::vector<Node>>& levels_;
  std::vector<int>& hider_;
  std::int64_t steps_ = 0;
  // The query: the inner circles from first_ to before last_, their box, and the last of their bounds.
  std::size_t first_ = 0;
  std::size_t last_ = 0;
  BoxOfCircles query_;
  Rank lastBound_;
};

}  // namespace

Hiders findHiders(NumberedCircles circles, NumberedCircles inner, std::int64_t limit, Threads threads) {
  const std::size_t count = inner.circles.size();
  std::vector<int> hider(count, kNone);
  if (circles.circles.empty()) return {std::move(hider), 0};
  const BoxTree tree(circles, threads);
  // Ranges consist of whole groups, so that the number of steps does not depend on the threads.
  const std::size_t groups = (count + kFanOut - 1) / kFanOut;
  std::vector<std::int64_t> steps(threads.rangesOf(groups));
  threads.forRanges(groups, [&](std::size_t begin, std::size_t end, std::size_t range) {
    steps[range] = Search(circles, inner, tree, hider).find(begin * kFanOut, std::min(end * kFanOut, count), limit);
  });
  const std::int64_t all = std::accumulate(steps.begin(), steps.end(), std::int64_t{0});
  if (all > limit) return {{}, limit};
  return {std::move(hider), all};
}

}  // namespace circle_voronoi
