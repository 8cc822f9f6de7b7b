// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "circle_voronoi/cells.h"
#include "circle_voronoi/export.h"

namespace circle_voronoi {

/// What every writer needs: the cells, the region and the tolerance.
struct ExportFrame {
  ExportFrame(std::span<const Circle> circles, const Diagram& diagram, const ExportOptions& options);

  Cells cells;
  Box box;
  double tolerance;
  /// Where each vertex is drawn: vertices joined by edges of length near zero are one point, so that rounding cannot
  /// turn such an edge around.
  std::vector<Point> places;
};

/// The curve of a piece in the direction of its edge: the same bits from either side. A piece of the boundary as it is.
EdgeCurve edgeDirection(const Cells& cells, const OutlinePiece& piece);
/// Whether that is against the direction of the outline.
inline bool isAgainstEdge(const OutlinePiece& piece) { return piece.side != kNone && piece.side % 2 == 1; }

/// Closed rings of a cell inside the box, counter-clockwise, without the first point at the end and without points in a
/// row that are equal. They do not cross themselves, however large the tolerance is. Rings are left out whose area is
/// but rounding error.
std::vector<std::vector<Point>> ringsOf(const ExportFrame& frame, std::int32_t circle);

}  // namespace circle_voronoi
