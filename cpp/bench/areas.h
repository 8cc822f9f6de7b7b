// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace circle_voronoi::bench {

/// Prints the times of fits of areas to random sites in the unit square: equal areas, areas over two decades, and both
/// again after one site has moved by a tenth of the mean distance. Each line has a process of its own.
void printAreas(const std::vector<std::size_t>& sizes, unsigned limitSeconds);

}  // namespace circle_voronoi::bench
