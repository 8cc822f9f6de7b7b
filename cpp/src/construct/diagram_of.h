// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"
#include "construct.h"
#include "triangulate.h"

namespace circle_voronoi {

/// The diagram of `circles`, the input: turns indices of sites into those of the input, gives every vertex its disc, in
/// the units of the input, and links the sides.
/// Error: coordinateTooLarge.
Result<Diagram> diagramOf(std::span<const Circle> circles, Construction construction, Sites sites, double unit,
                          Threads threads = Threads());

/// Makes the error for a vertex of a right diagram that exceeds the largest double.
Error vertexBeyondDoubles(const std::array<CircleIndex, 3>& circles);

}  // namespace circle_voronoi
