// SPDX-License-Identifier: GPL-3.0-or-later
#include "hiders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>

#include "circle_voronoi/none.h"
#include "predicates.h"
#include "vectors.h"

namespace circle_voronoi {
namespace {

constexpr int kFanOut = 8;
constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// A box around centres, and the range of their radii.
struct Box {
  Point low = {kInfinite, kInfinite};
  Point high = {-kInfinite, -kInfinite};
  double smallest = kInfinite;
  double largest = -kInfinite;

  void include(const Box& other) {
    low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y)};
    high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y)};
    smallest = std::min(smallest, other.smallest);
    largest = std::max(largest, other.largest);
  }

  static Box of(const Circle& c) { return {{c.x, c.y}, {c.x, c.y}, c.r, c.r}; }

  /// Whether a circle of this box may contain one of the other: false only if none does, rounding included.
  bool mayHide(const Box& other) const {
    const double reach = largest - other.smallest;
    if (reach < 0) return false;
    const double x = std::max({0.0, low.x - other.high.x, other.low.x - high.x});
    const double y = std::max({0.0, low.y - other.high.y, other.low.y - high.y});
    return x * x + y * y <= reach * reach * (1 + 1e-12);
  }
};

/// How fast circles grow along a direction. One that hides circle c reaches at least as far against the direction:
/// r - u . centre >= c.r - u . c.centre for any unit vector u. With the one along which they grow this decides where a
/// box does not: where most nearly hide one another, as those do that are tangent to one circle.
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

  /// Whether one of the circles may contain c: false only if none does, rounding included.
  bool mayHide(const Circle& c) const {
    const double size = c.r + std::abs(c.x - origin_.x) + std::abs(c.y - origin_.y) + std::abs(most_);
    return reach(c) <= most_ + 1e-14 * size;
  }

 private:
  double reach(const Circle& c) const { return c.r - (u_.x * (c.x - origin_.x) + u_.y * (c.y - origin_.y)); }

  Point origin_;
  Vector u_;
  double most_ = -kInfinite;
};

class Hiders {
 public:
  Hiders(std::span<const Circle> circles, std::span<const int> indices)
      : circles_(circles), indices_(indices), predicates_(circles), hider_(circles.size(), kNone) {
    std::vector<Node> below(circles.size());
    for (int i = 0; i < static_cast<int>(circles.size()); ++i) below[i] = {Box::of(circles[i]), {}, i};
    std::size_t width = 1;
    do {
      width *= kFanOut;
      std::vector<Node> level((below.size() + kFanOut - 1) / kFanOut);
      for (std::size_t i = 0; i < level.size(); ++i) {
        level[i] = over(below, i);
        level[i].slope = Slope(circles.subspan(i * width, std::min(width, circles.size() - i * width)));
      }
      levels_.push_back(std::move(below));
      below = std::move(level);
    } while (below.size() > 1);
    levels_.push_back(std::move(below));
  }

  std::vector<int> find() && {
    for (std::size_t leaf = 0; leaf < levels_[1].size(); ++leaf) {
      std::tie(first_, last_) = children(1, leaf);
      query_ = levels_[1][leaf].box;
      noteLastBound();
      descend(levels_.size() - 1, 0);
    }
    return std::move(hider_);
  }

 private:
  /// A circle, or a box over kFanOut nodes of the level below.
  struct Node {
    Box box;
    Slope slope;
    int first = kNone;                          ///< of its circles the one that comes before all others
    std::array<std::uint8_t, kFanOut> order{};  ///< its children, each before those whose first comes after its own
  };

  /// Whether a circle hides before another: the larger one, of equal ones the one with the lower index. One that
  /// contains another comes before it, so the first that contains a circle is visible.
  bool isBefore(int i, int j) const {
    return circles_[i].r != circles_[j].r ? circles_[i].r > circles_[j].r : indices_[i] < indices_[j];
  }

  Node over(const std::vector<Node>& below, std::size_t index) const {
    const std::size_t begin = index * kFanOut;
    const std::size_t count = std::min<std::size_t>(below.size() - begin, kFanOut);
    Node node;
    for (std::size_t child = 0; child < count; ++child) {
      const Node& added = below[begin + child];
      node.box.include(added.box);
      std::size_t place = child;
      for (; place > 0 && isBefore(added.first, below[begin + node.order[place - 1]].first); --place) {
        node.order[place] = node.order[place - 1];
      }
      node.order[place] = static_cast<std::uint8_t>(child);
    }
    node.first = below[begin + node.order[0]].first;
    return node;
  }

  std::pair<int, int> children(std::size_t level, std::size_t node) const {
    return {static_cast<int>(node * kFanOut),
            static_cast<int>(std::min((node + 1) * kFanOut, levels_[level - 1].size()))};
  }

  /// What must come before a circle to hide it and be named.
  int bound(int j) const { return hider_[j] == kNone ? j : hider_[j]; }

  void noteLastBound() {
    lastBound_ = bound(first_);
    for (int j = first_ + 1; j < last_; ++j) {
      if (isBefore(lastBound_, bound(j))) lastBound_ = bound(j);
    }
  }

  void descend(std::size_t level, std::size_t index) {
    const Node& node = levels_[level][index];
    const auto [begin, end] = children(level, index);
    for (int i = 0; i < end - begin; ++i) {
      const int child = begin + node.order[i];
      const Node& below = levels_[level - 1][child];
      if (!isBefore(below.first, lastBound_)) return;
      if (!below.box.mayHide(query_) || (level > 1 && !mayHide(below.slope))) continue;
      if (level == 1) {
        tryHider(child);
      } else {
        descend(level - 1, child);
      }
    }
  }

  bool mayHide(const Slope& slope) const {
    const auto query = circles_.subspan(first_, static_cast<std::size_t>(last_ - first_));
    return std::any_of(query.begin(), query.end(), [&](const Circle& c) { return slope.mayHide(c); });
  }

  void tryHider(int i) {
    bool hides = false;
    for (int j = first_; j < last_; ++j) {
      if (i == j || !isBefore(i, bound(j))) continue;
      const Vector v = between(circles_[i], circles_[j]);
      const double slack = circles_[i].r - circles_[j].r;
      if (dot(v, v) > slack * slack * (1 + 1e-12) || !predicates_.contains(circles_[i], circles_[j])) continue;
      hider_[j] = i;
      hides = true;
    }
    if (hides) noteLastBound();
  }

  std::span<const Circle> circles_;
  std::span<const int> indices_;
  Predicates predicates_;
  std::vector<int> hider_;
  std::vector<std::vector<Node>> levels_;  ///< from the circles up to one root
  // The query: the circles from first_ to before last_, their box, and of their bounds the one that comes last.
  int first_ = 0;
  int last_ = 0;
  Box query_;
  int lastBound_ = 0;
};

}  // namespace

std::vector<int> findHiders(std::span<const Circle> circles, std::span<const int> indices) {
  if (circles.empty()) return {};
  return Hiders(circles, indices).find();
}

}  // namespace circle_voronoi
