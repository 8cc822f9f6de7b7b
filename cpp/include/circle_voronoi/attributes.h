// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "circle_voronoi/abi.h"

namespace circle_voronoi {

/// The data of a file about its circles beyond x, y and r. Each list is empty or has an entry for each circle.
struct CircleAttributes {
  /// The other columns, properties or members: members of a JSON object, without braces and on one line.
  std::vector<std::string> properties = {};
  std::vector<std::string> ids = {};      ///< a string or a number in JSON; empty: the circle has no id
  std::vector<std::string> heights = {};  ///< the third coordinate, a number in JSON; empty: there is none
  /// The members of a GeoJSON FeatureCollection beside its features, such as `crs`, like an entry of `properties`.
  std::string collection = {};

  /// Returns whether there is nothing.
  [[nodiscard]] bool empty() const {
    return properties.empty() && ids.empty() && heights.empty() && collection.empty();
  }
};

}  // namespace circle_voronoi
