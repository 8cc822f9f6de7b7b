// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

#include "circle_voronoi/tile.h"

namespace circle_voronoi {

/// The first line of the table of `writeTile`.
inline constexpr std::string_view kTileHeader = "id,x,y,r,done\n";

/// Writes circle i of a tile as a line of the table, with calls of `write` for texts and numbers.
template <class Write>
void writeTileRow(const Tile& tile, std::size_t i, Write write) {
  const auto& [x, y, r] = tile.circles[i];
  write(tile.ids[i]);
  for (const double number : {x, y, r}) {
    write(std::string_view(","));
    write(number);
  }
  write(std::string_view(tile.done[i] != 0 ? ",1\n" : ",0\n"));
}

}  // namespace circle_voronoi
