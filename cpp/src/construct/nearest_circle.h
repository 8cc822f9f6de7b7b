// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "circle_voronoi/circle.h"
#include "infinity.h"
#include "vectors.h"

namespace circle_voronoi {

/// The nearest of a growing set of circles, up to rounding: a packed tree of boxes over all that may join, in spatial
/// order.
class NearestCircle {
 public:
  explicit NearestCircle(std::span<const Circle> circles) : circles_(circles) {
    std::size_t size = circles.size();
    do {
      size = (size + kFanOut - 1) / kFanOut;
      levels_.emplace_back(size);
    } while (size > 1);
    isIn_.resize(circles.size());
  }

  void insert(int i) {
    isIn_[i] = 1;
    std::size_t node = static_cast<std::size_t>(i);
    for (std::vector<Box>& level : levels_) level[node /= kFanOut].include(circles_[i]);
  }

  /// The circle of the set with the least distance from a point. There is one.
  int nearest(Point point) {
    best_ = kInfinity;
    least_ = std::numeric_limits<double>::infinity();
    descend(levels_.size() - 1, 0, point);
    return best_;
  }

 private:
  static constexpr std::size_t kFanOut = 8;
  static constexpr double kInfinite = std::numeric_limits<double>::infinity();

  struct Box {
    Point low = {kInfinite, kInfinite};
    Point high = {-kInfinite, -kInfinite};
    double largest = -kInfinite;

    void include(const Circle& c) {
      low = {std::min(low.x, c.x), std::min(low.y, c.y)};
      high = {std::max(high.x, c.x), std::max(high.y, c.y)};
      largest = std::max(largest, c.r);
    }
    /// No circle inside is nearer than this.
    double distance(Point p) const {
      return length({std::max({0.0, low.x - p.x, p.x - high.x}), std::max({0.0, low.y - p.y, p.y - high.y})}) - largest;
    }
  };

  void descend(std::size_t level, std::size_t node, Point point) {
    const std::size_t size = level == 0 ? circles_.size() : levels_[level - 1].size();
    const std::size_t begin = node * kFanOut;
    const std::size_t count = std::min(kFanOut, size - begin);
    if (level == 0) {
      for (std::size_t i = begin; i < begin + count; ++i) {
        if (!isIn_[i]) continue;
        const Circle& c = circles_[i];
        const double distance = length({c.x - point.x, c.y - point.y}) - c.r;
        if (distance < least_) {
          least_ = distance;
          best_ = static_cast<int>(i);
        }
      }
      return;
    }
    // The nearest child first.
    std::pair<double, std::size_t> children[kFanOut];
    for (std::size_t i = 0; i < count; ++i) {
      const Box& box = levels_[level - 1][begin + i];
      std::pair<double, std::size_t> child = {box.largest == -kInfinite ? kInfinite : box.distance(point), begin + i};
      std::size_t place = i;
      for (; place > 0 && child < children[place - 1]; --place) children[place] = children[place - 1];
      children[place] = child;
    }
    for (std::size_t i = 0; i < count && children[i].first < least_; ++i) descend(level - 1, children[i].second, point);
  }

  std::span<const Circle> circles_;
  std::vector<std::vector<Box>> levels_;  ///< from boxes over circles up to one root
  std::vector<char> isIn_;
  int best_ = kInfinity;
  double least_ = kInfinite;
};

}  // namespace circle_voronoi
