// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>

#include "circle_voronoi/editor.h"

namespace circle_voronoi::cli {

/// Writes a change as one line of JSON: its way, and its lists flattened, with the names of JavaScript. Numbers keep
/// all digits.
void writeChange(std::ostream& out, const Change& change);

}  // namespace circle_voronoi::cli
