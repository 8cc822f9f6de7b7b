// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"

namespace circle_voronoi {

/// Reads circles from text: CSV lines `x,y,r` (a header line and blank lines are allowed), or JSON
/// `[[x,y,r],...]` or `[{"x":..,"y":..,"r":..},...]`, or a GeoJSON FeatureCollection of Points with a property `radius`
/// or `r`. Text whose first character is `[` is JSON, and `{` GeoJSON.
///
/// Errors, each with one sentence that starts with `name:line:`: badInput, and, so that the line can be named, what
/// `compute` would reject (nonFinite, negativeRadius, coordinateTooLarge, tooManyCircles).
Result<std::vector<Circle>> readCircles(std::string_view text, std::string_view name);

// Each writes circles as `readCircles` reads them: CSV with a header line, JSON objects, GeoJSON Points with the
// properties circle (the index) and radius. Reading a number back gives the same bits.

void writeCirclesCsv(std::ostream& out, std::span<const Circle> circles);
void writeCirclesJson(std::ostream& out, std::span<const Circle> circles);
void writeCirclesGeoJson(std::ostream& out, std::span<const Circle> circles);

/// Writes a diagram in the project's JSON format, version 1 (README). Reading a number back gives the same bits.
void writeJson(std::ostream& out, std::span<const Circle> circles, const Diagram& diagram);

/// Circles and a diagram that is said to be theirs.
struct DiagramFile {
  std::vector<Circle> circles;
  Diagram diagram;
};

/// Reads what `writeJson` wrote, or anybody else in that format: numbers to the bit. Other keys than those of the
/// format are skipped, `stats` is read as far as it is there, and its certificate is not believed: that is for
/// `certify` to judge.
///
/// Errors as those of `readCircles`; badInput for another format or version as well. Indices need not fit the circles.
Result<DiagramFile> readDiagram(std::string_view text, std::string_view name);

/// Whether text is meant for `readDiagram` and not for `readCircles`: a JSON object with the key `format`, as far as it
/// is well-formed, and none of GeoJSON's before it.
bool holdsDiagram(std::string_view text);

/// Writes the `stats` object of that format alone.
void writeStatsJson(std::ostream& out, const Diagram& diagram);

}  // namespace circle_voronoi
