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

/// The moments of the parts of cells in a region, each relative to a point of its own. A row belongs to a cell of the
/// scope of the clip.
struct CellMoments {
  std::vector<Moments> moments;
  std::vector<Point> references;
  double boundary = 0;  ///< the length of the boundary of the region in these cells

  double area(std::size_t row) const { return moments[row].area; }
  /// Returns the center of mass; NaN for a cell without a part.
  Point centroid(std::size_t row) const;
};

}  // namespace circle_voronoi
