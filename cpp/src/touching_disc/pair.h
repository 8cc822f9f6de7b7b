// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "circle_voronoi/trace.h"
#include "sample.h"

namespace circle_voronoi {

/// Two circles that get an antipodal disc, the lower index first.
using Pair = std::array<int, 2>;

/// The most pairs: each has two slots in the event loop, with 32-bit indices.
inline constexpr std::int64_t kMaxPairs = std::numeric_limits<std::int32_t>::max() / 2;

/// The pairs of circles that have neighboring or coinciding samples in the Delaunay graph of the samples (paper,
/// section 4.1), each once, in lexicographic order. Refuses (guarded.h) more than kMaxPairs, tooManyCircles. Reports
/// the finished part to `progress` from time to time, and each edge of that graph and each pair to `observer`.
std::vector<Pair> pairNeighbors(const Samples& samples, int circleCount, const ProgressCallback& progress = {},
                                const Observer& observer = {});

/// Every pair, in lexicographic order.
std::vector<Pair> pairAll(int circleCount);

}  // namespace circle_voronoi
