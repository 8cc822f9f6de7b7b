// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <span>
#include <vector>

namespace circle_voronoi {

/// The items, sorted by their keys, whose key is `wanted`. (The result of `std::ranges::equal_range` does not compile
/// with Clang 14 and the standard library of GCC.)
template <class Item, class Key, class KeyOf>
std::span<const Item> withKey(const std::vector<Item>& items, const Key& wanted, const KeyOf& keyOf) {
  const auto from = std::ranges::lower_bound(items, wanted, {}, keyOf);
  const auto to = std::ranges::upper_bound(from, items.end(), wanted, {}, keyOf);
  return {items.data() + (from - items.begin()), static_cast<std::size_t>(to - from)};
}

}  // namespace circle_voronoi
