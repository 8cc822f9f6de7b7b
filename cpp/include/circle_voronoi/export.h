// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/attributes.h"
#include "circle_voronoi/box.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/curve.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/periodic_diagram.h"
#include "circle_voronoi/point.h"
#include "circle_voronoi/region.h"

namespace circle_voronoi {

/// The part of a diagram to write, and the precision.
struct ExportOptions {
  /// The box to which cells and edges are clipped, one that `Region::from` accepts. By default it is the
  /// bounding box of the circles with a margin of a twentieth of its size. The circles are first grown by
  /// `maxDistance`, if that is given.
  std::optional<Box> bounds = {};
  /// The region to which cells and edges are clipped, in place of `bounds`. It must outlive the call. The box is then
  /// its bounding box. Cells that the boundary of the region crosses, and those beside them, keep all digits.
  const Region* region = nullptr;
  /// Cells and edges are cut at this distance from the nearest circle (`outlineWithin`). Finite and at most
  /// kRegionLimit in absolute value.
  std::optional<double> maxDistance = {};
  /// The largest distance between the written curves and the true ones. Finite and positive. By default a
  /// hundred-thousandth of the box.
  std::optional<double> tolerance = {};
  /// The largest number of digits that coordinates and areas have after the decimal point, from 0. By default the
  /// tolerance determines the number. With this option rounding may move points by more than the tolerance, and the
  /// default box grows to coordinates with that many digits.
  std::optional<int> digits = {};
  /// Names of circles in `writeSvg`: the first usual property such as name or label. Data of GeoJSON features beside
  /// their own properties (readCircleFile): other properties, the id of the feature,
  /// the height as the property `z`, and the members of the collection. A property with a name that `writeGeoJson` uses
  /// itself, such as area, gets `input_` in front. It must outlive the call.
  const CircleAttributes* attributes = nullptr;
  /// Maps each point to the point that `writeGeoJson`, `writeGeoJsonLines` and `writeWkt` write, for example to
  /// longitude and latitude. Long sides of polygons get more points, so that they stay within the tolerance. Polygons
  /// of neighbors still share their points. Empty: the point itself. The function may call any function of the
  /// library.
  std::function<Point(Point)> place = {};
};

/// Returns the box to which cells, edges and polygons are clipped if neither bounds nor a region are given: the default
/// of ExportOptions::bounds without digits. It is the same box in JavaScript, in Python and in the program.
[[nodiscard]] CIRCLE_VORONOI_API Box exportBox(std::span<const Circle> circles, std::optional<double> maxDistance = {});
/// Returns this box for the circles of a diagram. For Metric::power and a maximum distance there is room for the discs
/// in which cells are kept (outlineWithin).
[[nodiscard]] CIRCLE_VORONOI_API Box exportBox(const Diagram& diagram, std::optional<double> maxDistance = {});

// The functions below write a certified diagram to a stream. The polygons of cells are counter-clockwise and do not
// cross themselves. Polygons of neighbors share their points bit for bit. A cell that is narrower than the rounding of
// its vertices may have a polygon that crosses itself, or none. Such cells occur between circles that are tangent
// inside up to rounding. Each function takes about n log n steps for the size of diagram, region and text.
//
// The tolerance determines the number of decimals of coordinates. The last place is the largest power of ten for which
// rounding uses up at most a tenth of the tolerance. The following keep all their digits: points on the box, arcs of
// the hull, polygons that would collapse or cross themselves if they were rounded, radii and areas in GeoJSON, and all
// numbers in CSV. Reading these back gives the same bits. With ExportOptions::digits, areas are rounded, and points on
// the box are rounded along it.
//
// Errors: notCertified if the diagram is not certified; badInput if the arrays do not fit together; badOption if an
// option is out of range; notWritten if the stream fails; tooManyCircles if memory runs out. After the last two the
// stream may hold a part of the text. If the stream throws, its exception passes through.

/// Writes a drawing that fits the box, with y pointing up and nothing outside the box. It has the class circle-voronoi,
/// and groups of the classes cells, dual, circles, edges, vertices and hull. Curves are cubic Bezier curves, and arcs
/// of circles are arcs. Hidden circles have the class hidden. Circles that are too small to be seen and circles of
/// negative radius have the class point. The look of a group is attributes, which a style sheet of yours overrides.
/// Several drawings can be inlined in one page: no rule reaches beyond a drawing, and no ids meet. The drawing has a
/// title and a description for screen readers, and the name of a circle is the title (tooltip) of circle and cell.
CIRCLE_VORONOI_API Result<void> writeSvg(std::ostream& out, const Diagram& diagram, const ExportOptions& options = {});

/// A group of marks in a figure.
struct SvgLayer {
  std::string name;                ///< the class of the group
  std::vector<Point> points = {};  ///< strokes of length zero, as wide as the style sheet says
  std::vector<Circle> discs = {};
  std::vector<std::array<Point, 2>> segments = {};
  bool areArrows = false;            ///< whether segments have an arrowhead at their second point
  std::vector<EdgeCurve> arcs = {};  ///< bounded arcs
};

/// A drawing with more, or less, than a diagram has.
struct SvgFigure {
  ExportOptions frame;
  /// The groups that `writeSvg` draws.
  std::vector<std::string> groups = {"cells", "dual", "circles", "edges", "vertices", "hull"};
  std::vector<SvgLayer> layers = {};  ///< drawn above the groups, in this order
  std::string style;                  ///< rules of a style sheet, appended to the rules of `writeSvg`
  double pixels = 1000;               ///< the longer side of the drawing, in the unit of strokes and dots; positive
};

/// Writes a figure.
CIRCLE_VORONOI_API Result<void> writeSvgFigure(std::ostream& out, const Diagram& diagram, const SvgFigure& figure);

/// Writes the cells as GeoJSON (RFC 7946), with a feature for each circle. Its geometry is a Polygon, a MultiPolygon if
/// the box cuts the cell apart, or null if the circle is hidden or its cell lies outside the box. The properties are
/// circle, r, area, neighbors (circles), for clipped cells clipped (true), and for hidden circles hiddenBy. If bounds,
/// a region or a maximum distance is given, area is that of the part inside, and neighbors lists only circles that
/// share a part of an edge inside. Otherwise area is that of the whole cell, and null for an unbounded cell. The member
/// bbox of the collection is the box to which cells are cut, unless ExportOptions::place is given.
CIRCLE_VORONOI_API Result<void> writeGeoJson(std::ostream& out, const Diagram& diagram,
                                             const ExportOptions& options = {});

/// Writes the features of `writeGeoJson`, one a line, and nothing else. You can concatenate such texts.
CIRCLE_VORONOI_API Result<void> writeGeoJsonLines(std::ostream& out, const Diagram& diagram,
                                                  const ExportOptions& options = {});

/// Writes the cells as well-known text. Line i is the cell of circle i: POLYGON, MULTIPOLYGON or POLYGON EMPTY.
CIRCLE_VORONOI_API Result<void> writeWkt(std::ostream& out, const Diagram& diagram, const ExportOptions& options = {});

/// Writes Wavefront OBJ in the plane z = 0. The object `edges` has the edges as polylines. The object `cells` has the
/// cells as faces, with a group for each circle.
CIRCLE_VORONOI_API Result<void> writeObj(std::ostream& out, const Diagram& diagram, const ExportOptions& options = {});

/// Writes the cells as a table (CSV) with a line for each circle and the columns circle, x, y, r, area, perimeter,
/// neighbors (circles, with spaces between them), hiddenBy, and those of the attributes. Areas and perimeters of
/// unbounded cells are `inf`, unless bounds, a region or a maximum distance is given. They keep all digits, unless
/// ExportOptions::digits is given. Centers are mapped by ExportOptions::place, and the tolerance plays no role.
CIRCLE_VORONOI_API Result<void> writeCellsCsv(std::ostream& out, const Diagram& diagram,
                                              const ExportOptions& options = {});

/// Writes the vertices and edges as a table with the columns type, index, x, y, r, circle1, circle2, circle3, start,
/// end. A vertex has its disc and its three circles. An edge has its left and right circle and its vertices, -1 for
/// infinity. The diagram need not be certified.
///
/// `digits` is the largest number of digits that discs have after the decimal point, from 0. By default they have all.
CIRCLE_VORONOI_API Result<void> writeDiagramCsv(std::ostream& out, const Diagram& diagram,
                                                std::optional<int> digits = {});

// The functions below write the cells of the given circles of a periodic diagram. The box, the region and the maximum
// distance of the options must not be given. Errors: see the functions above; badOption.

/// Writes a drawing of the box with a margin around it. Cells and circles that cross a side of the box are drawn on
/// both sides. Images outside the box are dimmed. The given circles are the group given, which the drawing uses several
/// times.
CIRCLE_VORONOI_API Result<void> writePeriodicSvg(std::ostream& out, const PeriodicDiagram& periodic,
                                                 const ExportOptions& options = {});

/// Writes the cells as GeoJSON, whole, and around the circles where these were given. The properties are the same as in
/// `writeGeoJson` for a diagram, plus shifts, which lists the shift of each neighbor. A hidden circle also has
/// hiderShift.
CIRCLE_VORONOI_API Result<void> writePeriodicGeoJson(std::ostream& out, const PeriodicDiagram& periodic,
                                                     const ExportOptions& options = {});

/// Writes the features of `writeGeoJson`, one a line, and nothing else.
CIRCLE_VORONOI_API Result<void> writePeriodicGeoJsonLines(std::ostream& out, const PeriodicDiagram& periodic,
                                                          const ExportOptions& options = {});

/// Writes the contact table (contactTable) with the columns circle, neighbor, shift_a, shift_b, length, gap, area,
/// packing_fraction. The last two columns describe the circle. Hidden circles have no contacts and no line.
///
/// `digits` is the largest number of digits after the decimal point, from 0. By default all numbers have all digits.
CIRCLE_VORONOI_API Result<void> writeContactsCsv(std::ostream& out, const PeriodicDiagram& periodic,
                                                 std::optional<int> digits = {});

}  // namespace circle_voronoi
