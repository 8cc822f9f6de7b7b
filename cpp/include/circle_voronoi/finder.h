// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/diagram.h"
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
  /// In linear time. The diagram must outlive this.
  explicit Finder(const Diagram& diagram);
  explicit Finder(const Diagram&& diagram) = delete;

  /// The circle of smallest distance to the finite point p, one of them up to rounding where several are. The walk
  /// starts near p, or from `hint`, if that is nearer. kNone if there are no circles.
  CircleIndex find(Point p, CircleIndex hint = kNone) const;

  /// For each point the same; points near in the list that are near in the plane help.
  std::vector<CircleIndex> findAll(std::span<const Point> points) const;

 private:
  CircleIndex startNear(Point p) const;
  CircleIndex nearerNeighbor(CircleIndex circle, Point p) const;
  std::span<const SideIndex> manySides(CircleIndex circle) const;

  const Diagram& diagram_;
  Point corner_;
  double width_ = 1;  ///< of a bucket
  double height_ = 1;
  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  std::vector<CircleIndex> starts_;  ///< a visible circle for each bucket, row by row
  /// Cells with many sides, increasing, and their sides: those of the k-th from firstOfMany_[k] to firstOfMany_[k + 1].
  std::vector<CircleIndex> many_;
  std::vector<std::size_t> firstOfMany_ = {0};
  std::vector<SideIndex> sidesOfMany_;
};

}  // namespace circle_voronoi
