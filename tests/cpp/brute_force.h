// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/index.h"

namespace circle_voronoi::test {

/// The vertices of the Voronoi diagram of a few circles in general position, straight from the definition: the ordered
/// triples, smallest index first, whose counter-clockwise disc touches them from outside and meets no other circle.
std::vector<std::array<CircleIndex, 3>> bruteForceVertices(std::span<const Circle> circles);

/// The hidden circles by the rule of HiddenCircle: every pair, in integers.
std::vector<HiddenCircle> hiddenByDefinition(std::span<const Circle> circles);

}  // namespace circle_voronoi::test
