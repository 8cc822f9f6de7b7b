// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "geometry.h"

namespace circle_voronoi {

/// An order in which points are quickly inserted into a triangulation: biased random rounds, each along a Hilbert curve
/// (N. Amenta, S. Choi, G. Rote, "Incremental constructions con BRIO", 2003).
/// CGAL's own spatial sort rests on std::nth_element, whose order differs between standard libraries; this one is the
/// same everywhere.
std::vector<int> insertionOrder(std::span<const Point> points);

}  // namespace circle_voronoi
