// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "chosen.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"

namespace circle_voronoi {

/// Returns for each vertex of a certified diagram the vertex of smallest index that edges of length near zero connect
/// it to, as `mergeVertices` does by default. The library of files takes it from this one.
CIRCLE_VORONOI_API std::vector<std::int32_t> firstVerticesHere(const Diagram& diagram);
/// Returns for each row of some vertices the smallest row that short edges connect it to, of some edges. The ends of
/// these are among the vertices.
std::vector<std::int32_t> firstVerticesHere(const Diagram& diagram, const Chosen& edges, const Chosen& vertices);

}  // namespace circle_voronoi
