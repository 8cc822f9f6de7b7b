// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/convex_polygon.h"
#include "circle_voronoi/curve.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/point.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

/// What of a diagram is written, and how closely.
struct ExportOptions {
  /// Cells and unbounded edges are clipped to it; by default it has room for a twentieth of the circles' extent around
  /// them, grown by the maximum distance if there is one.
  std::optional<Box> bounds;
  /// Cells and edges are cut at this distance from the nearest circle (cells.h), finite and at most kRegionLimit.
  std::optional<double> maxDistance = {};
  /// The largest distance of what is written from the true curves, above 0; by default a hundred-thousandth of the box.
  std::optional<double> tolerance;
  /// How many digits coordinates and areas have after the decimal point at most, from 0; by default those that the
  /// tolerance asks for. Then rounding may move points by more than the tolerance, and the default box is widened to
  /// such coordinates.
  std::optional<int> digits = {};
};

/// Which circles' parts are written, and by which names; all, and by their indices, where a span is empty.
struct Selection {
  std::span<const std::int64_t> ids;       ///< of each circle, increasing
  std::span<const std::uint8_t> isChosen;  ///< of each circle

  std::int64_t id(CircleIndex circle) const {
    return ids.empty() || circle == kNone ? std::int64_t{circle} : ids[static_cast<std::size_t>(circle)];
  }
  bool contains(CircleIndex circle) const {
    return isChosen.empty() || isChosen[static_cast<std::size_t>(circle)] != 0;
  }
};

/// The box that is used by default where no digits are asked for.
Box exportBox(std::span<const Circle> circles, std::optional<double> maxDistance = {});

// Each writes a certified diagram of `circles`. Polygons of cells are counter-clockwise, and those of neighbours share
// their points bit for bit; none crosses itself. But a cell that is narrower than the rounding of its vertices, as
// between circles that touch inside but for rounding, may have a polygon that does, or none.
//
// Coordinates have decimals enough for the tolerance, of which rounding takes at most a tenth: their last place is the
// largest power of ten that does. Points that meet the box, arcs of the hull, and polygons that would collapse or cross
// themselves if they were rounded keep all digits; so do radii and areas of GeoJSON and all numbers of CSV, which read
// back to the same bits. With ExportOptions::digits points that meet the box are rounded along it, and areas are.

/// A drawing, y upwards, that fits the box and has nothing of what is outside: groups of class cells, dual, circles,
/// edges, vertices and hull, styled by a style sheet. Curves are cubic Bezier curves, and arcs of circles are arcs.
/// Hidden circles have the class hidden, circles too small to be seen, and those of negative radius, the class point.
void writeSvg(std::ostream& out, const Diagram& diagram, const ExportOptions& options = {});

/// Marks of one kind in a figure: a group of this class.
struct SvgLayer {
  std::string name;
  std::vector<Point> points = {};  ///< strokes of length zero: as wide as the style says
  std::vector<Circle> discs = {};
  std::vector<std::array<Point, 2>> segments = {};  ///< with an arrowhead at the second point, if they are arrows
  bool areArrows = false;
  std::vector<EdgeCurve> arcs = {};  ///< bounded ones
};

/// A drawing with more, or less, than a diagram has.
struct SvgFigure {
  ExportOptions frame;
  /// Which groups of `writeSvg` are drawn.
  std::vector<std::string> groups = {"cells", "dual", "circles", "edges", "vertices", "hull"};
  std::vector<SvgLayer> layers = {};  ///< drawn over these, in their order
  std::string style;                  ///< rules of a style sheet, after those of `writeSvg`
  double pixels = 1000;               ///< the longer side of the drawing, to which strokes and dots refer
};

/// The drawing of `writeSvg` as a figure.
void writeSvgFigure(std::ostream& out, const Diagram& diagram, const SvgFigure& figure);

/// RFC 7946: a feature for each circle, its cell as a Polygon, a MultiPolygon if the box cuts it apart, or null if it
/// is hidden or outside the box; with the properties circle, r, area, neighbors (circles), and hiddenBy of a
/// hidden circle.
void writeGeoJson(std::ostream& out, const Diagram& diagram, const ExportOptions& options = {});

/// The same features of the chosen circles, by their ids, one a line and nothing else: such texts can be put together.
void writeGeoJsonLines(std::ostream& out, const Diagram& diagram, const ExportOptions& options = {},
                       const Selection& selection = {});

/// Well-known text: line i is the cell of circle i, POLYGON, MULTIPOLYGON or POLYGON EMPTY.
void writeWkt(std::ostream& out, const Diagram& diagram, const ExportOptions& options = {});

/// Wavefront OBJ in the plane z = 0: the edges as polylines in the object `edges`, the cells as faces in the object
/// `cells`, in a group for each circle.
void writeObj(std::ostream& out, const Diagram& diagram, const ExportOptions& options = {});

/// One table of vertices and edges, with the columns type, index, x, y, radius, circle1, circle2, circle3, start, end:
/// of a vertex its disc and three circles, of an edge its left and right circle and its vertices, -1 for infinity.
/// `digits`: how many the discs have after the decimal point at most, from 0; by default all.
void writeDiagramCsv(std::ostream& out, const Diagram& diagram, std::optional<int> digits = {});

}  // namespace circle_voronoi
