// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

namespace circle_voronoi {

/// Told now and then which part of some work is done, from 0 to 1; what it throws ends the work.
using Done = std::function<void(double)>;

/// What tells `whole` that of its part from `from` to `to` a part is done; empty if `whole` is. It refers to `whole`.
inline Done partOf(const Done& whole, double from, double to) {
  if (!whole) return {};
  return [&whole, from, to](double done) { whole(from + (to - from) * done); };
}

/// Calls function(i) for each i below `count`, and tells now and then between.
template <class Function>
void forEachIndex(std::size_t count, const Done& tell, Function function) {
  constexpr std::size_t kPerReport = 1 << 18;
  for (std::size_t begin = 0; begin < count;) {
    const std::size_t end = std::min(count, begin + kPerReport);
    for (std::size_t i = begin; i < end; ++i) function(i);
    if (tell && end < count) tell(static_cast<double>(end) / static_cast<double>(count));
    begin = end;
  }
}

}  // namespace circle_voronoi
