// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include "circle_voronoi/convex_polygon.h"
#include "circle_voronoi/tile.h"

namespace circle_voronoi::cli {

/// Cuts circles into the tiles of a square grid, one file each, in memory that does not grow with their number. The
/// core of a tile is its square, which is closed at its least coordinates and open at its greatest; what is known of it
/// is the square with a halo on all sides. A circle's home is the tile in whose core its center is, and it is in the
/// file of every tile of which the square around it meets what is known, so that circles outside reach into none of it.
class Tiler {
 public:
  /// `folder` is empty. Throws Failure, as do the others.
  Tiler(std::filesystem::path folder, double size, double halo);

  void add(const Tile& tile);

  /// Writes what is left, and last the list of the tiles, `tiles.txt`: a line for each that has a core with circles, by
  /// y and then x: the name of its file without `.csv`, how many circles are at home in it, its core and what is known
  /// of it as MINX,MINY,MAXX,MAXY. Returns how many there are.
  std::size_t finish();

 private:
  using Place = std::pair<std::int64_t, std::int64_t>;  ///< row and column
  struct Content {
    std::int64_t home = 0;  ///< circles at home
    bool isBegun = false;   ///< whether its file is
    std::string text;       ///< not yet in its file
  };
  /// The tiles that a circle is in, both ends included.
  struct Range {
    Place first;
    Place last;

    double count() const;
  };

  std::int64_t cellOf(double coordinate) const;
  Range rangeOf(const Circle& circle) const;
  void put(Content& content, const std::string& row);
  void addWide();
  void flush();
  void append(const std::string& file, const std::string& text) const;
  std::string fileOf(Place place) const;

  std::filesystem::path folder_;
  double size_;
  double halo_;
  std::map<Place, Content> tiles_;
  std::size_t waiting_ = 0;  ///< characters in all texts
  Content wide_;             ///< circles in so many tiles that they wait until it is known which of these there are
};

}  // namespace circle_voronoi::cli
