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

namespace circle_voronoi {

/// Circles as read from text, each with the place in the text where it ends.
struct PlacedCircles {
  std::vector<Circle> circles;
  std::vector<std::size_t> offsets;
  std::vector<std::int64_t> ids;   ///< of a tile (tile.h)
  std::vector<std::uint8_t> done;  ///< likewise
};

/// Why reading ends, and where in the text. Thrown inside the readers only; none lets it out.
struct ReadFailure {
  std::size_t offset;
  std::string reason;
};

/// The text after a byte-order mark. Errors: badInput, if it is UTF-16, or nothing but white space.
Result<std::string_view> contentOf(std::string_view text, std::string_view name);

/// An error of code badInput about a place in a text, on one printable line: `name:line: reason`. Lines, from 1, end in
/// LF, CRLF or CR; there are `linesBefore` before the text.
Error errorAt(std::string_view name, std::string_view text, std::size_t offset, const std::string& reason,
              std::size_t linesBefore = 0);

/// The error of `validate` with the line of the circle that it is about; `offsets` as those of PlacedCircles.
Error placed(Error error, std::span<const std::size_t> offsets, std::string_view name, std::string_view text,
             std::size_t linesBefore = 0);

/// How many lines end in the text.
std::size_t lineEnds(std::string_view text);

// `points`: ReadOptions::points.

/// A table of circles (io.h).
Result<PlacedCircles> readCsv(std::string_view text, std::string_view name, bool points);

/// `[[x,y,r],...]` or `[{"x":..,"y":..,"r":..},...]`; other keys of an object are skipped.
Result<PlacedCircles> readJson(std::string_view text, std::string_view name, bool points);

/// A GeoJSON FeatureCollection of Points with a property `radius` or `r`.
Result<PlacedCircles> readGeoJson(std::string_view text, std::string_view name, bool points);

}  // namespace circle_voronoi
