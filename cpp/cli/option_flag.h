// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "circle_voronoi/option_names.h"

namespace circle_voronoi::cli {

/// How an option of `compute` is given on the command line.
template <class Value>
std::string flagOf(Value Options::*field) {
  return "--" + std::string(nameOf(field));
}

/// The values that an option of `compute` may have, by their names.
template <class Values>
auto choicesOf(const Values& values) {
  std::map<std::string, decltype(values[0].value)> choices;
  for (const auto& [name, value] : values) choices.emplace(name, value);
  return choices;
}

}  // namespace circle_voronoi::cli
