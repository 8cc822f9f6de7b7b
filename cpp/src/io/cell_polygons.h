// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "clip_polygons.h"
#include "edge_points.h"
#include "valid_polygons.h"

namespace circle_voronoi {

/// The cells as polygons, and the edges as polylines. Polygons of neighbors share the points of these polylines.
///
/// Points are rounded to the frame's grid, with two exceptions that keep all digits: points on the box, unless
/// ExportOptions::digits is given, and points of edges that rounding would reverse.
class CellPolygons {
 public:
  using Ring = std::vector<Point>;

  explicit CellPolygons(const ExportFrame& frame);

  /// An outer ring and its holes.
  using Polygon = std::vector<Ring>;

  /// The polygons of a cell inside the box or the region. Rings are closed, outer ones counter-clockwise and holes
  /// clockwise, without the first point at the end and without points in a row that are equal. They do not cross
  /// themselves, however large the tolerance is. Rings whose area is only rounding error are left out.
  std::vector<Polygon> polygons(CircleIndex circle) const;

  /// Calls `visitCell` with each circle in order, and prefetches its edges.
  template <class VisitCell>
  void visit(VisitCell visitCell) const {
    points_.visitCells(visitCell);
  }

  /// The parts of an edge inside the box, from its start to its end.
  std::vector<Ring> polylines(EdgeIndex edge) const;

 private:
  bool isInside(EdgeIndex edge) const { return points_.hasInside(edge); }
  std::int32_t circleCount() const { return static_cast<std::int32_t>(frame_.diagram.circles.size()); }
  Point centerOf(CircleIndex circle) const {
    const Circle& c = frame_.diagram.circles[static_cast<std::size_t>(circle)];
    return {c.x, c.y};
  }
  Point placeOf(VertexIndex vertex) const { return points_.placeOf(vertex); }

  void roundPoints();
  bool turnsRight(EdgeIndex edge, std::span<const Point> points) const;
  bool turnsRight(EdgeIndex edge, Point start, Point end) const;
  bool partsTurnRight(EdgeIndex edge) const;
  std::vector<EdgeIndex> wronglyRounded() const;

  template <class Add>
  void addSide(SideIndex side, Add add) const;
  Ring pointsOf(const OutlinePiece& piece) const;
  Ring pointsOfArcs(CircleIndex circle, std::span<const OutlinePiece> arcs, Point from, Point to, bool rounds) const;
  Ring ringOf(CircleIndex circle, std::vector<OutlinePiece> loop, bool rounds) const;
  Ring wholeRing(CircleIndex circle) const;
  bool isDrawnIn(VertexIndex vertex, Point end) const;

  const ExportFrame& frame_;
  ClipFlattener flattener_;  ///< of edges that are not inside
  /// Vertices joined by edges of length near zero have one place, so that rounding cannot turn such an edge around.
  EdgePoints points_;
  /// For each edge that is not inside the box: whether its points keep all digits. Its vertices are not among them.
  std::vector<bool> isExact_;
};

}  // namespace circle_voronoi
