// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "chosen.h"
#include "circle_voronoi/clipped_diagram.h"

namespace circle_voronoi {

/// Arcs of edges in a region as polylines.
///
/// A corner of the region may lie between an arc and a chord of its polyline. Then the border of a cell would cross
/// itself, so such chords are divided until it does not. Straight sides without such corners cannot cross a polyline
/// whose arc they do not cross. That holds for arcs of edges and for those of rims, which lie where the cell reaches
/// beyond the distance, so that no edge comes between a rim and its chords.
///
/// Points that are one but for rounding become one: a corner, the crossings there, and the vertices there. Otherwise
/// borders of cells would cross themselves within rounding of such a place.
///
/// Exported because the library for files calls it.
class CIRCLE_VORONOI_API ClipFlattener {
 public:
  ClipFlattener(const ClippedDiagram& clipped, double tolerance);

  /// Returns the points of a piece of an outline that is a side, in the direction of the outline. The first and last
  /// one are the ends of the piece.
  std::vector<Point> pointsOf(const OutlinePiece& piece) const;
  /// Returns the points of a piece of the outline of a cell that is an arc of a circle.
  std::vector<Point> pointsOfArc(CircleIndex cell, const OutlinePiece& arc) const;

  /// Returns the point that stands for a corner, a crossing or a vertex.
  Point placeOf(Point p) const;
  /// Returns for each vertex the vertex of smallest index at the same point (firstVerticesHere). All cells are clipped.
  const std::vector<std::int32_t>& firstHere() const { return firstHere_; }

 private:
  struct Corner {
    EdgeIndex edge;
    CircleIndex cell;  ///< in which it lies
    double height;     ///< along the edge (heightOn)
    Point point;
    auto key() const { return std::tuple(std::int32_t{edge}, std::int32_t{cell}, height); }
  };
  struct RimCorner {
    CircleIndex cell;  ///< in which it lies
    Point point;
  };
  double mostReach() const;
  void collectCorners();
  void collectRimCorner(CircleIndex cell, Point corner);
  void collectPlaces();
  double heightOn(EdgeIndex edge, Point p) const;
  /// The corners in a cell beside an edge between two heights.
  std::span<const Corner> cornersOn(EdgeIndex edge, CircleIndex cell, double low, double high) const;
  std::vector<Point> pointsOf(EdgeIndex edge, const EdgeCurve& part) const;

  const ClippedDiagram& clipped_;
  double tolerance_;
  std::vector<std::int32_t> firstHere_;          ///< by row of the vertex in scope
  std::vector<Corner> corners_;                  ///< the corners near a curved edge, sorted by key
  std::vector<RimCorner> rimCorners_;            ///< the corners near a rim, sorted by cell
  std::vector<std::pair<Point, Point>> places_;  ///< points that another one stands for, sorted
};

/// Returns polygons of some cells, which have been clipped.
ClippedPolygons clipPolygons(const ClippedDiagram& clipped, const Chosen& circles, double tolerance);

}  // namespace circle_voronoi
