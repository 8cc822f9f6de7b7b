// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace circle_voronoi {

/// Returns the name of an attribute of the input among the properties of a feature. `writeGeoJson` writes some of its
/// own.
inline std::string attributeName(std::string_view name) {
  constexpr std::array<std::string_view, 5> kWritten = {"circle", "r", "area", "neighbors", "hiddenBy"};
  const bool isWritten = std::ranges::find(kWritten, name) != kWritten.end();
  return (isWritten ? "input_" : "") + std::string(name);
}

}  // namespace circle_voronoi
