// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"
#include "construct.h"
#include "triangulate.h"

namespace circle_voronoi {

/// Turns indices of sites into those of the input and gives every vertex its disc, in the units of the input.
/// Error: coordinateTooLarge.
Result<Diagram> diagramOf(Construction construction, Sites sites, double unit);

/// That a vertex of a right diagram has no place among the doubles.
Error vertexBeyondDoubles(const std::array<std::int32_t, 3>& circles);

}  // namespace circle_voronoi
