// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "circle_voronoi/abi.h"

namespace circle_voronoi {

// The range of numbers. Coordinates, radii, weights and corners of regions are at most 2^96 in absolute value. Each is
// rounded once, where it enters, to a multiple of 2^-96 (1.3e-29); every number from 2^-44 (5.7e-14) up is one already.
// An input whose largest number is not 0 and is below 2^-56 (1.4e-17) is an error, because rounding would distort it.
// Differences are then 0 or between 2^-96 and 2^97, so that products of ten of them neither overflow nor underflow.

/// The largest coordinate, radius or weight of a circle and the largest coordinate of a region, in absolute value:
/// 2^96.
inline constexpr double kCoordinateLimit = 0x1p96;
/// kCoordinateLimit as messages write it.
inline constexpr const char* kCoordinateLimitText = "7.9e28 (2^96)";
/// Numbers are rounded to multiples of this.
inline constexpr double kCoordinateStep = 0x1p-96;
/// The largest number of an input is 0, or not below this.
inline constexpr double kSmallestInput = 0x1p-56;
/// kSmallestInput as messages write it.
inline constexpr const char* kSmallestInputText = "1.4e-17 (2^-56)";
/// The largest coordinate of a box and the largest `maxDistance`, in absolute value: sixteen times
/// that of a circle, so that there is a box around any circles.
inline constexpr double kRegionLimit = 0x1p100;
/// kRegionLimit as messages write it.
inline constexpr const char* kRegionLimitText = "1.2e30 (2^100)";
/// The largest number of circles. Half-edges, six for each circle and more for samples, must fit in 32-bit indices.
inline constexpr std::size_t kMaxCircles = 100'000'000;
/// The largest number of sides of a region (Region).
inline constexpr std::size_t kMaxRegionSides = 100'000'000;
/// The largest number of circles for `Candidates::allPairs`: 50 million pairs.
inline constexpr std::size_t kMaxAllPairsCircles = 10'000;
/// The largest value of `Options::samples`.
inline constexpr int kMaxSamples = 1000;

}  // namespace circle_voronoi
