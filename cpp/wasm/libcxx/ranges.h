// SPDX-License-Identifier: GPL-3.0-or-later
// The range algorithms that the library uses, taken from range-v3, because <algorithm> lacks them before version 15 of
// libc++. Included before every source, because libc++ includes <algorithm> itself before it has declared what range-v3
// needs.
#pragma once
#include <algorithm>

#if _LIBCPP_VERSION < 15000
#include <range/v3/algorithm/adjacent_find.hpp>
#include <range/v3/algorithm/all_of.hpp>
#include <range/v3/algorithm/any_of.hpp>
#include <range/v3/algorithm/binary_search.hpp>
#include <range/v3/algorithm/copy.hpp>
#include <range/v3/algorithm/count.hpp>
#include <range/v3/algorithm/equal.hpp>
#include <range/v3/algorithm/equal_range.hpp>
#include <range/v3/algorithm/find.hpp>
#include <range/v3/algorithm/find_if.hpp>
#include <range/v3/algorithm/find_if_not.hpp>
#include <range/v3/algorithm/for_each.hpp>
#include <range/v3/algorithm/is_sorted.hpp>
#include <range/v3/algorithm/lower_bound.hpp>
#include <range/v3/algorithm/max.hpp>
#include <range/v3/algorithm/max_element.hpp>
#include <range/v3/algorithm/min_element.hpp>
#include <range/v3/algorithm/move.hpp>
#include <range/v3/algorithm/none_of.hpp>
#include <range/v3/algorithm/partial_sort.hpp>
#include <range/v3/algorithm/partition_point.hpp>
#include <range/v3/algorithm/replace_if.hpp>
#include <range/v3/algorithm/reverse.hpp>
#include <range/v3/algorithm/sort.hpp>
#include <range/v3/algorithm/transform.hpp>
#include <range/v3/algorithm/upper_bound.hpp>
#include <span>

namespace std::ranges {
using ::ranges::adjacent_find;
using ::ranges::all_of;
using ::ranges::any_of;
using ::ranges::binary_search;
using ::ranges::copy;
using ::ranges::count;
using ::ranges::equal;
using ::ranges::equal_range;
using ::ranges::find;
using ::ranges::find_if;
using ::ranges::find_if_not;
using ::ranges::for_each;
using ::ranges::is_sorted;
using ::ranges::lower_bound;
using ::ranges::max;
using ::ranges::max_element;
using ::ranges::min_element;
using ::ranges::move;
using ::ranges::none_of;
using ::ranges::partial_sort;
using ::ranges::partition_point;
using ::ranges::replace_if;
using ::ranges::reverse;
using ::ranges::sort;
using ::ranges::transform;
using ::ranges::upper_bound;

/// Sorts by std::stable_sort, whose code is half as large as that of range-v3.
struct StableSort {
  template <class Range, class Compare = ::ranges::less, class Projection = ::ranges::identity>
  void operator()(Range&& range, Compare compare = {}, Projection projection = {}) const {
    const auto isBefore = [&](const auto& a, const auto& b) {
      return ::ranges::invoke(compare, ::ranges::invoke(projection, a), ::ranges::invoke(projection, b));
    };
    std::stable_sort(::ranges::begin(range), ::ranges::end(range), isBefore);
  }
};
inline constexpr StableSort stable_sort;
}  // namespace std::ranges
#endif
