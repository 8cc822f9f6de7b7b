// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "option_names.h"

namespace circle_voronoi::cli {

/// Returns the name of an option of `compute` on the command line.
template <class Value>
std::string flagOf(Value Options::*field) {
  return "--" + std::string(nameOf(field));
}

/// Returns the values of an option of `compute` by their names.
template <class Value>
std::map<std::string, Value> choices() {
  std::map<std::string, Value> choices;
  for (const auto& [name, value] : namedValues<Value>()) choices.emplace(name, value);
  return choices;
}

}  // namespace circle_voronoi::cli
