// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "circle_voronoi/clipped_diagram.h"

namespace circle_voronoi {

/// Arcs of edges in a region as polylines.
///
/// A corner of the region may lie between an arc and a chord of its polyline. Then the border of a cell would cross
/// itself, so such chords are divided until it does not. Straight sides without such corners cannot cross a polyline
/// whose arc they do not cross.
///
/// Exported because the library for files calls it.
class CIRCLE_VORONOI_API ClipFlattener {
 public:
  ClipFlattener(const ClippedDiagram& clipped, double tolerance);

  /// Returns the points of a part of an edge in the region, in the direction of the edge: the same for both cells.
  std::vector<Point> pointsOf(EdgeIndex edge, const EdgeCurve& part) const;

  /// Returns the points of a piece of an outline that is a side or an arc of a circle, in the direction of the outline.
  std::vector<Point> pointsOf(CircleIndex circle, const OutlinePiece& piece) const;

 private:
  struct Corner {
    EdgeIndex edge;
    Point point;
    CircleIndex cell;  ///< in which it lies
  };
  void collectCorners();

  const ClippedDiagram& clipped_;
  double tolerance_;
  std::vector<Corner> corners_;  ///< those that are near a curved edge, by edge
};

ClippedPolygons clipPolygons(const ClippedDiagram& clipped, double tolerance);

}  // namespace circle_voronoi
