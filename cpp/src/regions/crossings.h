// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "circle_voronoi/curve.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/point.h"
#include "circle_voronoi/region.h"

namespace circle_voronoi {

/// A crossing of the boundary of a region and an edge of a diagram. It is decided once, for the cells on both sides.
struct Crossing {
  EdgeIndex edge = {};
  RegionSideIndex side = {};  ///< the side of the region
  Point point;
  double parameter = 0;  ///< of the point, on the edge
  /// How far along the side the point is, from 0 at the smaller of its two ends, by x and then y, to 1 at the other.
  double share = 0;
  /// Whether the edge enters the region here, seen in its own direction: the boundary goes from its left cell to its
  /// right cell.
  bool isEntry = false;
};

/// How the boundary of a region runs through a diagram.
///
/// It goes from cell to cell: each ring is a closed path in the dual. Whatever rounding does, this alone makes all that
/// follows fit together (arcs.h).
struct Crossings {
  std::vector<Crossing> all;          ///< in the order of rings, and along each ring
  std::vector<std::int32_t> offsets;  ///< for each ring where its crossings begin, and their number at the end
  std::vector<CircleIndex> cell;      ///< for each ring without crossings the cell that it lies in, otherwise kNone
};

/// Walks along the boundary of a region. Takes linear time in sides, crossings and the edges of the cells that are
/// crossed, and in the circles to find the first cell. The diagram has a circle.
Crossings crossingsOf(const Diagram& diagram, const Region& region);

/// Returns the curve of an edge as it is seen from the region (far_view.h), with the parameters of its crossings.
EdgeCurve curveIn(const Diagram& diagram, const Box& bounds, EdgeIndex edge);

}  // namespace circle_voronoi
