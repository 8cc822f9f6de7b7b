// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <optional>
#include <span>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/convex_polygon.h"
#include "circle_voronoi/diagram.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

/// What of a diagram is written, and how closely.
struct ExportOptions {
  /// Cells and unbounded edges are clipped to it; by default it has room for a twentieth of the circles' extent around
  /// them.
  std::optional<Box> box;
  /// The largest distance of what is written from the true curves, above 0; by default a hundred-thousandth of the box.
  std::optional<double> tolerance;
};

/// The box that is used by default.
Box exportBox(std::span<const Circle> circles);

// Each writes a certified diagram of `circles`. Polygons of cells are counter-clockwise, and those of neighbours share
// their points bit for bit; none crosses itself. But a cell that is narrower than the rounding of its vertices, as
// between circles that touch inside but for rounding, may have a polygon that does, or none.
//
// Coordinates have decimals enough for the tolerance, of which rounding takes at most a tenth: their last place is the
// largest power of ten that does. Points that meet the box, arcs of the hull, and polygons that would collapse or cross
// themselves if they were rounded keep all digits; so do radii and areas of GeoJSON and all numbers of CSV, which read
// back to the same bits.

/// A drawing, y upwards, that fits the box: groups of class cells, dual, circles, edges, vertices and hull, styled by a
/// style sheet. Curves are cubic Bezier curves. Hidden circles have the class hidden, circles too small to be seen
/// the class point.
void writeSvg(std::ostream& out, std::span<const Circle> circles, const Diagram& diagram,
              const ExportOptions& options = {});

/// RFC 7946: a feature for each circle, its cell as a Polygon, a MultiPolygon if the box cuts it apart, or null if it
/// is hidden or outside the box; with the properties circle, radius, area, neighbors (circles), and hiddenBy of a
/// hidden circle.
void writeGeoJson(std::ostream& out, std::span<const Circle> circles, const Diagram& diagram,
                  const ExportOptions& options = {});

/// Well-known text: line i is the cell of circle i, POLYGON, MULTIPOLYGON or POLYGON EMPTY.
void writeWkt(std::ostream& out, std::span<const Circle> circles, const Diagram& diagram,
              const ExportOptions& options = {});

/// Wavefront OBJ in the plane z = 0: the edges as polylines in the object `edges`, the cells as faces in the object
/// `cells`, in a group for each circle.
void writeObj(std::ostream& out, std::span<const Circle> circles, const Diagram& diagram,
              const ExportOptions& options = {});

/// One table of vertices and edges, with the columns type, index, x, y, radius, circle1, circle2, circle3, start, end:
/// of a vertex its disc and three circles, of an edge its left and right circle and its vertices, -1 for infinity.
void writeDiagramCsv(std::ostream& out, const Diagram& diagram);

}  // namespace circle_voronoi
