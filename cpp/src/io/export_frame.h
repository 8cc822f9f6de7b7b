// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "circle_voronoi/cells.h"
#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/export.h"
#include "digits.h"
#include "guarded.h"
#include "writer.h"

namespace circle_voronoi {

/// The share of the tolerance that rounding may use up, in each coordinate.
inline constexpr double kRoundingShare = 0.1;

/// Returns the region to which a diagram is clipped: the region of the options, their box, or the default box.
/// Errors: notCertified if the diagram is not certified; badInput if the numbers of vertexCircles and vertices differ;
/// badOption if an option is out of range.
Result<Region> exportRegion(const Diagram& diagram, const ExportOptions& options);

/// The data that every writer of a drawing needs: the diagram, the region, and the tolerances of curves and
/// coordinates.
struct ExportFrame {
  /// `itsClip` is the diagram clipped to the region of `exportRegion`.
  ExportFrame(const Diagram& its, const ExportOptions& options, ClippedDiagram itsClip);
  ExportFrame(const ExportFrame&) = delete;
  ExportFrame& operator=(const ExportFrame&) = delete;

  Point round(Point p) const { return {grid.round(p.x), grid.round(p.y)}; }
  /// Returns a point on the boundary of the region, rounded along it if digits are given and the region is a box.
  Point roundOnBoundary(Point p) const;
  double area(double value) const { return hasDigits ? grid.round(value) : value; }
  bool hasInside(Point p) const { return clipped.region().contains(p); }
  /// Returns whether a vertex lies within the maximum distance.
  bool isWithin(VertexIndex vertex) const {
    return !clipped.maxDistance() || diagram.vertices[static_cast<std::size_t>(vertex)].r <= *clipped.maxDistance();
  }

  const Diagram& diagram;
  bool hasDigits;  ///< whether digits are given
  DecimalGrid grid;
  Box box;                             ///< around the region
  bool isBox;                          ///< whether the region is the box
  bool isClipped;                      ///< whether the options clip the diagram, not only the default box
  ClippedDiagram clipped;              ///< the diagram in the region
  std::function<Point(Point)> place;   ///< empty: none (ExportOptions)
  const CircleAttributes* attributes;  ///< null: none
  double tolerance;                    ///< the tolerance of curves: the part that rounding leaves
};

/// Returns the neighbors of a cell. If the options clip the diagram, these are the neighbors that share a part of an
/// edge inside, each once.
std::vector<CircleIndex> neighborsIn(const ExportFrame& frame, CircleIndex circle);

/// Returns the area of each cell. If the options clip the diagram, this is the area of its part inside; otherwise that
/// of the whole cell, which is infinite if the cell is unbounded.
std::vector<double> areasIn(const ExportFrame& frame);

/// The measures of each cell, or of its part inside.
struct CellMeasures {
  std::vector<double> areas;
  std::vector<double> perimeters;
};

/// Returns the area and the perimeter of each cell, like `areasIn`.
CellMeasures measuresIn(const ExportFrame& frame);

/// Returns for each circle the one that hides it, or kNone.
std::vector<CircleIndex> hidersOf(std::span<const HiddenCircle> hidden, std::size_t circleCount);

/// Writes the columns area, perimeter, neighbors and hiddenBy of a cell. The measures of unbounded cells are `inf`.
void writeCellColumns(Writer& out, double area, double perimeter, const std::vector<CircleIndex>& neighbors,
                      CircleIndex hider);

/// Returns rings mapped by ExportOptions::place.
std::vector<std::vector<std::vector<Point>>> mapped(const ExportFrame& frame,
                                                    std::vector<std::vector<std::vector<Point>>> polygons);

/// Returns the curve of a piece of an outline in the direction of its edge, with the same bits for both cells.
/// Precondition: the piece does not belong to the region's boundary.
EdgeCurve edgeDirection(const Diagram& diagram, const OutlinePiece& piece);

/// Returns whether the whole edge is kept and stays inside the box when its points are rounded.
bool isInside(const ExportFrame& frame, const Edge& edge, const EdgeCurve& curve);

/// Writes to a stream what `body` writes to a Writer, in an ExportFrame. Call it within `guarded` (unguardedWriting).
/// Errors: also those of `exportRegion`.
template <class Body>
Result<void> unguardedWritingIn(std::ostream& stream, const Diagram& diagram, const ExportOptions& options, Body body) {
  const auto region = exportRegion(diagram, options);
  if (!region) return region.error();
  auto clip = ClippedDiagram::from(diagram, *region, options.maxDistance);
  if (!clip) return clip.error();
  const ExportFrame frame(diagram, options, *std::move(clip));
  return unguardedWriting(stream, [&](Writer& out) { body(out, frame); });
}

/// Writes to a stream what `body` writes to a Writer, in an ExportFrame. Errors: also those of `exportRegion`.
template <class Body>
Result<void> writingIn(std::ostream& stream, const Diagram& diagram, const ExportOptions& options, Body body) {
  return guarded([&] { return unguardedWritingIn(stream, diagram, options, body); });
}

}  // namespace circle_voronoi
