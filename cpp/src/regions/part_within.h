// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "arc_within.h"
#include "circle_voronoi/cells.h"
#include "clip_parts.h"
#include "disc_loops.h"
#include "judge_within.h"

namespace circle_voronoi {

/// Returns the part of an arc of an edge within the maximum distance of its circles, in the direction of the edge.
std::optional<ArcWithin> arcWithin(const ClipParts& parts, const Arc& arc);

/// Returns the loops of the part of a cell in the region and within the maximum distance of its circle. `loops` are the
/// loops of the cell in the region. The exact signs of DistanceSigns decide how the rim of the disc runs through them.
LoopsWithin loopsWithin(const ClipParts& parts, CircleIndex circle, const Loops& loops);

/// Returns what the areas of the cell in the region and of its disc say about the area of that part. If the whole cell
/// in the region lies within the distance, its area is that of the part.
AreaBounds areaBounds(const ClipParts& parts, CircleIndex circle, const Loops& loops);

}  // namespace circle_voronoi
