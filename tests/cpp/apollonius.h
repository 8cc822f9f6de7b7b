// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "circle_voronoi/circle.h"
#include "dual.h"

namespace circle_voronoi {

/// The dual by CGAL's Apollonius_graph_2 with exact predicates: always right in general position, slow.
/// The circles must not hide one another. Empty if there are fewer than three.
Dual apolloniusGraph(std::span<const Circle> circles);

}  // namespace circle_voronoi
