// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/queries.h"

#include <algorithm>
#include <numeric>

#include "scale.h"

namespace circle_voronoi {

std::vector<std::array<CircleIndex, 2>> neighborPairs(const Diagram& diagram) {
  // Grouped by the smaller index first. Each group is small.
  CircleIndex last;
  for (const Edge& edge : diagram.edges) last = std::max(last, std::min(edge.left, edge.right));
  std::vector<std::size_t> end(static_cast<std::size_t>(last) + 2);
  for (const Edge& edge : diagram.edges) ++end[static_cast<std::size_t>(std::min(edge.left, edge.right)) + 1];
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<std::array<CircleIndex, 2>> pairs(diagram.edges.size());
  for (const Edge& edge : diagram.edges) {
    const auto [smaller, larger] = std::minmax(edge.left, edge.right);
    pairs[end[static_cast<std::size_t>(smaller)]++] = {smaller, larger};
  }
  std::size_t begin = 0;
  for (const std::size_t stop : end) {
    std::sort(pairs.begin() + static_cast<std::ptrdiff_t>(begin), pairs.begin() + static_cast<std::ptrdiff_t>(stop));
    begin = stop;
  }
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

std::optional<ClosestPair> closestPair(const Diagram& diagram) {
  std::optional<ClosestPair> closest;
  for (const auto& [i, j] : neighborPairs(diagram)) {
    const Circle& c = diagram.circles[static_cast<std::size_t>(i)];
    const Circle& d = diagram.circles[static_cast<std::size_t>(j)];
    const double gap = lengthOf(between(c, d)) - c.r - d.r;
    if (!closest || gap < closest->gap) closest = {i, j, gap};
  }
  return closest;
}

}  // namespace circle_voronoi
