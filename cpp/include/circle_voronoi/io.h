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

namespace CIRCLE_VORONOI_API circle_voronoi {

struct ReadOptions {
  bool weights = false;  ///< whether radii may be negative (Options::weights)
};

/// Reads circles from UTF-8 text, which may begin with a byte-order mark; lines end in LF, CRLF or CR. Text whose first
/// character is `[` is JSON, `[[x,y,r],...]` or `[{"x":..,"y":..,"r":..},...]`; `{` begins a GeoJSON FeatureCollection
/// of Points with a property `radius` or `r`; all else is a table (CSV):
///
/// - A line for each circle; fields separated by commas, semicolons, tabs or spaces, whichever the first line has, and
///   perhaps in quotation marks. Lines that begin with `#` and lines without anything are passed over.
/// - The columns that the first line names, in any order and either case: x, cx, lon or longitude; y, cy, lat or
///   latitude; r, rad or radius. Other columns are ignored. Without such a line there are three columns: x, y, r.
/// - Where commas do not separate, or in quotation marks, they may be decimal marks; one text has one kind of these.
///
/// Errors, each with one sentence that starts with `name:line:`: badInput, also for a text without anything and for a
/// line of a table beyond 64 MiB, and, so that the line can be named, what `compute` would reject (nonFinite,
/// negativeRadius, coordinateTooLarge, tooManyCircles).
Result<std::vector<Circle>> readCircles(std::string_view text, std::string_view name, const ReadOptions& options = {});

// Each writes circles as `readCircles` reads them: CSV with a header line, JSON objects, GeoJSON Points with the
// properties circle (the index) and radius. Reading a number back gives the same bits.

void writeCirclesCsv(std::ostream& out, std::span<const Circle> circles);
void writeCirclesJson(std::ostream& out, std::span<const Circle> circles);
void writeCirclesGeoJson(std::ostream& out, std::span<const Circle> circles);

/// Writes a diagram in the project's JSON format, version 1 (README), which says of radii that are weights that they
/// are. Reading a number back gives the same bits, unless `digits` says how many vertices and their radii have after
/// the decimal point at most, from 0: circles keep theirs. `certify` takes vertices that are rounded far for wrong.
void writeJson(std::ostream& out, const Diagram& diagram, std::optional<int> digits = {});

/// Reads what `writeJson` wrote, or anybody else in that format: numbers to the bit. Other keys than those of the
/// format are skipped, `stats` is read as far as it is there, and its certificate is not believed: that is for
/// `certify` to judge. Sides are linked (linkSides) if the diagram fits together.
///
/// Errors as those of `readCircles`; badInput for another format or version as well. Indices need not fit the circles.
Result<Diagram> readDiagram(std::string_view text, std::string_view name);

/// Whether text is meant for `readDiagram` and not for `readCircles`: a JSON object with the key `format`, as far as it
/// is well-formed, and none of GeoJSON's before it.
bool holdsDiagram(std::string_view text);

/// Writes the `stats` object of that format alone.
void writeStatsJson(std::ostream& out, const Diagram& diagram);

}  // namespace circle_voronoi
