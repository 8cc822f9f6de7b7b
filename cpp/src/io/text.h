// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/error.h"

namespace circle_voronoi {

/// Circles as read from text, each with the line, from 1, on which it ends.
struct NumberedCircles {
  std::vector<Circle> circles;
  std::vector<int> lines;
};

/// An error of code badInput: `name:line: reason`.
Error errorAt(std::string_view name, int line, const std::string& reason);

/// Lines `x,y,r`, the first of which may be the words x, y, r.
Result<NumberedCircles> readCsv(std::string_view text, std::string_view name);

/// `[[x,y,r],...]` or `[{"x":..,"y":..,"r":..},...]`; other keys of an object are skipped.
Result<NumberedCircles> readJson(std::string_view text, std::string_view name);

/// A GeoJSON FeatureCollection of Points with a property `radius` or `r`.
Result<NumberedCircles> readGeoJson(std::string_view text, std::string_view name);

}  // namespace circle_voronoi
