// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "dual.h"
#include "random.h"

namespace circle_voronoi::test {

// Edits that keep a dual a triangulated sphere, but not that of its circles.

/// Flips random edges, where that is possible. Returns how many.
int flipRandomEdges(Dual& dual, int count, Random& random);

/// Gives `circle`, which has none, a cell of three edges inside a face.
void insertInFace(Dual& dual, int face, int circle);

/// Gives `circle`, which has none, a cell of two edges on half-edge h.
void insertOnEdge(Dual& dual, int h, int circle);

/// The dual of a diagram that is right, by the indices of the input.
Dual dualOf(const Diagram& diagram, std::size_t circleCount);

/// Gives a diagram another topology, with vertices to match.
void replaceTopology(Diagram& diagram, const Dual& dual, std::span<const Circle> circles);

}  // namespace circle_voronoi::test
