// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "circle_voronoi/diagram.h"

namespace circle_voronoi {

/// What linkSides fills, as in Diagram.
struct Adjacency {
  std::vector<SideIndex> nextSide;
  std::vector<std::array<SideIndex, 3>> vertexSides;
  std::vector<SideIndex> firstSide;
};

/// Nothing if the vertices, edges and hull of a diagram do not fit together.
std::optional<Adjacency> adjacencyOf(const Diagram& diagram);

}  // namespace circle_voronoi
