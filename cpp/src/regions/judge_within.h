// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "disc_loops.h"

namespace circle_voronoi {

/// Bounds of the area of a part of a cell. They are equal where nothing can be cut off.
struct AreaBounds {
  double least = 0;
  double most = 0;
};

/// Judges the part of a cell within the maximum distance, however it was cut. Returns a description of the first fault,
/// or nullptr:
/// - Entries and exits alternate around the rim, so each is an end of one arc of the rim and of one chain of pieces.
/// - Each loop has pieces, and each piece ends where the next one begins.
/// - Holes have no positive area and other loops no negative one, and the area of all is within its bounds, except for
///   rounding.
const char* faultOf(const LoopsWithin& loops, const AreaBounds& bounds, double rounding);

}  // namespace circle_voronoi
