// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "arc_measure.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/point.h"

namespace circle_voronoi {

/// Visits each part of an edge inside the region.
using VisitArc = std::function<void(const Edge&, const EdgeCurve&)>;

/// The moments of the parts of all cells in a region, each relative to a point of its own.
struct CellMoments {
  std::vector<Moments> moments;
  std::vector<Point> references;

  double area(std::size_t cell) const { return moments[cell].area; }
  /// Returns the center of mass; NaN for a cell without a part.
  Point centroid(std::size_t cell) const;
};

}  // namespace circle_voronoi
