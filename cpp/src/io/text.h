// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/io.h"
#include "named_option.h"

namespace circle_voronoi {

/// Circles as read from text, each with the place in the text where it ends.
struct ParsedCircles {
  std::vector<Circle> circles;
  std::vector<std::size_t> offsets;
  std::vector<std::int64_t> ids;   ///< the ids of a tile (tile.h)
  std::vector<std::uint8_t> done;  ///< whether each circle of a tile is done
};

/// White space around a text; the last one begins a record (RFC 8142).
inline constexpr std::string_view kBlank = " \t\r\n\x1E";

/// Returns the first character of a text that `contentOf` returns.
inline char firstOf(std::string_view content) { return content[content.find_first_not_of(kBlank)]; }

/// The largest number of geometries inside one another: each level takes a part of the stack.
inline constexpr int kMostNested = 100;

/// The reason why reading ends, and its place in the text. The readers throw it, and their public functions turn it
/// into an Error.
struct ReadError {
  std::size_t offset;
  std::string reason;
  ErrorCode code = ErrorCode::badInput;
  std::int64_t circle = kNone;  ///< the index of the row, the feature or the item that is no circle
  OptionAdvice advice = {};     ///< what follows the reason, whatever length that has
};

/// The circles of a file, their attributes, and the errors of skipped rows.
struct ParsedFile {
  ParsedCircles parsed;
  CircleAttributes attributes;
  bool areDegrees = false;  ///< by the names of x and y
  std::string crs = {};     ///< the reference system that a table names (ReadOptions); empty: none
  std::vector<ReadError> skipped;
};

/// The rows of a table as read from text.
struct ParsedRows {
  std::vector<std::string> properties;  ///< members of JSON, without braces
  std::vector<std::size_t> offsets;     ///< the place of each row in the text
};

/// The text after a byte-order mark. Errors: badInput, if it is UTF-16, or nothing but white space.
Result<std::string_view> contentOf(std::string_view text, std::string_view name);

/// An error of code badInput about a place in a text, on one printable line: `name:line: reason`. Lines, from 1, end in
/// LF, CRLF or CR; there are `linesBefore` before the text.
Error errorAt(std::string_view name, std::string_view text, std::size_t offset, const std::string& reason,
              std::size_t linesBefore = 0);

/// Converts a ReadError into an Error of the same form.
Error errorAt(std::string_view name, std::string_view text, const ReadError& failure, std::size_t linesBefore = 0);

/// Converts errors whose places increase, in linear time.
std::vector<Error> errorsAt(std::string_view name, std::string_view text, std::span<const ReadError> failures);

/// Returns the error of `validate` with the line of the circle to blame; see ParsedCircles for `offsets`.
Error errorAtCircle(Error error, std::span<const std::size_t> offsets, std::string_view name, std::string_view text,
                    std::size_t linesBefore = 0);

/// Returns the lines of places that increase, from 1, in linear time.
std::vector<std::size_t> linesAt(std::string_view text, std::span<const std::size_t> offsets);

/// The number of line ends in the text.
std::size_t lineEnds(std::string_view text);

// Whether the attributes of circles are kept.
enum class Keep { circles, attributes };

/// A table of circles (io.h).
Result<ParsedFile> readCsv(std::string_view text, std::string_view name, const ReadOptions& options, Keep keep);

/// `[[x,y,r],...]` or `[{"x":..,"y":..,"r":..},...]`.
Result<ParsedFile> readJson(std::string_view text, std::string_view name, const ReadOptions& options, Keep keep);

/// A GeoJSON FeatureCollection of Points.
Result<ParsedFile> readGeoJson(std::string_view text, std::string_view name, const ReadOptions& options, Keep keep);

/// The rows of a table (CSV) whose first line names these columns. Throws ReadError.
ParsedRows readCsvRows(std::string_view text, std::span<const std::string> columns);

}  // namespace circle_voronoi
