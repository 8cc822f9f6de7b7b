// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/cells.h"
#include "circle_voronoi/point.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

/// Finds the nearest circle by a walk through the cells.
///
/// From cell i the walk goes on to a neighbour that is nearer to p, until there is none. That cannot end too early: the
/// cells are star-shaped around their centres, so if p is outside cell i, the segment from c_i to p leaves it across a
/// side, and from there on it is nearer to the neighbour across that side (the points nearer to i than to j are
/// star-shaped around c_i too). Of a cell with many sides that one is found by bisection. For the power metric cells
/// are intersections of half-planes, one for each neighbour, and one of them excludes p.
///
/// A grid of starting circles makes the walk short: for circles spread evenly a step or two.
class Finder {
 public:
  /// In linear time. The cells must outlive this.
  explicit Finder(const Cells& cells);
  explicit Finder(const Cells&& cells) = delete;

  /// The circle of smallest distance to the finite point p, one of them up to rounding where several are. The walk
  /// starts near p, or from `hint`, if that is nearer. kNone if there are no circles.
  std::int32_t find(Point p, std::int32_t hint = kNone) const;

  /// For each point the same; points near in the list that are near in the plane help.
  std::vector<std::int32_t> findAll(std::span<const Point> points) const;

 private:
  std::int32_t startNear(Point p) const;
  std::int32_t nearerNeighbor(std::int32_t circle, Point p) const;

  const Cells& cells_;
  Point corner_;
  double width_ = 1;  ///< of a bucket
  double height_ = 1;
  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  std::vector<std::int32_t> starts_;  ///< a visible circle for each bucket, row by row
};

}  // namespace circle_voronoi
