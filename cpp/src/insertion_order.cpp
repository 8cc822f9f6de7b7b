// SPDX-License-Identifier: GPL-3.0-or-later
#include "insertion_order.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>

namespace circle_voronoi {
namespace {

constexpr int kHilbertBits = 29;
constexpr int kRounds = 32;

/// A fixed mixing of the index (splitmix64), in place of a random number.
std::uint64_t mix(std::uint64_t i) {
  i += 0x9e3779b97f4a7c15u;
  i = (i ^ (i >> 30)) * 0xbf58476d1ce4e5b9u;
  i = (i ^ (i >> 27)) * 0x94d049bb133111ebu;
  return i ^ (i >> 31);
}

/// Three points in four go to the last round, three in four of the rest to the one before, and so on.
std::uint64_t roundOf(std::size_t i) {
  return static_cast<std::uint64_t>(kRounds - 1 - std::min(kRounds - 1, std::countr_zero(mix(i) | (1ull << 62)) / 2));
}

/// Position along the Hilbert curve of order kHilbertBits (J. Warren, "Hacker's Delight", section 16-2).
std::uint64_t hilbertKey(std::uint32_t x, std::uint32_t y) {
  std::uint64_t key = 0;
  for (int bit = kHilbertBits - 1; bit >= 0; --bit) {
    const std::uint32_t right = (x >> bit) & 1;
    const std::uint32_t upper = (y >> bit) & 1;
    key = (key << 2) | ((3 * right) ^ upper);
    if (upper == 0) {
      if (right == 1) {
        x = ~x;
        y = ~y;
      }
      std::swap(x, y);
    }
  }
  return key;
}

}  // namespace

std::vector<int> insertionOrder(std::span<const Point> points) {
  if (points.empty()) return {};
  Point low = points[0];
  Point high = points[0];
  for (const Point& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double size = std::max(high.x - low.x, high.y - low.y);
  const double cells = size > 0 ? ((1u << kHilbertBits) - 1) / size : 0;

  std::vector<std::pair<std::uint64_t, int>> keys(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto x = static_cast<std::uint32_t>((points[i].x - low.x) * cells);
    const auto y = static_cast<std::uint32_t>((points[i].y - low.y) * cells);
    keys[i] = {roundOf(i) << (2 * kHilbertBits) | hilbertKey(x, y), static_cast<int>(i)};
  }
  std::sort(keys.begin(), keys.end());

  std::vector<int> order;
  order.reserve(keys.size());
  for (const auto& [key, i] : keys) order.push_back(i);
  return order;
}

}  // namespace circle_voronoi
