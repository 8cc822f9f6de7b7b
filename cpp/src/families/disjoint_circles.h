// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "circle_voronoi/circle.h"
#include "vectors.h"

namespace circle_voronoi {

/// A growing set of disjoint circles that come largest first, or of sizes within a factor of eight.
///
/// A hierarchy of hashed grids, one for each factor of eight in radius. A cell is as wide as the largest circles of its
/// grid. So a circle meets only circles in the nine cells around its center, in its own grid and each coarser one.
class DisjointCircles {
 public:
  /// `count` circles are expected; those smaller than `finest` go into the grid of circles of that radius.
  explicit DisjointCircles(std::size_t count, double finest = 0);

  /// Adds a circle, unless it meets one of the set.
  bool insert(const Circle& circle);

  /// The distance of a point from the nearest circle, capped at `limit`, which must not exceed `finest`; negative
  /// inside.
  double room(Point point, double limit) const;

  std::vector<Circle> take() && { return std::move(circles_); }
  std::size_t size() const { return circles_.size(); }

 private:
  int levelOf(double radius) const;
  std::size_t bucket(int level, std::int64_t column, std::int64_t row) const;
  template <class Visit>
  void visitNear(Point point, double radius, Visit visit) const;

  double finest_;
  std::vector<Circle> circles_;
  std::vector<int> next_;   ///< the next circle in the same bucket
  std::vector<int> first_;  ///< of each bucket; cells may share one, which costs time only
  std::vector<int> levels_;
};

}  // namespace circle_voronoi
