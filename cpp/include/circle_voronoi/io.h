// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/attributes.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/index.h"
#include "circle_voronoi/periodic_diagram.h"
#include "circle_voronoi/region.h"

namespace circle_voronoi {

/// Whether the circles of a file have radii.
enum class Radii {
  needed,    ///< each circle must have one
  optional,  ///< 0 for a circle without one
  none,      ///< 0 for all circles; a column that is called r is one like others
};

/// Selects the circles of a file. Names of columns also select properties of GeoJSON points and members of JSON
/// objects. Names are case-insensitive. The columns of a table are also called #1, #2 and so on, unless one has that
/// name.
struct ReadOptions {
  bool weights = false;  ///< whether radii may be negative (Options::weights)
  Radii radii = Radii::needed;
  std::string x = {};        ///< the column of the x coordinates; empty: by its usual names
  std::string y = {};        ///< the column of the y coordinates; empty: by its usual names
  std::string radius = {};   ///< the column of the radii; empty: by its usual names
  std::string id = {};       ///< the column of the ids; empty: `id`
  bool skipInvalid = false;  ///< whether rows and features that are no circles are skipped rather than refused
  /// The coordinate reference system, such as EPSG:25832, or its URN; empty: as the file says. GeoJSON names it in the
  /// member `crs` of the collection, unless it is EPSG:4326, the default.
  std::string crs = {};
};

/// The circles of a file and their attributes.
struct CircleFile {
  std::vector<Circle> circles = {};
  CircleAttributes attributes = {};
  /// Whether x and y are called longitude and latitude, in any of the usual spellings, and are in their range: degrees,
  /// with which a plane is not what is meant (`computeSphere`).
  bool areDegrees = false;
  /// Why each row or feature was skipped (ReadOptions::skipInvalid). `circle` is its index in the file.
  std::vector<Error> skipped = {};
};

/// Reads circles from UTF-8 text. The text may begin with a byte-order mark. Lines end in LF, CRLF or CR. The first
/// character tells the format:
///
/// - `[` begins JSON: `[[x,y,r],...]` or `[{"x":..,"y":..,"r":..},...]`.
/// - `{` begins GeoJSON: a FeatureCollection, a Feature, a geometry, or one of the latter two a line. Features are
/// Points
///   with a property for the radius. Each point of a MultiPoint is a circle of its own.
/// - Anything else is a table (CSV) with a line for each circle.
///
/// In a table, commas, semicolons, tabs, vertical bars or spaces separate the fields, whichever occurs in the first
/// line. Fields may be in quotation marks. Empty lines and lines that begin with `#` are skipped. The first line may
/// name the columns, in any order and case: x, cx, lon, long, lng, longitude or easting; y, cy, lat, latitude or
/// northing; r, rad or radius. Without such a line there are three columns: x, y, r. If commas do not separate the
/// fields, or inside quotation marks, commas may be decimal marks. A text has one kind of decimal mark. In place of x
/// and y, a column of any name may have well-known text: POINT, or MULTIPOINT for several circles with the same
/// attributes. Well-known binary (WKB) in hexadecimal digits, as PostGIS prints it, is read like this text. If it has
/// an SRID, that is the reference system (ReadOptions::crs). A line `sep=;`, as Excel writes it, names the separator.
///
/// JSON and GeoJSON have the same names. If an object has several of these names, the first in these lists counts. The
/// last value of a name that is given twice counts.
///
/// `name` is what errors call the text. Each message is one sentence that starts with `name:line:`.
/// Errors: badInput, also for an empty text, for a line of a table longer than 64 MiB, and if all circles are skipped;
/// and what `compute` would reject, so that the message can name the line: nonFinite, negativeRadius,
/// coordinateTooLarge, coordinateTooSmall, tooManyCircles. badOption if x or y is named for GeoJSON, or for a wrong
/// crs.
CIRCLE_VORONOI_API Result<std::vector<Circle>> readCircles(std::string_view text, std::string_view name,
                                                           const ReadOptions& options = {});

/// Reads circles like `readCircles`, and what the file says about them.
///
/// All fields of a column of a table become values of one type. They are numbers if all are numerals of JSON, with the
/// decimal mark of the table; empty fields, NA, NaN and null are null then. They are booleans if all are true or false,
/// and values of JSON if all are objects or arrays. In all other columns they are strings, exactly as in the file. This
/// includes columns in which a number is in quotation marks or has a leading zero, and white space inside quotation
/// marks. Empty fields are null. Numbers keep all digits that are written. A name that is repeated gets the least
/// number from 2 that makes it new: a, a_2, a_3. A column without a name is called `column` and its number.
///
/// A column or member `id` (ReadOptions::id) is a property and also the id of the circle. A column or member `z` of
/// numbers is a property and also the height of the circle.
///
/// Errors: see `readCircles`; badInput also for a field that is not UTF-8.
CIRCLE_VORONOI_API Result<CircleFile> readCircleFile(std::string_view text, std::string_view name,
                                                     const ReadOptions& options = {});

/// Returns one number for each circle: a column, a property or a member.
/// Errors: badInput if a circle has no such number.
CIRCLE_VORONOI_API Result<std::vector<double>> numbersIn(const CircleAttributes& attributes, std::string_view column);

/// Reads a region from UTF-8 text: a GeoJSON Polygon, MultiPolygon, Feature or FeatureCollection of these, several of
/// these one a line, or well-known text (POLYGON, MULTIPOLYGON or a GEOMETRYCOLLECTION of these), also as well-known
/// binary in hexadecimal digits. Empty parts, an SRID, and coordinates beyond the second of a position are ignored.
///
/// `name` is what errors call the text. Messages about the syntax start with `name:line:`, others with `name:`.
/// Errors: badInput; see also Region::fromPolygons.
CIRCLE_VORONOI_API Result<Region> readRegion(std::string_view text, std::string_view name,
                                             const RegionOptions& options = {});

// The functions below write circles so that `readCircleFile` reads them back to the same bits, with their attributes:
// as CSV with a header line, as JSON objects, and as GeoJSON Points with the property r. Radii may be negative
// (ReadOptions::weights). Ids are the column or member `id`, or the id of the feature. Heights are the column or member
// `z`, or the third coordinate. A property whose name means something else to the reader gets `input_` in front.
//
// CSV and JSON have no place for CircleAttributes::collection, and its members type, features and bbox are not written.
// In CSV a value that is an object or an array is its JSON text, a property that a circle lacks is null, and a property
// without a name is called by its column.
//
// Errors: nonFinite, coordinateTooLarge, coordinateTooSmall, tooManyCircles, badArithmetic; badInput if the numbers of
// attributes and circles differ, or attributes are not JSON on one line; notWritten if the stream fails. If the stream
// throws, its exception passes through.

CIRCLE_VORONOI_API Result<void> writeCirclesCsv(std::ostream& out, std::span<const Circle> circles,
                                                const CircleAttributes& attributes = {});
CIRCLE_VORONOI_API Result<void> writeCirclesJson(std::ostream& out, std::span<const Circle> circles,
                                                 const CircleAttributes& attributes = {});
CIRCLE_VORONOI_API Result<void> writeCirclesGeoJson(std::ostream& out, std::span<const Circle> circles,
                                                    const CircleAttributes& attributes = {});

/// The cell of a point.
struct Found {
  CircleIndex circle = kNone;  ///< the nearest circle; kNone if there are no circles
  double distance = 0;         ///< the distance of the point from it
};

/// Writes the cells of points as a table (CSV) with a line for each point and the columns x, y, circle, circle_id,
/// distance, and those of the attributes of the points. `ids` are the ids of all circles (CircleAttributes::ids); if
/// there are none, there is no column circle_id.
/// Errors: badInput if the numbers of points, results and attributes differ; notWritten if the stream fails.
CIRCLE_VORONOI_API Result<void> writeFoundCsv(std::ostream& out, std::span<const Circle> points,
                                              const CircleAttributes& attributes, std::span<const Found> found,
                                              std::span<const std::string> ids = {});

/// Writes a diagram in the project's JSON format, version 1 (README). It records whether radii are weights.
///
/// `digits` is the largest number of digits that vertices and their radii have after the decimal point, from 0. Circles
/// keep all their digits. By default all numbers read back to the same bits. If you round vertices too far, `certify`
/// rejects them.
///
/// Errors: badOption if `digits` is negative; badInput if the numbers of vertexCircles and vertices differ; notWritten
/// if the stream fails.
CIRCLE_VORONOI_API Result<void> writeJson(std::ostream& out, const Diagram& diagram, std::optional<int> digits = {});

/// Writes a periodic diagram in the same format, with three more members: lattice, the two periods; images, for each
/// circle of the diagram its given circle and its shift, the given circles first; neighbors, for each given circle the
/// images beside it, with shifts relative to it. `readDiagram` reads it as the diagram of the images. `attributes` has
/// an entry for each given circle (writeDiagramFile).
CIRCLE_VORONOI_API Result<void> writePeriodicJson(std::ostream& out, const PeriodicDiagram& periodic,
                                                  std::optional<int> digits = {},
                                                  const CircleAttributes& attributes = {});

/// A diagram and the attributes of its circles.
struct DiagramFile {
  Diagram diagram = {};
  CircleAttributes attributes = {};
  bool isPeriodic = false;  ///< whether the circles include images, as those of a periodic diagram
};

/// Writes a diagram like `writeJson`, and attributes of its circles: a circle has the members `id`, `z` and
/// `properties`, and the diagram the member `collection`. Readers that do not know these members skip them.
/// Errors: see `writeJson`; badInput also if the numbers of attributes and circles differ, or attributes are not JSON.
CIRCLE_VORONOI_API Result<void> writeDiagramFile(std::ostream& out, const Diagram& diagram,
                                                 const CircleAttributes& attributes, std::optional<int> digits = {});

/// Reads a diagram in the format of `writeJson`, to the bit. Unknown keys are skipped. Members of `stats` may be
/// missing. The certificate is not read: call `certify` to get one. If the diagram fits together, its sides are linked
/// (linkSides). The indices need not fit the circles.
///
/// Errors: see `readCircles`; badInput also for another format or version.
CIRCLE_VORONOI_API Result<Diagram> readDiagram(std::string_view text, std::string_view name);

/// Reads a diagram like `readDiagram`, and what the file says about its circles.
CIRCLE_VORONOI_API Result<DiagramFile> readDiagramFile(std::string_view text, std::string_view name);

/// Returns whether a text is meant for `readDiagram` and not for `readCircles`: a JSON object, or the beginning of one,
/// with the key `format` and no key of GeoJSON before it.
[[nodiscard]] CIRCLE_VORONOI_API bool holdsDiagram(std::string_view text);

/// Writes only the `stats` object of the format of `writeJson`.
/// Errors: notWritten if the stream fails.
CIRCLE_VORONOI_API Result<void> writeStatsJson(std::ostream& out, const Diagram& diagram);

}  // namespace circle_voronoi
