// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "circle_voronoi/circle.h"
#include "random.h"

namespace circle_voronoi::test {

/// Circles in special position, exactly: integers of a few digits.
struct TieKind {
  std::string_view name;
  std::vector<Circle> (*make)(std::size_t count, Random& random);
};

/// Grid points with small radii; on one circle, equal; touching one disc, from outside or around it; touching one line;
/// touching one another inside; on a line, equal; radii growing from column to column.
std::span<const TieKind> tieKinds();

/// Ways of disturbing exact ties.
enum class Disturbance {
  none,
  lastPlace,  ///< a few numbers moved to the next double
  slight,     ///< all numbers changed by up to 1e-12 of themselves
  scaled,     ///< times a power of ten from 1e-15 to 1e23, which rounds
  far,        ///< moved 1e7 to 1e15 away
  oneHuge,    ///< one circle 2^20 to 2^60 times as large and as far
  oneTiny,    ///< one circle drawn near to another: 2^-20 to 2^-90 of its distance
  allTiny,    ///< besideFarPoint
};
inline constexpr int kDisturbances = 8;

void disturb(std::vector<Circle>& circles, Disturbance disturbance, Random& random);

/// Adds a point at the limit of numbers: the circles' size is 1e-42 to 1e-29 of its distance.
std::vector<Circle> besideFarPoint(std::vector<Circle> circles, Random& random);

/// Returns circles that each contain the next one or miss doing so by a small slack, and a point at the limit of
/// numbers: the slacks are 1e-42 to 1e-29 of its distance.
std::vector<Circle> nestedTightly(std::size_t count, Random& random);

/// Moves circles into a square of side 2^10 around the origin and rounds coordinates and radii to multiples of 2^-10:
/// sums of these numbers are exact.
std::vector<Circle> onDyadicGrid(std::vector<Circle> circles);

/// Passes on `count` inputs of each kind, of 2 to 41 circles, disturbed in each way in turn, with the kind's name.
void forEachTie(std::uint64_t seed, std::uint64_t trials,
                const std::function<void(const std::vector<Circle>&, std::string_view kind)>& use);

}  // namespace circle_voronoi::test
