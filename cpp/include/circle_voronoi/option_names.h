// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/compute.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

// What options of `compute` and their values are called outside C++: in JavaScript, on the command line (--NAME), in
// files and in the documents.

template <class Value>
struct Named {
  std::string_view name;
  Value value;
};

inline constexpr auto kMethods = std::to_array<Named<Method>>(
    {{"auto", Method::automatic}, {"touching-disc", Method::touchingDisc}, {"flip", Method::flip}});
inline constexpr auto kCandidates = std::to_array<Named<Candidates>>(
    {{"dynamic", Candidates::dynamic}, {"uniform", Candidates::uniform}, {"all-pairs", Candidates::allPairs}});

/// The table of a value's type.
constexpr const auto& valuesLike(Method) { return kMethods; }
constexpr const auto& valuesLike(Candidates) { return kCandidates; }

template <class Value>
constexpr std::string_view nameOf(Value value) {
  const auto& values = valuesLike(value);
  return std::find_if(values.begin(), values.end(), [&](const auto& named) { return named.value == value; })->name;
}

/// The options that are values, each with its field.
inline constexpr std::tuple kOptions = {
    Named<bool Options::*>{"weights", &Options::weights}, Named<Method Options::*>{"method", &Options::method},
    Named<Candidates Options::*>{"candidates", &Options::candidates},
    Named<int Options::*>{"samples", &Options::samples}, Named<bool Options::*>{"resample", &Options::resample}};

/// The name of an option by its field.
template <class Value>
constexpr std::string_view nameOf(Value Options::*field) {
  std::string_view name;
  const auto look = [&]<class Other>(const Named<Other Options::*>& option) {
    if constexpr (std::is_same_v<Other, Value>) {
      if (option.value == field) name = option.name;
    }
  };
  std::apply([&](const auto&... option) { (look(option), ...); }, kOptions);
  return name;
}

}  // namespace circle_voronoi
