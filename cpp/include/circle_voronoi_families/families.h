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

namespace circle_voronoi {

/// Families of input circles for tests, benchmarks and demonstrations.
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
  // centers or circles in special position
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
  bool isDisjoint;    ///< no two circles overlap, except for rounding if they are tangent
  bool isDegenerate;  ///< up to rounding, more than three circles touch one disc, or circles share a tangent line
};

/// Returns all families, in the order of the enumeration.
[[nodiscard]] CIRCLE_VORONOI_API std::span<const FamilyInfo> families();

[[nodiscard]] CIRCLE_VORONOI_API std::string_view familyName(Family family);
/// Returns the family with a name; nothing if there is none.
[[nodiscard]] CIRCLE_VORONOI_API std::optional<Family> familyFromName(std::string_view name);

/// Returns exactly `count` circles of a family. The same arguments give the same bits on every platform.
[[nodiscard]] CIRCLE_VORONOI_API std::vector<Circle> generate(Family family, std::size_t count, std::uint64_t seed);

}  // namespace circle_voronoi
