// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "circle_voronoi/cells.h"
#include "clip.h"
#include "clip_parts.h"

namespace circle_voronoi {

/// Returns the part of a part of an edge within a distance of its circles, in the direction of the edge. Both cells of
/// the edge get the same bits.
std::optional<CurvePart> nearPart(const Diagram& diagram, EdgeIndex edge, const EdgeCurve& curve, double maxDistance);

/// Returns the outline of the part of a cell in the region and within the maximum distance of its circle. `loops` are
/// the loops of the cell in the region.
Outline nearOutline(const ClippedDiagram::Parts& parts, CircleIndex circle, const Loops& loops);

}  // namespace circle_voronoi
