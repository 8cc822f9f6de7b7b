// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "circle_voronoi/abi.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

/// The largest coordinate or radius of a circle, in absolute value.
inline constexpr double kCoordinateLimit = 1e150;
/// The largest coordinate of a region, in absolute value: a hundred times that of a circle. Areas still fit in a
/// double.
inline constexpr double kRegionLimit = 1e152;
/// kRegionLimit as messages write it.
inline constexpr const char* kRegionLimitText = "1e152";
/// The largest number of circles. Half-edges, six for each circle and more for samples, must fit in 32-bit indices.
inline constexpr std::size_t kMaxCircles = 100'000'000;
/// The largest number of sides of a region (Region).
inline constexpr std::size_t kMaxRegionSides = 100'000'000;
/// The largest number of circles for `Candidates::allPairs`: 50 million pairs.
inline constexpr std::size_t kMaxAllPairsCircles = 10'000;
/// The largest value of `Options::samples`.
inline constexpr int kMaxSamples = 1000;

}  // namespace circle_voronoi
