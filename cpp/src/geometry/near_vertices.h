// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"

namespace circle_voronoi {

/// Returns for each vertex of a certified diagram the vertex of smallest index that edges of length near zero connect
/// it to, as `mergeVertices` does by default. The library of files takes it from this one.
CIRCLE_VORONOI_API std::vector<std::int32_t> firstVerticesHere(const Diagram& diagram);

}  // namespace circle_voronoi
