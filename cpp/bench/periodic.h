// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace circle_voronoi::bench {

/// Prints the times of computePeriodic, of compute for the circles alone, and of compute for the circles and their
/// images.
void benchPeriodic(const std::vector<std::string>& families, const std::vector<std::size_t>& sizes, int repetitions);

}  // namespace circle_voronoi::bench
