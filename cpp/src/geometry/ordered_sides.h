// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

#include "edge_curve.h"

namespace circle_voronoi {

/// Collects the sides of a cell, counter-clockwise from one that depends on its neighbors alone, not on the numbers of
/// circles and edges: the one with the first neighbor (orderOf), and of several that with the first after it.
inline void orderedSides(const Diagram& diagram, CircleIndex circle, std::vector<SideIndex>& sides) {
  const auto all = diagram.sides(circle);
  sides.assign(all.begin(), all.end());
  // Two circles follow each other once at most around a vertex of the cell, and once at most around infinity.
  const auto key = [&](std::size_t k) {
    const SideIndex next = sides[k + 1 == sides.size() ? 0 : k + 1];
    return std::tuple(orderOf(diagram, diagram.neighborOf(sides[k])), orderOf(diagram, diagram.neighborOf(next)),
                      diagram.targetOf(sides[k]) == kNone);
  };
  std::size_t first = 0;
  for (std::size_t k = 1; k < sides.size(); ++k) {
    if (key(k) < key(first)) first = k;
  }
  std::rotate(sides.begin(), sides.begin() + static_cast<std::ptrdiff_t>(first), sides.end());
}

}  // namespace circle_voronoi
