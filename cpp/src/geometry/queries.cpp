// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/queries.h"

#include <algorithm>

#include "scale.h"

namespace circle_voronoi {

std::vector<std::array<std::int32_t, 2>> neighborPairs(const Diagram& diagram) {
  std::vector<std::array<std::int32_t, 2>> pairs;
  pairs.reserve(diagram.edges.size());
  for (const Edge& edge : diagram.edges) {
    pairs.push_back({std::min(edge.left, edge.right), std::max(edge.left, edge.right)});
  }
  std::ranges::sort(pairs);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

std::optional<ClosestPair> closestPair(std::span<const Circle> circles, const Diagram& diagram) {
  std::optional<ClosestPair> closest;
  for (const auto& [i, j] : neighborPairs(diagram)) {
    const Circle& c = circles[static_cast<std::size_t>(i)];
    const Circle& d = circles[static_cast<std::size_t>(j)];
    const double gap = lengthOf(between(c, d)) - c.r - d.r;
    if (!closest || gap < closest->gap) closest = {i, j, gap};
  }
  return closest;
}

}  // namespace circle_voronoi
