// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/box.h"
#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/error.h"

namespace circle_voronoi {

/// A column of a table with a value for each row: JSON on one line, null if the row has none.
struct Column {
  std::string name;
  std::vector<std::string> values = {};
};

/// Columns of a file whose rows need not be circles.
struct Table {
  std::vector<Column> columns = {};
  std::vector<std::size_t> lines = {};  ///< for each row the line of the text where it is, from 1
};

/// Reads columns from UTF-8 text, in the given order and under the given names: those of a table (CSV) whose first line
/// names the columns, the members of objects in an array (JSON), or the properties of the features of a GeoJSON
/// FeatureCollection. `readCircleFile` describes the formats, and the type of the values of a table. Names are
/// case-insensitive. Strings have the same bytes if their texts are the same.
///
/// `name` is what errors call the text. Errors: badInput, also for a column that the first line or all objects lack;
/// messages start with `name:line:`.
CIRCLE_VORONOI_API Result<Table> readTable(std::string_view text, std::string_view name,
                                           std::span<const std::string> columns);

/// Returns the finite number of a value; nothing if the value is not one. It may be a number in quotation marks.
CIRCLE_VORONOI_API std::optional<double> numberOf(std::string_view value);

// The functions below write a table. All columns have the same number of rows. `polygons` has the polygons of each row.
//
// Errors: badInput if numbers of rows differ, or a value is not JSON on one line; notWritten if the stream fails. If
// the stream throws, its exception passes through.

/// Writes a table that `readTable` reads. A row without any value is an empty line, which readers skip.
CIRCLE_VORONOI_API Result<void> writeTableCsv(std::ostream& out, std::span<const Column> columns);

/// Writes an array of objects, which also have the member `polygons`: the coordinates of a MultiPolygon in GeoJSON.
CIRCLE_VORONOI_API Result<void> writeTableJson(std::ostream& out, std::span<const Column> columns,
                                               const ClippedPolygons& polygons);

/// Writes a GeoJSON FeatureCollection. The geometry of a row is a Polygon, a MultiPolygon, or null.
CIRCLE_VORONOI_API Result<void> writeTableGeoJson(std::ostream& out, std::span<const Column> columns,
                                                  const ClippedPolygons& polygons);

/// Writes the features of `writeTableGeoJson`, one a line, and nothing else.
CIRCLE_VORONOI_API Result<void> writeTableGeoJsonLines(std::ostream& out, std::span<const Column> columns,
                                                       const ClippedPolygons& polygons);

/// Draws nested polygons in a box, with y pointing up. `levels` has the level of each row, from 1. The polygons of a
/// level are a group of the class `level-1`, `level-2` and so on. The deepest level is filled, and the others are drawn
/// above it with wider strokes. The title of a polygon, which browsers show as a tooltip, has the values of its row.
CIRCLE_VORONOI_API Result<void> writeTableSvg(std::ostream& out, std::span<const Column> columns,
                                              const ClippedPolygons& polygons, std::span<const int> levels,
                                              const Box& box);

}  // namespace circle_voronoi
