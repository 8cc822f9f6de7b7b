// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

#include "circle_voronoi/options.h"

namespace circle_voronoi {

// The names of the options of `compute` and of their values outside C++: in JavaScript, on the command line (--NAME),
// in files and in the documentation.

template <class Value>
struct Named {
  std::string_view name;
  Value value;
};

inline std::string_view nameOf(Method method) { return methodName(method); }
inline std::string_view nameOf(Candidates candidates) { return candidatesName(candidates); }
inline std::string_view nameOf(Metric metric) { return metricName(metric); }

/// Returns all values of an enumeration.
template <class Value>
std::vector<Named<Value>> namedValues() {
  std::vector<Named<Value>> values;
  for (int i = 0; !nameOf(static_cast<Value>(i)).empty(); ++i) {
    values.push_back({nameOf(static_cast<Value>(i)), static_cast<Value>(i)});
  }
  return values;
}

/// The options that are values, each with its member.
inline constexpr std::tuple kOptions = {Named<bool Options::*>{"weights", &Options::weights},
                                        Named<Method Options::*>{"method", &Options::method},
                                        Named<Candidates Options::*>{"candidates", &Options::candidates},
                                        Named<std::optional<int> Options::*>{"samples", &Options::samples},
                                        Named<bool Options::*>{"resample", &Options::resample}};

/// Returns the name of an option by its member.
template <class Value>
constexpr std::string_view nameOf(Value Options::*member) {
  std::string_view name;
  const auto look = [&]<class Other>(const Named<Other Options::*>& option) {
    if constexpr (std::is_same_v<Other, Value>) {
      if (option.value == member) name = option.name;
    }
  };
  std::apply([&](const auto&... option) { (look(option), ...); }, kOptions);
  return name;
}

}  // namespace circle_voronoi
