// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "export_frame.h"

namespace circle_voronoi {

/// The cells as polygons, and the edges as polylines that these share. Each edge inside the box is followed once, and
/// its points serve both cells and the edge itself.
///
/// Points are rounded by the frame's grid, but for those that meet the box, and those of edges that rounding would turn
/// around: these keep all digits.
class CellPolygons {
 public:
  using Ring = std::vector<Point>;

  explicit CellPolygons(const ExportFrame& frame);

  /// Closed rings of a cell inside the box, counter-clockwise, without the first point at the end and without points in
  /// a row that are equal. They do not cross themselves, however large the tolerance is. Rings are left out whose area
  /// is but rounding error.
  std::vector<Ring> rings(std::int32_t circle) const;

  /// The parts of an edge inside the box, from its start to its end.
  std::vector<Ring> polylines(std::int32_t edge) const;

  /// The area of a cell inside the box, but for rounding that of the cell, not of its polygon.
  double area(std::int32_t circle) const;

 private:
  std::span<const Point> innerPoints(std::int32_t edge) const {
    const auto e = static_cast<std::size_t>(edge);
    return std::span(inner_).subspan(firstInner_[e], firstInner_[e + 1] - firstInner_[e]);
  }
  bool isInside(std::int32_t edge) const { return isInside_[static_cast<std::size_t>(edge)]; }
  bool isWhole(std::int32_t circle) const;
  Point placeOf(std::int32_t vertex) const {
    return places_[static_cast<std::size_t>(mergedVertex_[static_cast<std::size_t>(vertex)])];
  }

  void followEdges();
  void roundPoints();
  bool turnsRight(std::int32_t edge) const;

  template <class Add>
  void addSide(std::int32_t side, Add add) const;
  Ring pointsOf(const OutlinePiece& piece) const;
  Ring wholeRing(std::int32_t circle) const;
  Point drawn(std::int32_t vertex, Point end) const;

  const ExportFrame& frame_;
  ConvexPolygon region_;
  /// Vertices joined by edges of length near zero are one point, so that rounding cannot turn such an edge around.
  std::vector<std::int32_t> mergedVertex_;
  std::vector<Point> places_;  ///< of each merged vertex
  std::vector<bool> isInside_;
  /// Of edges inside the box: the points between its ends, those of edge e from firstInner_[e] to firstInner_[e + 1],
  /// and the area between the arc and the chord of its vertices, positive to the right.
  std::vector<std::size_t> firstInner_;
  std::vector<Point> inner_;
  std::vector<double> beyond_;
};

}  // namespace circle_voronoi
