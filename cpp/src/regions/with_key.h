// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace circle_voronoi {

/// The items with a key, among items sorted by it. (The result of std::ranges::equal_range does not compile with Clang
/// 14 and the standard library of GCC.)
template <class Item, class Key, class KeyOf>
std::span<const Item> withKey(const std::vector<Item>& items, const Key& key, KeyOf keyOf) {
  const auto first = std::ranges::lower_bound(items, key, {}, keyOf);
  const auto last = std::ranges::upper_bound(items, key, {}, keyOf);
  return std::span(items).subspan(static_cast<std::size_t>(first - items.begin()),
                                  static_cast<std::size_t>(last - first));
}

}  // namespace circle_voronoi
