// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace circle_voronoi::bench {

/// Prints what it takes to make a region and to clip a diagram to it, for generated coastlines around most of the
/// circles, against the time of `compute`; a line for each number of circles and of sides.
void benchRegions(const std::vector<std::string>& families, const std::vector<std::size_t>& sizes,
                  const std::vector<std::size_t>& sides, int repetitions);

}  // namespace circle_voronoi::bench
