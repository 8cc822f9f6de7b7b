// SPDX-License-Identifier: GPL-3.0-or-later
// Choices without branches, for conditions that a processor would often predict wrongly.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace circle_voronoi {

/// Writes the numbers from `first` to before `end` that satisfy a condition to `chosen`, in their order. Returns their
/// count. `chosen` must have room for all numbers of the range.
template <class Number, std::size_t kRoom, class Condition>
std::size_t select(Number first, Number end, std::array<Number, kRoom>& chosen, Condition condition) {
  std::size_t count = 0;
  for (Number i = first; i < end; ++i) {
    chosen[count] = i;
    count += static_cast<std::size_t>(condition(i));
  }
  return count;
}

/// Returns the index of the smallest of three numbers; of equal numbers, the first.
inline std::size_t indexOfSmallest(const std::array<int, 3>& numbers) {
  const std::size_t firstOfTwo = numbers[1] < numbers[0] ? 1 : 0;
  return numbers[2] < std::min(numbers[0], numbers[1]) ? 2 : firstOfTwo;
}

/// Returns three items in their cyclic order, starting with the item at `first`.
template <class Item>
std::array<Item, 3> startingAt(const std::array<Item, 3>& items, std::size_t first) {
  return {items[first], items[(first + 1) % 3], items[(first + 2) % 3]};
}

}  // namespace circle_voronoi
