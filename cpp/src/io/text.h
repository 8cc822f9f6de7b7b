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

namespace circle_voronoi {

/// Circles as read from text, each with the place in the text where it ends.
struct PlacedCircles {
  std::vector<Circle> circles;
  std::vector<std::size_t> offsets;
  std::vector<std::int64_t> ids;   ///< of a tile (tile.h)
  std::vector<std::uint8_t> done;  ///< whether each circle of a tile is done
};

/// Why reading ends, and where in the text. Thrown inside the readers only; none lets it out.
struct ReadFailure {
  std::size_t offset;
  std::string reason;
  ErrorCode code = ErrorCode::badInput;
  std::int64_t circle = kNone;  ///< the index of the row, the feature or the item that is no circle
};

/// The circles of a file, and the failures of skipped rows.
struct ReadCircles {
  PlacedCircles placed;
  CircleAttributes attributes;
  std::vector<ReadFailure> skipped;
};

/// The text after a byte-order mark. Errors: badInput, if it is UTF-16, or nothing but white space.
Result<std::string_view> contentOf(std::string_view text, std::string_view name);

/// An error of code badInput about a place in a text, on one printable line: `name:line: reason`. Lines, from 1, end in
/// LF, CRLF or CR; there are `linesBefore` before the text.
Error errorAt(std::string_view name, std::string_view text, std::size_t offset, const std::string& reason,
              std::size_t linesBefore = 0);

/// Reports a failure in the same form.
Error errorAt(std::string_view name, std::string_view text, const ReadFailure& failure, std::size_t linesBefore = 0);

/// Reports failures in the order of their places, in linear time.
std::vector<Error> errorsAt(std::string_view name, std::string_view text, std::span<const ReadFailure> failures);

/// Returns the error of `validate` with the line of the circle to blame; see ReadCircles for `offsets`.
Error placed(Error error, std::span<const std::size_t> offsets, std::string_view name, std::string_view text,
             std::size_t linesBefore = 0);

/// The number of line ends in the text.
std::size_t lineEnds(std::string_view text);

// Whether the attributes of circles are kept.
enum class Keep { circles, attributes };

/// A table of circles (io.h).
Result<ReadCircles> readCsv(std::string_view text, std::string_view name, const ReadOptions& options, Keep keep);

/// `[[x,y,r],...]` or `[{"x":..,"y":..,"r":..},...]`.
Result<ReadCircles> readJson(std::string_view text, std::string_view name, const ReadOptions& options, Keep keep);

/// A GeoJSON FeatureCollection of Points.
Result<ReadCircles> readGeoJson(std::string_view text, std::string_view name, const ReadOptions& options, Keep keep);

}  // namespace circle_voronoi
