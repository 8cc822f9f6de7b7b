// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/point.h"

namespace circle_voronoi {

/// Finds the nearest circle by walking through the cells.
///
/// From cell i the walk moves to a neighbor that is nearer to p, until there is none. It cannot stop too early: the
/// cells are star-shaped around their centers. If p lies outside cell i, the segment from c_i to p leaves the cell
/// across a side. From there on it is nearer to the neighbor across that side, because the points nearer to i than to j
/// are star-shaped around c_i, too. In a cell with many sides, bisection finds that side. For the power metric, cells
/// are intersections of half-planes, one for each neighbor, and one half-plane excludes p: its border is crossed on the
/// way from any point of the cell to p.
///
/// A grid of starting circles keeps the walk short: a step or two if the circles are spread evenly.
class CIRCLE_VORONOI_API Finder {
 public:
  /// Takes linear time. The diagram must outlive the finder.
  explicit Finder(const Diagram& diagram);
  explicit Finder(const Diagram&& diagram) = delete;
  Finder(Finder&&) noexcept;
  Finder& operator=(Finder&&) noexcept;
  ~Finder();

  /// Returns the circle at the smallest distance from p. If several are equally near up to rounding, returns one of
  /// them. The walk starts near p, or at `hint` if that is nearer. Returns kNone if there are no circles. Precondition:
  /// p is finite.
  [[nodiscard]] CircleIndex find(Point p, CircleIndex hint = kNone) const;

  /// Returns the nearest circle for each point. Each walk may start where the one before it ended, so it is quicker if
  /// consecutive points are near each other.
  [[nodiscard]] std::vector<CircleIndex> findAll(std::span<const Point> points) const;

 private:
  class Walker;
  std::unique_ptr<const Walker> walker_;
};

}  // namespace circle_voronoi
