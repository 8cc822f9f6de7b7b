// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "circle_voronoi/point.h"

namespace circle_voronoi {

/// A POINT or a MULTIPOINT.
struct WktPoints {
  std::vector<Point> points;
  std::vector<std::string> heights;  ///< of each point, a number in JSON; empty: it has none
  std::string srid;                  ///< the number of its reference system (EWKT); empty: it names none
};

/// Reads a POINT or a MULTIPOINT as well-known text, or as well-known binary in hexadecimal digits; nothing if a text
/// is not one, or the geometry is empty.
std::optional<WktPoints> wktPoints(std::string_view text);

}  // namespace circle_voronoi
