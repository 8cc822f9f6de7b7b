// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "clip_polygons.h"
#include "export_frame.h"
#include "visit_ahead.h"

namespace circle_voronoi {

/// The cells as polygons, and the edges as polylines that these share. Each edge inside the box is followed once, and
/// its points serve both cells and the edge itself.
///
/// Points are rounded by the frame's grid, but for those that meet the box, unless digits are asked for, and those of
/// edges that rounding would turn around: these keep all digits.
class CellPolygons {
 public:
  using Ring = std::vector<Point>;

  explicit CellPolygons(const ExportFrame& frame);

  /// An outer ring and its holes.
  using Polygon = std::vector<Ring>;

  /// The polygons of a cell inside the box or the region. Rings are closed, outer ones counter-clockwise and holes
  /// clockwise, without the first point at the end and without points in a row that are equal. They do not cross
  /// themselves, however large the tolerance is. Rings are left out whose area is but rounding error.
  std::vector<Polygon> polygons(CircleIndex circle) const;

  /// Calls `visitCell` with each circle in order; quicker than doing so without this.
  template <class VisitCell>
  void visit(VisitCell visitCell) const {
    visitAhead(
        circleCount(), [&](std::int32_t i) { prefetchEdges(i); }, [&](std::int32_t i) { prefetchPoints(i); },
        visitCell);
  }

  /// The parts of an edge inside the box, from its start to its end.
  std::vector<Ring> polylines(EdgeIndex edge) const;

  /// The area of a cell inside the box, but for rounding that of the cell, not of its polygon.
  double area(CircleIndex circle) const;

 private:
  std::span<const Point> innerPoints(EdgeIndex edge) const {
    const auto e = static_cast<std::size_t>(edge);
    return std::span(inner_).subspan(arcs_[e].firstInner, arcs_[e + 1].firstInner - arcs_[e].firstInner);
  }
  bool isInside(EdgeIndex edge) const { return isInside_[static_cast<std::size_t>(edge)]; }
  bool isWhole(CircleIndex circle) const;
  std::int32_t circleCount() const { return static_cast<std::int32_t>(frame_.diagram.circles.size()); }
  Point centerOf(CircleIndex circle) const {
    const Circle& c = frame_.diagram.circles[static_cast<std::size_t>(circle)];
    return {c.x, c.y};
  }
  Point placeOf(VertexIndex vertex) const { return places_[static_cast<std::size_t>(vertex)]; }

  void followEdges();
  void roundPoints(const std::vector<std::int32_t>& firstHere);
  void prefetchEdges(CircleIndex circle) const;
  void prefetchPoints(CircleIndex circle) const;
  bool turnsRight(EdgeIndex edge, std::span<const Point> points) const;
  bool turnsRight(EdgeIndex edge, Point start, Point end) const;
  bool partsTurnRight(EdgeIndex edge) const;
  std::vector<EdgeIndex> wronglyRounded() const;

  template <class Add>
  void addSide(SideIndex side, Add add) const;
  Ring pointsOf(const OutlinePiece& piece) const;
  Ring pointsOfArcs(CircleIndex circle, std::span<const OutlinePiece> arcs, Point from, Point to, bool rounds) const;
  Ring ringOf(CircleIndex circle, std::vector<OutlinePiece> loop, bool rounds) const;
  Ring regionRing(CircleIndex circle, const std::vector<OutlinePiece>& loop) const;
  Ring pointsOfPart(EdgeIndex edge, const EdgeCurve& curve) const;
  Ring wholeRing(CircleIndex circle) const;
  bool isDrawnIn(VertexIndex vertex, Point end) const;

  const ExportFrame& frame_;
  std::optional<ClipFlattener> flattener_;  ///< of edges that are not inside, if there is a region
  std::vector<double> areas_;               ///< of cells in the region, if there is one
  /// Of each vertex; those joined by edges of length near zero have one, so that rounding cannot turn such an edge
  /// around.
  std::vector<Point> places_;
  std::vector<bool> isInside_;
  /// Of each edge that is not inside the box whether its points keep all digits, those of its vertices apart.
  std::vector<bool> isExact_;
  /// Of an edge inside the box.
  struct Arc {
    std::size_t firstInner;  ///< of its points between its ends, in inner_; they end where those of the next edge begin
    double beyond = 0;       ///< the area between the arc and the chord of its vertices, positive to the right
  };
  std::vector<Arc> arcs_;
  std::vector<Point> inner_;
};

}  // namespace circle_voronoi
