// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/numpy.h>

#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/point.h"

namespace circle_voronoi::python {

/// Arrays that Python hands over. The Python sources make them so; other arrays are refused.
using Doubles = pybind11::array_t<double, pybind11::array::c_style>;
using Ints = pybind11::array_t<std::int32_t, pybind11::array::c_style>;

/// Returns a read-only array of numbers whose memory belongs to `owner`: one row for each item, or one number if an
/// item is a single number.
template <class Number, class Item>
pybind11::array viewOf(std::shared_ptr<const void> owner, std::span<const Item> items) {
  static_assert(std::is_standard_layout_v<Item> && sizeof(Item) % sizeof(Number) == 0);
  constexpr auto kColumns = static_cast<pybind11::ssize_t>(sizeof(Item) / sizeof(Number));
  std::vector<pybind11::ssize_t> shape = {static_cast<pybind11::ssize_t>(items.size())};
  if (kColumns > 1) shape.push_back(kColumns);
  const pybind11::capsule base(new std::shared_ptr<const void>(std::move(owner)),
                               [](void* kept) { delete static_cast<std::shared_ptr<const void>*>(kept); });
  pybind11::array_t<Number> array(shape, reinterpret_cast<const Number*>(items.data()), base);
  pybind11::detail::array_proxy(array.ptr())->flags &= ~pybind11::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

/// Returns an array that owns its numbers, without a copy.
template <class Number, class Item>
pybind11::array arrayOf(std::vector<Item> items) {
  const auto owner = std::make_shared<const std::vector<Item>>(std::move(items));
  return viewOf<Number>(owner, std::span<const Item>(*owner));
}

/// Returns a copy of the rows of an array as circles or points, so that another thread can use them.
template <class Item>
std::vector<Item> itemsOf(const Doubles& array) {
  const auto* first = reinterpret_cast<const Item*>(array.data());
  return {first, first + array.size() / static_cast<pybind11::ssize_t>(sizeof(Item) / sizeof(double))};
}

inline std::vector<Circle> circlesOf(const Doubles& array) { return itemsOf<Circle>(array); }
inline std::vector<Point> pointsOf(const Doubles& array) { return itemsOf<Point>(array); }

}  // namespace circle_voronoi::python
