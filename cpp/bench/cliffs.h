// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// Prints a table of what `auto` takes for each of the families (all, if there are none named), and for each with an
/// outlier, with duplicates and in two far clusters, for each number of circles: the processor time per circle, its
/// ratio to the time of uniform circles (the median of three runs), its ratio to the time at the first number of
/// circles, the way taken, and how signs were decided, per circle. Marks entries that take more than 3 times as long as
/// uniform circles, or 15 times where more than three circles touch one disc or most signs are ties or nearly so. Also
/// marks entries over the time limit.
void printCliffs(const std::vector<std::string>& names, const std::vector<std::size_t>& sizes, unsigned limitSeconds);
