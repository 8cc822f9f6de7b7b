// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>

#include "circle_voronoi/editor.h"

namespace circle_voronoi::cli {

/// Writes a change as one line of JSON: its way, and its lists as flat ones, by the names that they have in JavaScript.
/// Numbers to the bit.
void writeChange(std::ostream& out, const Change& change);

}  // namespace circle_voronoi::cli
