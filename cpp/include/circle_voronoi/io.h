// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"

namespace circle_voronoi {

/// Reads circles from text: CSV lines `x,y,r` (a header line and blank lines are allowed), or JSON
/// `[[x,y,r],...]` or `[{"x":..,"y":..,"r":..},...]`. Text whose first character is `[` or `{` is JSON.
///
/// Errors: badInput, with one sentence that starts with `name:line:`. Values are only read, not judged: `compute`
/// rejects negative radii and the like.
Result<std::vector<Circle>> readCircles(std::string_view text, std::string_view name);

/// Writes a diagram in the project's JSON format, version 1 (README). Reading a number back gives the same bits.
void writeJson(std::ostream& out, std::span<const Circle> circles, const Diagram& diagram);

/// Writes the `stats` object of that format alone.
void writeStatsJson(std::ostream& out, const Stats& stats);

}  // namespace circle_voronoi
