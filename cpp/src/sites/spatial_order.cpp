// SPDX-License-Identifier: GPL-3.0-or-later
#include "spatial_order.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace circle_voronoi {
namespace {

constexpr int kHilbertBits = 16;
constexpr int kDigitBits = 11;

struct Keyed {
  std::uint32_t key;
  int index;
};

/// Position along the Hilbert curve of order kHilbertBits (H. S. Warren, "Hacker's Delight", section 16-2).
std::uint32_t hilbertKey(std::uint32_t x, std::uint32_t y) {
  std::uint32_t key = 0;
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

/// A stable sort by the key, digit by digit.
void sortByKey(std::vector<Keyed>& items) {
  std::vector<Keyed> other(items.size());
  for (int shift = 0; shift < 2 * kHilbertBits; shift += kDigitBits) {
    std::array<std::size_t, (1u << kDigitBits) + 1> first{};
    const auto digit = [shift](const Keyed& item) {
      return static_cast<std::size_t>((item.key >> shift) & ((1u << kDigitBits) - 1));
    };
    for (const Keyed& item : items) ++first[digit(item) + 1];
    for (std::size_t d = 1; d < first.size(); ++d) first[d] += first[d - 1];
    for (const Keyed& item : items) other[first[digit(item)]++] = item;
    items.swap(other);
  }
}

}  // namespace

std::vector<int> spatialOrder(std::span<const Point> points) {
  if (points.empty()) return {};
  Point low = points[0];
  Point high = points[0];
  for (const Point& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double size = std::max(high.x - low.x, high.y - low.y);
  const double cells = size > 0 ? ((1u << kHilbertBits) - 1) / size : 0;
  std::vector<Keyed> items(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto x = static_cast<std::uint32_t>((points[i].x - low.x) * cells);
    const auto y = static_cast<std::uint32_t>((points[i].y - low.y) * cells);
    items[i] = {hilbertKey(x, y), static_cast<int>(i)};
  }
  if (items.size() > (1u << kDigitBits)) {
    sortByKey(items);
  } else {
    std::stable_sort(items.begin(), items.end(), [](const Keyed& a, const Keyed& b) { return a.key < b.key; });
  }
  std::vector<int> order;
  order.reserve(items.size());
  for (const Keyed& item : items) order.push_back(item.index);
  return order;
}

}  // namespace circle_voronoi
