// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

namespace CIRCLE_VORONOI_API circle_voronoi {

/// Circles of a part of the whole, which go by their ids there.
struct Tile {
  std::vector<Circle> circles;
  std::vector<std::int64_t> ids;   ///< of each circle, from 0; increasing, as what is final depends on their order
  std::vector<std::uint8_t> done;  ///< of each circle: whether what it owns is written already, or elsewhere
};

/// Reads a tile from a table as `readCircles` does, with two columns more if a header names them: id or fid, whole
/// numbers from 0, else the rows are numbered from 0; and done, 0 or 1, else 0. The circles are put in the order of
/// their ids.
///
/// Errors: those of `readCircles`; badInput also if the text is JSON, or two circles have the same id.
Result<Tile> readTile(std::string_view text, std::string_view name, const ReadOptions& options = {});

/// Reads the same table piece by piece, in memory for a piece, as its lines come: any number of circles. The result
/// does not depend on where the text is divided into pieces: neither the circles nor the first error.
///
/// Errors: those of `readTile`, but equal ids; badInput also if the first 64 MiB have neither a header nor a circle.
class TileStream {
 public:
  explicit TileStream(std::string name, const ReadOptions& options = {});
  TileStream(TileStream&&) noexcept;
  TileStream& operator=(TileStream&&) noexcept;
  ~TileStream();

  /// The circles of the lines that this piece of the text completes, in their order.
  Result<Tile> read(std::string_view piece);
  /// Those of the last line, if it does not end.
  Result<Tile> end();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// Writes a table that `readTile` reads: the chosen circles, with the columns id, x, y, r and done.
void writeTile(std::ostream& out, const Tile& tile, std::span<const std::uint8_t> isChosen);

/// What the chosen circles own: of a vertex and of an edge the circle with the lowest id is the owner, of a cell and of
/// a hidden circle it is that circle. One line each, so that the lines of all tiles are those of the whole in another
/// order. The columns are type, x, y, radius, circle1, circle2, circle3, circle4:
///
/// - vertex: its disc and its three circles counter-clockwise, from the lowest id. No other vertex has these three in
///   this order.
/// - edge: its left circle, which has the lower id, and its right one; then the third circles of the vertices where it
///   starts and ends, -1 for infinity.
/// - hidden: a circle, and the one that hides it.
void writePartsCsv(std::ostream& out, const Diagram& diagram, const Selection& selection);

}  // namespace circle_voronoi
