// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/point.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

/// An axis-parallel rectangle, minX < maxX and minY < maxY.
struct Box {
  double minX = 0;
  double minY = 0;
  double maxX = 1;
  double maxY = 1;
};

/// The largest coordinate of a region, in absolute value: a hundred times that of a circle, and areas are numbers.
inline constexpr double kRegionLimit = 1e152;

/// The closed region that curves and cells are clipped to.
class ConvexPolygon {
 public:
  /// Precondition: the box is one that `from` accepts.
  ConvexPolygon(const Box& box);

  /// Errors: badOption, if the box is empty, or a coordinate is not finite or exceeds kRegionLimit.
  static Result<ConvexPolygon> from(const Box& box);
  /// From corners in counter-clockwise order; corners on the line through their neighbours are allowed.
  /// Errors: badOption, if there are fewer than three corners, a coordinate is not finite or exceeds kRegionLimit, two
  /// corners in a row are equal, or they do not turn left exactly once.
  static Result<ConvexPolygon> from(std::span<const Point> corners);

  /// Counter-clockwise.
  std::span<const Point> corners() const { return corners_; }
  std::size_t size() const { return corners_.size(); }
  /// The corner at which side `k`, which begins at corner `k`, ends.
  Point cornerAfter(std::size_t k) const { return corners_[k + 1 == corners_.size() ? 0 : k + 1]; }

  bool contains(Point p) const;
  double area() const;
  /// The mean of the corners, which lies inside.
  Point middle() const;

 private:
  explicit ConvexPolygon(std::vector<Point> corners) : corners_(std::move(corners)) {}

  std::vector<Point> corners_;
};

}  // namespace circle_voronoi
