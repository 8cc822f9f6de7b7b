// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include "circle_voronoi/tile.h"

namespace circle_voronoi::cli {

/// Cuts circles into the tiles of a square grid, one file each, in memory that does not grow with their number. The
/// core of a tile is its square, closed at its least coordinates and open at its greatest. The known box is the square
/// with a halo on all sides. A circle's home is the tile whose core contains its center. The circle is in the file of
/// every tile whose known box meets its bounding square, so no circle missing from the file reaches into the known box.
class Tiler {
 public:
  /// `folder` must be empty. All functions throw CommandError.
  Tiler(std::filesystem::path folder, double size, double halo);

  void add(const Tile& tile);

  /// Writes the remaining text, then the list of tiles, `tiles.txt`. The list has a line for each tile with circles in
  /// its core, sorted by y and then x: the name of its file without `.csv`, the number of circles at home in it, its
  /// core and its known box as MINX,MINY,MAXX,MAXY. Returns the number of lines.
  std::size_t finish();

 private:
  using TileIndex = std::pair<std::int64_t, std::int64_t>;  ///< row and column
  struct Content {
    std::int64_t home = 0;  ///< circles at home
    bool isBegun = false;   ///< whether its file has been begun
    std::string text;       ///< text that is not yet in its file
  };
  /// The range of tiles that a circle belongs to, both ends included.
  struct Range {
    TileIndex first;
    TileIndex last;

    double count() const;
  };

  std::int64_t cellOf(double coordinate) const;
  Range rangeOf(const Circle& circle) const;
  void put(Content& content, const std::string& row);
  void addWide();
  void flush();
  void append(const std::string& file, const std::string& text) const;
  std::string fileOf(TileIndex place) const;

  std::filesystem::path folder_;
  double size_;
  double halo_;
  std::map<TileIndex, Content> tiles_;
  std::size_t waiting_ = 0;  ///< the number of characters in all texts
  Content wide_;             ///< circles that meet very many tiles; they wait until it is known which tiles exist
};

}  // namespace circle_voronoi::cli
