// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace circle_voronoi {

/// Asks for an item's memory, which is read soon.
template <class Item>
void prefetch(std::span<const Item> items, std::size_t i) {
  __builtin_prefetch(items.data() + i);
}
template <class Item>
void prefetch(const std::vector<Item>& items, std::size_t i) {
  prefetch(std::span(items), i);
}

/// Visits 0 to count - 1 in order, and before that calls `early` and then `late` with indices ahead. Cells in the order
/// of the input lie all over the memory: these two ask for what a cell needs, `late` by what `early` asked for, so that
/// the visit does not wait.
template <class Early, class Late, class Visit>
void visitAhead(std::int32_t count, Early early, Late late, Visit visit) {
  constexpr std::int32_t kAhead = 3;
  for (std::int32_t i = 0; i < count; ++i) {
    if (count - i > 2 * kAhead) early(i + 2 * kAhead);
    if (count - i > kAhead) late(i + kAhead);
    visit(i);
  }
}

}  // namespace circle_voronoi
