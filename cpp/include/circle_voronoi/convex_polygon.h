// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/box.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/limits.h"
#include "circle_voronoi/point.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

/// A closed convex polygon, of which a Region can be made. Its coordinates are rounded to multiples of 2^-96, like all
/// numbers (compute.h).
class ConvexPolygon {
 public:
  /// Makes a polygon from a box.
  /// Errors: badOption if the box is empty, or a coordinate is not finite or exceeds kRegionLimit.
  static Result<ConvexPolygon> from(const Box& box);
  /// Makes a polygon from its corners in counter-clockwise order. A corner may lie on the line through its neighbors.
  /// Errors: badOption if there are fewer than three corners, a coordinate is not finite or exceeds kRegionLimit, two
  /// consecutive corners are equal, or the corners do not turn left exactly once.
  static Result<ConvexPolygon> from(std::span<const Point> corners);

  /// Returns the corners, counter-clockwise. The polygon must outlive them.
  [[nodiscard]] std::span<const Point> corners() const { return corners_; }
  [[nodiscard]] std::size_t size() const { return corners_.size(); }
  /// Returns the corner where side `k` ends. Side `k` begins at corner `k`.
  [[nodiscard]] Point cornerAfter(std::size_t k) const { return corners_[k + 1 == corners_.size() ? 0 : k + 1]; }

  [[nodiscard]] bool contains(Point p) const;
  [[nodiscard]] double area() const;
  /// Returns the mean of the corners, which lies inside.
  [[nodiscard]] Point middle() const;

 private:
  explicit ConvexPolygon(std::vector<Point> corners) : corners_(std::move(corners)) {}

  std::vector<Point> corners_;
};

}  // namespace circle_voronoi
