// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace circle_voronoi {

/// Returns whether a text looks like well-known binary (WKB) in hexadecimal digits, as PostGIS prints a geometry
/// (EWKB).
bool isHexWkb(std::string_view text);

/// Returns the well-known text (EWKT) of a geometry that `isHexWkb` accepts. Throws ReadError.
std::string wktOfHexWkb(std::string_view hex);

}  // namespace circle_voronoi
