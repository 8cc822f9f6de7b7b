// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi_families/families.h"

#include <array>

#include "generators.h"
#include "rounded.h"

namespace circle_voronoi {
namespace {

struct Entry {
  FamilyInfo info;
  Generator generator;
};

constexpr bool kDisjoint = true;
constexpr bool kOverlapping = false;
constexpr bool kGeneral = false;
constexpr bool kDegenerate = true;

// In the order of the enumeration.
// clang-format off
constexpr auto kEntries = std::to_array<Entry>({
    {{Family::uniform, "uniform", "radii 0.5 to 1, covering a quarter of a square (like figure 14: 100000 circles)", kDisjoint, kGeneral},
     generateUniform},
    {{Family::logUniform, "log-uniform", "radii over three decades, covering 30 % of a square", kDisjoint, kGeneral},
     generateLogUniform},
    {{Family::points, "points", "radius 0", kDisjoint, kGeneral},
     generatePoints},
    {{Family::mixed, "mixed", "radii 0.1 to 1, half of them points", kDisjoint, kGeneral},
     generateMixed},
    {{Family::dense, "dense", "each grows until it touches another", kDisjoint, kGeneral},
     generateDense},
    {{Family::clustered, "clustered", "Gaussian clusters", kDisjoint, kGeneral},
     generateClustered},
    {{Family::spiral, "spiral", "geometric growth over nine decades", kDisjoint, kGeneral},
     generateSpiral},
    {{Family::chaosDisjoint, "chaos-disjoint", "distances and radii over nine decades", kDisjoint, kGeneral},
     generateChaosDisjoint},
    {{Family::farFromOrigin, "far-from-origin", "uniform, with 1e7 added to x and y", kDisjoint, kGeneral},
     generateFarFromOrigin},
    {{Family::tiny, "tiny", "uniform, times 1e-9", kDisjoint, kGeneral},
     generateTiny},
    {{Family::oneHuge, "one-huge", "one of radius 1, the others tiny in a band around it", kDisjoint, kGeneral},
     generateOneHuge},
    {{Family::twoHuge, "two-huge", "a narrow gap between two, filled with tiny ones (figures 5d, 13a)", kDisjoint, kGeneral},
     generateTwoHuge},
    {{Family::ring, "ring", "equal ones around one (figure 7: 49 and 199 circles)", kDisjoint, kGeneral},
     generateRing},
    {{Family::ringVaried, "ring-varied", "the same at varied distances", kDisjoint, kGeneral},
     generateRingVaried},
    {{Family::rows, "rows", "small ones in a row below huge ones", kDisjoint, kGeneral},
     generateRows},
    {{Family::extreme, "extreme", "up to three huge ones that nearly touch, the rest squeezed near them", kDisjoint, kGeneral},
     generateExtreme},
    {{Family::lightlyIntersecting, "lightly-intersecting", "radii 0.1 to 0.3 at density 1", kOverlapping, kGeneral},
     generateLightlyIntersecting},
    {{Family::intersecting, "intersecting", "radii 0.3 to 0.8 at density 1", kOverlapping, kGeneral},
     generateIntersecting},
    {{Family::hidden, "hidden", "radii over three decades at density 1", kOverlapping, kGeneral},
     generateHidden},
    {{Family::duplicates, "duplicates", "a quarter copies, half of these of half the radius", kOverlapping, kGeneral},
     generateDuplicates},
    {{Family::chaos, "chaos", "distances over nine decades, any size up to the origin", kOverlapping, kGeneral},
     generateChaos},
    {{Family::collinear, "collinear", "equal ones with centers on a line", kDisjoint, kDegenerate},
     generateCollinear},
    {{Family::collinearVaried, "collinear-varied", "centers on a line", kDisjoint, kGeneral},
     generateCollinearVaried},
    {{Family::nearCollinear, "near-collinear", "a thousand times as wide as high", kDisjoint, kGeneral},
     generateNearCollinear},
    {{Family::grid, "grid", "equal ones on a square grid (figures 11: 4 circles, 15d)", kDisjoint, kDegenerate},
     generateGrid},
    {{Family::gridTangent, "grid-tangent", "the same, tangent to each other (figure 15e)", kDisjoint, kDegenerate},
     generateGridTangent},
    {{Family::gridColumns, "grid-columns", "radius growing from column to column (figure 15f)", kDisjoint, kDegenerate},
     generateGridColumns},
    {{Family::hexagonal, "hexagonal", "equal ones in a tangent packing", kDisjoint, kDegenerate},
     generateHexagonal},
    {{Family::cocircularVaried, "cocircular-varied", "tangent to one reference circle (figure 15a)", kDisjoint, kDegenerate},
     generateCocircularVaried},
    {{Family::cocircularEqual, "cocircular-equal", "the same, of equal radius (figures 10: 12 circles, 15b: 100)", kDisjoint, kDegenerate},
     generateCocircularEqual},
    {{Family::twoClusters, "two-clusters", "uniform, in two clusters 1e12 apart", kDisjoint, kGeneral},
     generateTwoClusters},
    {{Family::farClusters, "far-clusters", "uniform, in 20 clusters 1e6 apart", kDisjoint, kGeneral},
     generateFarClusters},
    {{Family::outlier, "outlier", "uniform, with one point at x = 1e9", kDisjoint, kGeneral},
     generateOutlier},
    {{Family::lineAndHuge, "line-and-huge", "centers on a line, and a huge one a million times its length away", kDisjoint, kGeneral},
     generateLineAndHuge},
    {{Family::farOutlier, "far-outlier", "uniform, with one point at x = 1e28", kDisjoint, kGeneral},
     generateFarOutlier},
    {{Family::longSpiral, "long-spiral", "geometric growth over 40 decades", kDisjoint, kGeneral},
     generateLongSpiral},
    {{Family::growingLine, "growing-line", "centers on a line, radii over 50 to 56 decades, every other one touches the next", kOverlapping, kGeneral},
     generateGrowingLine},
    {{Family::tangentChain, "tangent-chain", "centers on a line, radii over 50 to 56 decades, each touches the next", kOverlapping, kDegenerate},
     generateTangentChain},
    {{Family::tangentInside, "tangent-inside", "tangent to one reference circle from inside", kOverlapping, kDegenerate},
     generateTangentInside},
    {{Family::tangentOutside, "tangent-outside", "tangent to one reference circle from outside, over six decades", kOverlapping, kDegenerate},
     generateTangentOutside},
    {{Family::tangentLine, "tangent-line", "on one side of a line that they touch, over three decades", kOverlapping, kDegenerate},
     generateTangentLine},
    {{Family::commonPoint, "common-point", "through one point, over two decades", kOverlapping, kDegenerate},
     generateCommonPoint},
    {{Family::nearNested, "near-nested", "each barely sticks out of the next larger one", kOverlapping, kGeneral},
     generateNearNested},
    {{Family::nestedTangent, "nested-tangent", "tangent to each other at one point, one inside the other", kOverlapping, kDegenerate},
     generateNestedTangent},
    {{Family::concentric, "concentric", "with one center", kOverlapping, kGeneral},
     generateConcentric},
    {{Family::cocircularLarge, "cocircular-large", "centers on a circle that each contains", kOverlapping, kGeneral},
     generateCocircularLarge},
    {{Family::onRim, "on-rim", "one of radius 1, the others tiny with centers on it", kOverlapping, kGeneral},
     generateOnRim},
    {{Family::wedge, "wedge", "in a wedge, whose two sides all of them touch", kOverlapping, kDegenerate},
     generateWedge},
    {{Family::twoCommonPoints, "two-common-points", "through the same two points", kOverlapping, kDegenerate},
     generateTwoCommonPoints},
    {{Family::barelyOut, "barely-out", "inside one circle, but for 1e-15 of its radius", kOverlapping, kGeneral},
     generateBarelyOut},
});
// clang-format on

constexpr auto kInfos = [] {
  std::array<FamilyInfo, kEntries.size()> infos{};
  for (std::size_t i = 0; i < infos.size(); ++i) infos[i] = kEntries[i].info;
  return infos;
}();

const Entry& entryOf(Family family) { return kEntries[static_cast<std::size_t>(family)]; }

}  // namespace

std::span<const FamilyInfo> families() { return kInfos; }

std::string_view familyName(Family family) { return entryOf(family).info.name; }

std::optional<Family> familyFromName(std::string_view name) {
  for (const Entry& entry : kEntries) {
    if (entry.info.name == name) return entry.info.family;
  }
  return std::nullopt;
}

std::vector<Circle> generate(Family family, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Circle> circles = entryOf(family).generator(count, random);
  // The numbers are rounded as by `compute`.
  for (Circle& c : circles) c = rounded(c);
  return circles;
}

}  // namespace circle_voronoi
