// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "circle_voronoi/diagram.h"
#include "construct.h"

namespace circle_voronoi {

/// The diagram of `circles`, the input: turns indices of sites into those of the input, gives every vertex its disc,
/// and links the sides. The circles of the diagram are rounded (limits.h).
Diagram diagramOf(std::span<const Circle> circles, State state, Threads threads = Threads());

}  // namespace circle_voronoi
