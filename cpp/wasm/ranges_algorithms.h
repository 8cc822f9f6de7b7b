// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Included before every source of the WebAssembly build: the algorithms of std::ranges that the core uses and that the
// standard library of Emscripten 3.1.6 (libc++ 13) lacks. Each takes a whole range, a comparison or a predicate, and a
// projection, and calls the algorithm of std. A library that has them says so by __cpp_lib_ranges.
#include <version>

#ifndef __cpp_lib_ranges
#include <algorithm>
#include <functional>
#include <iterator>
#include <ranges>
#include <utility>

namespace std::ranges {
namespace algorithms {

template <class Compare, class Projection>
auto byProjection(Compare& compare, Projection& projection) {
  return [&](auto&& one, auto&& other) -> bool {
    return std::invoke(compare, std::invoke(projection, one), std::invoke(projection, other));
  };
}

template <class Predicate, class Projection>
auto ofProjection(Predicate& predicate, Projection& projection) {
  return [&](auto&& item) -> bool { return std::invoke(predicate, std::invoke(projection, item)); };
}

}  // namespace algorithms

template <class Range, class Compare = less, class Projection = identity>
void sort(Range&& range, Compare compare = {}, Projection projection = {}) {
  std::sort(begin(range), end(range), algorithms::byProjection(compare, projection));
}

template <class Range, class Compare = less, class Projection = identity>
void stable_sort(Range&& range, Compare compare = {}, Projection projection = {}) {
  std::stable_sort(begin(range), end(range), algorithms::byProjection(compare, projection));
}

template <class Range, class Middle, class Compare = less, class Projection = identity>
void partial_sort(Range&& range, Middle middle, Compare compare = {}, Projection projection = {}) {
  std::partial_sort(begin(range), middle, end(range), algorithms::byProjection(compare, projection));
}

template <class Range, class Nth, class Compare = less, class Projection = identity>
void nth_element(Range&& range, Nth nth, Compare compare = {}, Projection projection = {}) {
  std::nth_element(begin(range), nth, end(range), algorithms::byProjection(compare, projection));
}

template <class Range, class Compare = less, class Projection = identity>
auto min_element(Range&& range, Compare compare = {}, Projection projection = {}) {
  return std::min_element(begin(range), end(range), algorithms::byProjection(compare, projection));
}

template <class Range, class Compare = less, class Projection = identity>
auto max_element(Range&& range, Compare compare = {}, Projection projection = {}) {
  return std::max_element(begin(range), end(range), algorithms::byProjection(compare, projection));
}

template <class Range, class Predicate, class Projection = identity>
auto partition_point(Range&& range, Predicate predicate, Projection projection = {}) {
  return std::partition_point(begin(range), end(range), algorithms::ofProjection(predicate, projection));
}

template <class Range, class Value, class Compare = less, class Projection = identity>
auto lower_bound(Range&& range, const Value& value, Compare compare = {}, Projection projection = {}) {
  return partition_point(range, [&](auto&& item) -> bool { return std::invoke(compare, item, value); }, projection);
}

template <class Range, class Value, class Compare = less, class Projection = identity>
auto upper_bound(Range&& range, const Value& value, Compare compare = {}, Projection projection = {}) {
  return partition_point(range, [&](auto&& item) -> bool { return !std::invoke(compare, value, item); }, projection);
}

template <class Range, class Predicate, class Projection = identity>
auto find_if(Range&& range, Predicate predicate, Projection projection = {}) {
  return std::find_if(begin(range), end(range), algorithms::ofProjection(predicate, projection));
}

template <class Range, class Value, class Projection = identity>
auto find(Range&& range, const Value& value, Projection projection = {}) {
  return find_if(range, [&](auto&& item) -> bool { return item == value; }, projection);
}

template <class Range, class Predicate, class Projection = identity>
bool all_of(Range&& range, Predicate predicate, Projection projection = {}) {
  return std::all_of(begin(range), end(range), algorithms::ofProjection(predicate, projection));
}

template <class Range, class Predicate, class Projection = identity>
bool any_of(Range&& range, Predicate predicate, Projection projection = {}) {
  return std::any_of(begin(range), end(range), algorithms::ofProjection(predicate, projection));
}

template <class Range, class Predicate, class Projection = identity>
bool none_of(Range&& range, Predicate predicate, Projection projection = {}) {
  return std::none_of(begin(range), end(range), algorithms::ofProjection(predicate, projection));
}

template <class Range, class Predicate, class Projection = identity>
auto count_if(Range&& range, Predicate predicate, Projection projection = {}) {
  return std::count_if(begin(range), end(range), algorithms::ofProjection(predicate, projection));
}

template <class Range, class Function, class Projection = identity>
void for_each(Range&& range, Function function, Projection projection = {}) {
  for (auto&& item : range) std::invoke(function, std::invoke(projection, item));
}

/// What is left over after the unique items, as a range.
template <class Range, class Compare = equal_to, class Projection = identity>
auto unique(Range&& range, Compare compare = {}, Projection projection = {}) {
  return subrange(std::unique(begin(range), end(range), algorithms::byProjection(compare, projection)), end(range));
}

template <class Range>
void reverse(Range&& range) {
  std::reverse(begin(range), end(range));
}

template <class Range, class Value>
void fill(Range&& range, const Value& value) {
  std::fill(begin(range), end(range), value);
}

template <class Range, class Output>
void copy(Range&& range, Output output) {
  std::copy(begin(range), end(range), output);
}

template <class Range, class Output>
void move(Range&& range, Output output) {
  std::move(begin(range), end(range), output);
}

}  // namespace std::ranges
#endif
