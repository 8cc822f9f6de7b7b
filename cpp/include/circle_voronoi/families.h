// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/circle.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

/// Families of inputs for tests, benchmarks and demonstrations.
enum class Family {
  // disjoint circles of comparable or different sizes
  uniform,
  logUniform,
  points,
  mixed,
  dense,
  clustered,
  spiral,
  chaosDisjoint,
  farFromOrigin,
  tiny,
  // a few huge circles among small ones
  oneHuge,
  twoHuge,
  ring,
  ringVaried,
  rows,
  extreme,
  // circles that intersect or hide one another
  lightlyIntersecting,
  intersecting,
  hidden,
  duplicates,
  chaos,
  // centres or circles in special position
  collinear,
  collinearVaried,
  nearCollinear,
  grid,
  gridTangent,
  gridColumns,
  hexagonal,
  cocircularVaried,
  cocircularEqual,
  // far apart
  twoClusters,
  farClusters,
  outlier,
  lineAndHuge,
  farOutlier,
  longSpiral,
  growingLine,
  tangentChain,
  // circles that nearly hide one another, or are nested
  tangentInside,
  tangentOutside,
  tangentLine,
  commonPoint,
  nearNested,
  nestedTangent,
  concentric,
  cocircularLarge,
  onRim,
  wedge,
  twoCommonPoints,
  barelyOut,
};

struct FamilyInfo {
  Family family;
  std::string_view name;
  std::string_view description;
  bool isDisjoint;    ///< no two circles have an inner point in common, but for rounding where they are tangent
  bool isDegenerate;  ///< more than three circles touch one disc, but for rounding, or circles share a tangent line
};

/// All families, in the order of the enumeration.
std::span<const FamilyInfo> families();

std::string_view familyName(Family family);
std::optional<Family> familyFromName(std::string_view name);

/// Exactly `count` circles of a family. The same arguments give the same bits on every platform.
std::vector<Circle> generate(Family family, std::size_t count, std::uint64_t seed);

}  // namespace circle_voronoi
