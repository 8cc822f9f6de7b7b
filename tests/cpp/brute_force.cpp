// SPDX-License-Identifier: GPL-3.0-or-later
#include "brute_force.h"

#include <algorithm>

#include "exact.h"
#include "three_touch_disc.h"

namespace circle_voronoi::test {
namespace {

bool isEmpty(const Vertex& disc, std::span<const Circle> circles, const std::array<CircleIndex, 3>& touched) {
  for (std::size_t i = 0; i < circles.size(); ++i) {
    if (std::ranges::find(touched, static_cast<std::int32_t>(i)) != touched.end()) continue;
    const Vector v = {circles[i].x - disc.x, circles[i].y - disc.y};
    if (length(v) - circles[i].r < disc.r) return false;
  }
  return true;
}

}  // namespace

std::vector<std::array<CircleIndex, 3>> bruteForceVertices(std::span<const Circle> circles) {
  const auto n = static_cast<std::int32_t>(circles.size());
  std::vector<std::array<CircleIndex, 3>> vertices;
  for (std::int32_t i = 0; i < n; ++i) {
    for (std::int32_t j = i + 1; j < n; ++j) {
      for (std::int32_t k = i + 1; k < n; ++k) {
        if (k == j) continue;
        const auto disc = threeTouchDisc(circles[i], circles[j], circles[k]);
        if (disc && isEmpty(disc->disc, circles, {i, j, k})) vertices.push_back({i, j, k});
      }
    }
  }
  return vertices;
}

std::vector<HiddenCircle> hiddenByDefinition(std::span<const Circle> circles) {
  std::vector<HiddenCircle> hidden;
  const auto count = static_cast<std::int32_t>(circles.size());
  for (std::int32_t j = 0; j < count; ++j) {
    std::int32_t by = kNone;
    for (std::int32_t i = 0; i < count; ++i) {
      const bool isFirst = circles[i].r > circles[j].r || i < j;
      if (i == j || !isFirst || !exact::contains(circles[i], circles[j])) continue;
      if (by == kNone || circles[i].r > circles[by].r) by = i;
    }
    if (by != kNone) hidden.push_back({j, by});
  }
  return hidden;
}

}  // namespace circle_voronoi::test
