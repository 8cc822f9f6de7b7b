// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "circle_voronoi/compute.h"
#include "circle_voronoi_families/families.h"

namespace circle_voronoi::test {

/// A way to a diagram that is compared with the exact one.
struct ComparedWay {
  Method method;
  Candidates candidates;
  int samples;
  bool resample;
  std::string name;
};

inline constexpr std::size_t kComparedWays = 6;
std::span<const ComparedWay, kComparedWays> comparedWays();

/// The circles of these families overlap and nearly or exactly touch one disc or line, or they are so far apart that a
/// distance is only rounding. Even with all pairs, rounding makes the touching disc method process discs in a wrong
/// order, so it is not tested on these families.
bool isBeyondTouchingDisc(Family family);

/// Input `trial` of a family: 10 to 100 circles, of the extreme family, which is meant for a few, 5 to 14.
std::vector<Circle> comparedInput(Family family, std::uint64_t seed, std::uint64_t trial);

/// The results of one family.
struct Mismatches {
  std::array<int, kComparedWays> wrong{};   ///< diagrams that differ from the exact one
  std::array<int, kComparedWays> passed{};  ///< mismatches that pass the paper's check: their leftover directed
                                            ///< edges form one cycle
  std::array<std::string, kComparedWays> firstProblem;
  std::string firstMisjudged;  ///< where the certificate and the comparison do not agree
};

/// Compares diagrams of every family with the exact ones, on all processors; in the order of `families()`.
std::vector<Mismatches> countMismatches(std::uint64_t seed, std::uint64_t trials);

}  // namespace circle_voronoi::test
