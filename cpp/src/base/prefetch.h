// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "portable.h"

namespace circle_voronoi {

/// Number of steps by which a loop over edges or faces prefetches data that it reads in another order.
inline constexpr std::size_t kPrefetchAhead = 16;

/// Asks for an item's memory, which is read soon.
template <class Item>
void prefetch(std::span<const Item> items, std::size_t i) {
  prefetch(items.data() + i);
}
template <class Item>
void prefetch(const std::vector<Item>& items, std::size_t i) {
  prefetch(std::span(items), i);
}

}  // namespace circle_voronoi
