// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace circle_voronoi::bench {

/// Prints the times of computeSphere for caps uniform on the sphere and of compute for as many uniform circles.
void benchSphere(const std::vector<std::size_t>& sizes, int repetitions);

}  // namespace circle_voronoi::bench
