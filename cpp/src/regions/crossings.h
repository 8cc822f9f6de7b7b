// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "chosen.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/point.h"
#include "circle_voronoi/region.h"
#include "shifted_signs.h"

namespace circle_voronoi {

/// A crossing of the boundary of a region and an edge of a diagram. It is decided once, for the cells on both sides.
struct Crossing {
  EdgeIndex edge = {};
  RegionSideIndex side = {};  ///< the side of the region
  Point point;
  double parameter = 0;  ///< the parameter of the point on the edge
  /// The parameter in the direction of orderedCurve.
  double orderedParameter = 0;
  /// The position of the point along the side, from 0 at the smaller of its two ends, by x and then y, to 1 at the
  /// other.
  double share = 0;
  /// Whether the edge enters the region here, seen in its own direction: the boundary goes from its left cell to its
  /// right cell.
  bool isEntry = false;
};

/// The course of a region's boundary through a diagram.
///
/// It goes from cell to cell: each ring is a closed path in the dual. Exact signs decide which edges it crosses and in
/// which order, for a region that is moved by a tiny shift (shifted_signs.h).
struct Crossings {
  std::vector<Crossing> all;
  /// For each crossing the next one of its ring; kNone if the boundary has not been followed up to there.
  std::vector<std::int32_t> next;
  /// For each crossing whether the next one lies ahead on the same side of the region, with no corner between.
  std::vector<std::uint8_t> isOnSideOfNext;
  struct RingInCell {
    CircleIndex cell;
    std::int32_t ring;
  };
  std::vector<RingInCell> rings;  ///< the rings without crossings
};

/// Walks along the boundary of a region. Takes linear time in sides, crossings and the edges of the cells that are
/// crossed, and in the circles to find the first cell. The crossings are in the order of each ring. The diagram has a
/// circle.
Crossings crossingsOf(const Diagram& diagram, const Region& region);

/// Follows the boundary only where it is in some cells, and returns the crossings of their edges, in increasing order
/// of sides of the region. Takes time for the edges of these cells and the sides of the region near them.
Crossings crossingsOf(const Diagram& diagram, const Region& region, const Chosen& cells);

}  // namespace circle_voronoi
