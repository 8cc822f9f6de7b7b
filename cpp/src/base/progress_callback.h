// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

namespace circle_voronoi {

/// A callback that is called now and then with the part of some work that is done, from 0 to 1. An exception that it
/// throws ends the work.
using ProgressCallback = std::function<void(double)>;

/// Returns a callback for the part of the work from `from` to `to`, which reports to `whole`. It is empty if `whole` is
/// empty. `whole` must outlive it.
inline ProgressCallback partOf(const ProgressCallback& whole, double from, double to) {
  if (!whole) return {};
  return [&whole, from, to](double done) { whole(from + (to - from) * done); };
}

/// Calls function(i) for each i below `count`, and tells now and then between.
template <class Function>
void forEachIndex(std::size_t count, const ProgressCallback& tell, Function function) {
  constexpr std::size_t kPerReport = 1 << 18;
  for (std::size_t begin = 0; begin < count;) {
    const std::size_t end = std::min(count, begin + kPerReport);
    for (std::size_t i = begin; i < end; ++i) function(i);
    if (tell && end < count) tell(static_cast<double>(end) / static_cast<double>(count));
    begin = end;
  }
}

}  // namespace circle_voronoi
