// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/export.h"
#include "circle_voronoi/io.h"

namespace circle_voronoi {

/// The circles of one part of a large input. Ids tell which circles of the whole input they are.
struct Tile {
  std::vector<Circle> circles;
  /// The id of each circle, from 0. Ids increase, because the order of the circles decides which parts are final.
  std::vector<std::int64_t> ids;
  /// For each circle, whether its parts are already written, or are written elsewhere.
  std::vector<std::uint8_t> done;
};

/// Reads a tile from a table like `readCircles`, with two optional columns. `id` or `fid` has integers from 0; by
/// default the rows are numbered from 0. `done` has 0 or 1; by default 0. The circles are sorted by id.
///
/// Errors: see `readCircles`; badInput also if the text is JSON, or two circles have the same id.
CIRCLE_VORONOI_API Result<Tile> readTile(std::string_view text, std::string_view name, const ReadOptions& options = {});

/// Reads the table of `readTile` piece by piece, for any number of circles. It needs memory for one piece. Circles come
/// in the order of the lines. The circles and the first error do not depend on where the text is cut into pieces.
///
/// Errors: see `readTile`, except that equal ids are allowed; badInput also if the first 64 MiB have neither a header
/// nor a circle.
class CIRCLE_VORONOI_API TileStream {
 public:
  explicit TileStream(std::string name, const ReadOptions& options = {});
  TileStream(TileStream&&) noexcept;
  TileStream& operator=(TileStream&&) noexcept;
  ~TileStream();

  /// Reads a piece. Returns the circles of the lines that it completes, or a later piece does if a record of more than
  /// 4 KiB spans several pieces.
  Result<Tile> read(std::string_view piece);
  /// Ends the text. Returns the circle of the last line if that has no line end.
  Result<Tile> end();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// The circles whose parts are written, and their ids. The spans must outlive the selection.
struct Selection {
  std::span<const std::int64_t> ids;       ///< the id of each circle, increasing; empty: ids are indices
  std::span<const std::uint8_t> isChosen;  ///< whether each circle is chosen; empty: all are

  [[nodiscard]] std::int64_t id(CircleIndex circle) const {
    return ids.empty() || circle == kNone ? std::int64_t{circle} : ids[static_cast<std::size_t>(circle)];
  }
  [[nodiscard]] bool contains(CircleIndex circle) const {
    return isChosen.empty() || isChosen[static_cast<std::size_t>(circle)] != 0;
  }
};

// The functions below fail with badInput if a span of the selection, or a list of the tile, does not have an entry for
// each circle, and with notWritten if the stream fails.

/// Writes the chosen circles as a table that `readTile` reads, with the columns id, x, y, r and done.
CIRCLE_VORONOI_API Result<void> writeTile(std::ostream& out, const Tile& tile, std::span<const std::uint8_t> isChosen);

/// Writes the parts of the diagram that the chosen circles own, one a line. A vertex and an edge belong to their circle
/// with the lowest id. Hence all tiles together have the lines of the whole diagram, in another order. The columns are
/// type, x, y, r, circle1, circle2, circle3, circle4:
///
/// - vertex: its disc and its three circles counter-clockwise, from the lowest id. No other vertex has these three
///   circles in this order.
/// - edge: its left circle, which has the lower id, and its right circle; then the third circles of the vertices where
///   it starts and ends, -1 for infinity.
/// - hidden: a circle, and the circle that hides it.
CIRCLE_VORONOI_API Result<void> writePartsCsv(std::ostream& out, const Diagram& diagram, const Selection& selection);

/// Writes the features of `writeGeoJsonLines` for the chosen circles only, with ids in place of indices. Errors: see
/// also `writeGeoJsonLines`.
CIRCLE_VORONOI_API Result<void> writePartsGeoJsonLines(std::ostream& out, const Diagram& diagram,
                                                       const Selection& selection, const ExportOptions& options = {});

}  // namespace circle_voronoi
