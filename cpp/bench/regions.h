// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace circle_voronoi::bench {

/// Prints the times to make a region and to clip a diagram to it, as multiples of the time of `compute`. The regions
/// are generated coastlines around most of the circles. There is a line for each number of circles and sides.
void benchRegions(const std::vector<std::string>& families, const std::vector<std::size_t>& sizes,
                  const std::vector<std::size_t>& sides, int repetitions);

}  // namespace circle_voronoi::bench
