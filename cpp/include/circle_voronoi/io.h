// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/periodic.h"
#include "circle_voronoi/region.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

struct ReadOptions {
  bool weights = false;  ///< whether radii may be negative (Options::weights)
  bool points = false;   ///< whether circles may lack r, which is 0 then; a table has a header
};

/// Reads circles from UTF-8 text. The text may begin with a byte-order mark. Lines end in LF, CRLF or CR. The first
/// character tells the format:
///
/// - `[` begins JSON: `[[x,y,r],...]` or `[{"x":..,"y":..,"r":..},...]`.
/// - `{` begins a GeoJSON FeatureCollection of Points with a property `radius` or `r`.
/// - Anything else is a table (CSV) with a line for each circle.
///
/// In a table, commas, semicolons, tabs or spaces separate the fields, whichever occurs in the first line. Fields may
/// be in quotation marks. Empty lines and lines that begin with `#` are skipped. The first line may name the columns,
/// in any order and case: x, cx, lon or longitude; y, cy, lat or latitude; r, rad or radius. Other columns are ignored.
/// Without such a line there are three columns: x, y, r. If commas do not separate the fields, or inside quotation
/// marks, commas may be decimal marks. A text has one kind of decimal mark.
///
/// `name` is what errors call the text. Each message is one sentence that starts with `name:line:`.
/// Errors: badInput, also for an empty text and for a line of a table longer than 64 MiB; and what `compute` would
/// reject, so that the message can name the line: nonFinite, negativeRadius, coordinateTooLarge, tooManyCircles.
Result<std::vector<Circle>> readCircles(std::string_view text, std::string_view name, const ReadOptions& options = {});

/// Reads what a text that `readCircles` accepts says about its circles beyond x, y and r: the other columns of a table,
/// the other properties of GeoJSON points, the other members of JSON objects. Returns for each circle the members of a
/// JSON object, without braces and on one line, for ExportOptions::attributes. Circles may lack r
/// (ReadOptions::points).
///
/// Fields of a table become numbers where they are numbers of JSON, otherwise strings, and null where they are empty. A
/// name that `writeGeoJson` uses itself, such as area, gets `input_` in front. Errors: badInput.
Result<std::vector<std::string>> readAttributes(std::string_view text, std::string_view name);

/// Reads one number for each circle of a text that `readCircles` accepts: a column of a table, a property of GeoJSON
/// points, or a member of JSON objects. Errors: badInput, also if a circle has no such number.
Result<std::vector<double>> readNumbers(std::string_view text, std::string_view name, std::string_view column);

/// Reads a region from UTF-8 text: a GeoJSON Polygon, MultiPolygon, Feature or FeatureCollection of these, or
/// well-known text (POLYGON or MULTIPOLYGON). Coordinates beyond the second of a position are ignored.
///
/// `name` is what errors call the text. Messages about the syntax start with `name:line:`, others with `name:`.
/// Errors: badInput; also those of Region::fromPolygons.
Result<Region> readRegion(std::string_view text, std::string_view name);

// The functions below write circles so that `readCircles` reads them back to the same bits: as CSV with a header line,
// as JSON objects, and as GeoJSON Points with the properties circle (the index) and r. Radii may be negative
// (ReadOptions::weights).
//
// Errors: nonFinite, coordinateTooLarge, tooManyCircles, badArithmetic; notWritten if the stream fails. If the stream
// throws, its exception passes through.

Result<void> writeCirclesCsv(std::ostream& out, std::span<const Circle> circles);
Result<void> writeCirclesJson(std::ostream& out, std::span<const Circle> circles);
Result<void> writeCirclesGeoJson(std::ostream& out, std::span<const Circle> circles);

/// Writes a diagram in the project's JSON format, version 1 (README). It records whether radii are weights.
///
/// `digits` is the largest number of digits that vertices and their radii have after the decimal point, from 0. Circles
/// keep all their digits. By default all numbers read back to the same bits. If you round vertices too far, `certify`
/// rejects them.
///
/// Errors: badOption if `digits` is negative; badInput if there are not as many vertexCircles as vertices; notWritten
/// if the stream fails.
Result<void> writeJson(std::ostream& out, const Diagram& diagram, std::optional<int> digits = {});

/// Writes a periodic diagram in the same format, with three more members: lattice, the two periods; images, for each
/// circle of the diagram its given circle and its shift, the given circles first; neighbors, for each given circle the
/// images beside it, with shifts relative to it. `readDiagram` reads it as the diagram of the images.
Result<void> writePeriodicJson(std::ostream& out, const PeriodicDiagram& periodic, std::optional<int> digits = {});

/// Reads a diagram in the format of `writeJson`, to the bit. Unknown keys are skipped. Of `stats` whatever is present
/// is read, except for the certificate: call `certify` to get one. If the diagram fits together, its sides are linked
/// (linkSides). The indices need not fit the circles.
///
/// Errors: those of `readCircles`; badInput also for another format or version.
Result<Diagram> readDiagram(std::string_view text, std::string_view name);

/// Returns whether a text is meant for `readDiagram` and not for `readCircles`: a JSON object with the key `format`, as
/// far as it is well-formed, and no key of GeoJSON before that.
[[nodiscard]] bool holdsDiagram(std::string_view text);

/// Writes only the `stats` object of the format of `writeJson`.
/// Errors: notWritten if the stream fails.
Result<void> writeStatsJson(std::ostream& out, const Diagram& diagram);

}  // namespace circle_voronoi
