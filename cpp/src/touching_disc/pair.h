// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "sample.h"

namespace circle_voronoi {

/// Two circles that get an antipodal disc, the lower index first.
using Pair = std::array<int, 2>;

/// The pairs of circles that have neighbouring or coinciding samples in the Delaunay graph of the samples (paper,
/// section 4.1), each once, in lexicographic order.
std::vector<Pair> pairNeighbors(const Samples& samples, int circleCount);

/// Every pair, in lexicographic order.
std::vector<Pair> pairAll(int circleCount);

}  // namespace circle_voronoi
