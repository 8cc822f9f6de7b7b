// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "threads.h"
#include "vectors.h"

namespace circle_voronoi {

/// Returns the indices of points in an order along a Hilbert curve. Equal points follow one another in the order given.
/// Neighbors in the plane are then mostly neighbors in memory, which saves half the time of all later stages. Where
/// many points share a cell of the curve, they are ordered along a curve of their own, and so on. This keeps the order
/// good even for very uneven points. It is the same on every platform. CGAL's own sort rests on std::nth_element, whose
/// order differs between libraries.
std::vector<int> spatialOrder(std::span<const Point> points, Threads threads = Threads());

}  // namespace circle_voronoi
