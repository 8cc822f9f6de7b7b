// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cell_limits.h"
#include "circle_voronoi/cells.h"
#include "circle_voronoi/export.h"
#include "digits.h"

namespace circle_voronoi {

/// What every writer of a drawing needs: the diagram, the region, and how closely curves and coordinates are written.
struct ExportFrame {
  ExportFrame(const Diagram& its, const ExportOptions& options);
  ExportFrame(const ExportFrame&) = delete;
  ExportFrame& operator=(const ExportFrame&) = delete;

  Point round(Point p) const { return {grid.round(p.x), grid.round(p.y)}; }
  /// A point that is kept in the box: rounded along it, if digits are asked for.
  Point roundInBox(Point p) const;
  double area(double value) const { return hasDigits ? grid.round(value) : value; }

  /// Whether a vertex is not beyond the maximum distance.
  bool isNear(VertexIndex vertex) const {
    return !limits.maxDistance || diagram.vertices[static_cast<std::size_t>(vertex)].r <= *limits.maxDistance;
  }

  const Diagram& diagram;
  bool hasDigits;  ///< whether digits are asked for
  DecimalGrid grid;
  Box box;
  ConvexPolygon region;  ///< the box
  Limits limits;         ///< of cells and edges
  double tolerance;      ///< of curves: what rounding leaves of it
};

/// The curve of a piece of an outline, which is not of the region's boundary, in the direction of its edge: the same
/// bits from either side.
EdgeCurve edgeDirection(const Diagram& diagram, const OutlinePiece& piece);

/// Whether an edge is kept as a whole, and lies so far inside the box that it does so when its points are rounded. Then
/// so do its ends.
bool isInside(const ExportFrame& frame, const Edge& edge, const EdgeCurve& curve);

}  // namespace circle_voronoi
