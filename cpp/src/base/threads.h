// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "circle_voronoi/error.h"

namespace circle_voronoi {

/// True if programs may have more than one thread. WebAssembly has one, and spares the code for others.
#ifdef CIRCLE_VORONOI_ONE_THREAD
inline constexpr bool kHasThreads = false;
#else
inline constexpr bool kHasThreads = true;
#endif

/// The number of threads that a computation may use. Threads only share out work whose result does not depend on how it
/// is shared out.
class Threads {
 public:
  /// Returns an error if there cannot be so many threads, badOption.
  static std::optional<Error> refusalOf(int count);

  /// `count` 0 means one for each hardware thread. Without support for threads it is always 1.
  explicit Threads(int count = 1);

  int count() const { return kHasThreads ? count_ : 1; }

  /// Calls task(i) for each i below `count`, each in one of the threads, and returns when all have ended. An exception
  /// of a task is rethrown here; some tasks may not have been called then.
  void run(std::size_t count, const std::function<void(std::size_t)>& task) const;

  /// Returns the number of ranges into which `forRanges` divides `count` items. For one thread it is one.
  std::size_t rangesOf(std::size_t items) const {
    if (!kHasThreads || count_ == 1) return 1;
    // Some more than there are threads, for not all take as long.
    return std::clamp(items / kFewItems, std::size_t{1}, 4 * static_cast<std::size_t>(count_));
  }

  /// Calls function(begin, end, range) for consecutive ranges that together cover all items.
  template <class Function>
  void forRanges(std::size_t items, Function function) const {
    const std::size_t ranges = rangesOf(items);
    if (ranges == 1) return function(std::size_t{0}, items, std::size_t{0});
    if constexpr (kHasThreads) {
      run(ranges, [&](std::size_t i) { function(beginOf(i, ranges, items), beginOf(i + 1, ranges, items), i); });
    }
  }

  /// Calls function(i) for each item.
  template <class Function>
  void forEach(std::size_t items, Function function) const {
    forRanges(items, [&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t i = begin; i < end; ++i) function(i);
    });
  }

  /// The first item for which a condition holds, or `items` if there is none.
  template <class Condition>
  std::size_t firstWhere(std::size_t items, Condition condition) const {
    std::vector<std::size_t> found(rangesOf(items), items);
    forRanges(items, [&](std::size_t begin, std::size_t end, std::size_t range) {
      std::size_t i = begin;
      while (i < end && !condition(i)) ++i;
      if (i < end) found[range] = i;
    });
    return *std::min_element(found.begin(), found.end());
  }

 private:
  /// To start a thread takes as long as a thousand of simple steps.
  static constexpr std::size_t kFewItems = 1024;

  static std::size_t beginOf(std::size_t range, std::size_t ranges, std::size_t items) {
    return range * (items / ranges) + std::min(range, items % ranges);
  }

  int count_;
};

}  // namespace circle_voronoi
