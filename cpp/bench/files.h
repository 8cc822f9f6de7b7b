// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace circle_voronoi::bench {

/// Times reading and writing of files against `compute` on the same circles, in one run, and prints a table: medians of
/// processor time, for each of the families at each number of circles.
void benchFiles(const std::vector<std::string>& families, const std::vector<std::size_t>& sizes, int repetitions);

}  // namespace circle_voronoi::bench
