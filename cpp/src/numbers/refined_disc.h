// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/circle.h"
#include "homogeneous_disc.h"

namespace circle_voronoi {

/// What discOf finds, right to nearly all bits where a circle is far larger than its distance from the others, so that
/// the lengths of their common tangents, on which all rests, are lost in those of their distances and radii. Where
/// none is, it is that of discOf; else ten times the work.
CornerDisc refinedDiscOf(const Circle& c0, const Circle& c1, const Circle& c2);

}  // namespace circle_voronoi
