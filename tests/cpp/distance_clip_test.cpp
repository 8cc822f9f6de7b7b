// SPDX-License-Identifier: GPL-3.0-or-later
// Cells in regions cut at a distance from their circles, where discs meet corners, sides, vertices and each other
// exactly, against an independent clip in numbers of 100 digits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <random>
#include <set>

#include "at.h"
#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/compute.h"
#include "clip_families.h"
#include "clip_parts.h"
#include "independent_clip.h"
#include "judge_within.h"
#include "part_within.h"
#include "report.h"
#include "rings.h"
#include "vectors.h"

namespace circle_voronoi {
namespace {

using test::cellsByBruteForce;
using test::ClipFamily;
using test::ClipInput;
using test::IndependentCell;
using test::radiusOf;
using test::regionFrom;
using test::seedOr;

using Generator = std::mt19937_64;

int pick(Generator& random, int least, int most) { return std::uniform_int_distribution<int>(least, most)(random); }
double unit(Generator& random) { return std::uniform_real_distribution<double>(0, 1)(random); }

/// The number of clips of each family: a few, or CIRCLE_VORONOI_CLIPS.
int trials() {
  const char* count = std::getenv("CIRCLE_VORONOI_CLIPS");
  return count == nullptr ? 12 : std::atoi(count);
}

/// An input and a distance. `weights`: as in Options.
struct DistanceInput {
  ClipInput clip;
  double distance = 0;
  bool weights = false;
};

/// Returns the radius of the disc in which a cell is kept.
double reachOf(const DistanceInput& input, const Circle& circle) {
  const double distance = input.distance;
  if (input.clip.metric != Metric::power) return std::max(radiusOf(input.clip, circle) + distance, 0.0);
  const double weight = input.weights ? circle.r : circle.r * circle.r;
  return std::sqrt(std::max(weight + distance * std::abs(distance), 0.0));
}

/// Returns the discs in which cells are kept.
ClipInput discsOf(const DistanceInput& input) {
  ClipInput discs = input.clip;
  for (Circle& c : discs.circles) c.r = input.weights ? reachOf(input, c) : c.r;
  return discs;
}

/// Moves the region so that one of its corners has the offset (3, 4), (5, 12) ... from a center, in some unit.
DistanceInput cornerOnRim(Generator& random) {
  constexpr std::array<std::array<double, 3>, 5> kTriples = {
      {{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {0, 1, 1}, {20, 21, 29}}};
  const auto triple = [&] {
    auto [x, y, length] = kTriples[static_cast<std::size_t>(pick(random, 0, 4))];
    if (pick(random, 0, 1) == 0) std::swap(x, y);
    const double factor = pick(random, 1, 4);
    const double signX = pick(random, 0, 1) * 2 - 1;
    const double signY = pick(random, 0, 1) * 2 - 1;
    return std::array{factor * signX * x, factor * signY * y, factor * length};
  };
  DistanceInput input;
  const auto [x, y, length] = triple();
  const Point center = {static_cast<double>(pick(random, -9, 9)), static_cast<double>(pick(random, -9, 9))};
  const double r = pick(random, 0, static_cast<int>(length) + 3);
  input.clip.circles.push_back({center.x, center.y, r});
  input.distance = length - r;
  for (int k = pick(random, 0, 3); k > 0; --k) {
    input.clip.circles.push_back({static_cast<double>(pick(random, -40, 40)),
                                  static_cast<double>(pick(random, -40, 40)), static_cast<double>(pick(random, 0, 9))});
  }
  // Rings with corners on the rim, and others.
  Region::Ring ring = {{center.x + x, center.y + y}};
  for (int k = pick(random, 2, 5); k > 0; --k) {
    if (pick(random, 0, 2) == 0) {
      // Another point of the rim.
      const double side = pick(random, 0, 1) * 2 - 1;
      ring.push_back(pick(random, 0, 1) == 0 ? Point{center.x + side * y, center.y + x}
                                             : Point{center.x - x, center.y + side * y});
    } else {
      ring.push_back({static_cast<double>(pick(random, -50, 50)), static_cast<double>(pick(random, -50, 50))});
    }
  }
  Point middle;
  for (const Point& p : ring) middle = {middle.x + p.x / 7, middle.y + p.y / 7};
  std::ranges::sort(ring, {}, [&](Point p) { return pseudoAngle({p.x - middle.x, p.y - middle.y}); });
  input.clip.rings = {ring};
  if (pick(random, 0, 2) == 0) {
    // The corner belongs to a hole, in a large region.
    input.clip.rings.insert(input.clip.rings.begin(), {{-400, -400}, {400, -400}, {400, 400}, {-400, 400}});
  }
  return input;
}

/// A box or a slanted square whose sides touch the disc of a circle from outside or inside.
DistanceInput tangentSide(Generator& random) {
  DistanceInput input;
  const bool isSlanted = pick(random, 0, 1) == 0;
  const double reach = pick(random, 1, 12) * 5.0;
  const double r = pick(random, 0, 20);
  const double x = pick(random, -9, 9);
  const double y = pick(random, -9, 9);
  input.clip.circles = {{x, y, r}};
  input.distance = reach - r;
  for (int k = pick(random, 0, 3); k > 0; --k) {
    input.clip.circles.push_back({static_cast<double>(pick(random, -60, 60)),
                                  static_cast<double>(pick(random, -60, 60)), static_cast<double>(pick(random, 0, 9))});
  }
  // In a frame with the unit 5, along (1, 0) or (3, 4) / 5.
  const auto place = [&](double along, double across) {
    return isSlanted ? Point{x + (3 * along - 4 * across) / 5, y + (4 * along + 3 * across) / 5}
                     : Point{x + along, y + across};
  };
  const double side = pick(random, 0, 1) * 2 - 1;
  const double far = side * reach + (pick(random, 0, 1) * 2 - 1) * 5.0 * pick(random, 1, 20);
  const double low = pick(random, -1, 1) == 0 ? 0 : -5.0 * pick(random, 0, 20);
  const double high = 5.0 * pick(random, 1, 20);
  Region::Ring ring = {place(low, side * reach), place(high, side * reach), place(high, far), place(low, far)};
  if (pick(random, 0, 1) == 0 && low < 0) ring.insert(ring.begin() + 1, place(0, side * reach));
  input.clip.rings = {ring};
  if (pick(random, 0, 3) == 0) {
    input.clip.rings.insert(input.clip.rings.begin(), {{-400, -400}, {400, -400}, {400, 400}, {-400, 400}});
  }
  return input;
}

/// Two equal circles whose rims meet in two points with integer coordinates, or touch; the region meets these points.
DistanceInput rimsAtSide(Generator& random) {
  DistanceInput input;
  const double f = pick(random, 1, 4);
  const double a = 3 * f;
  const double b = pick(random, 0, 3) == 0 ? 0 : 4 * f;
  const double reach = b == 0 ? a : 5 * f;
  const double r = pick(random, 0, static_cast<int>(reach));
  // Unequal radii: (0, b) at the distance 4 f from the origin, circles at (0, 0) and (3 f, b) on a line.
  const bool isEqual = pick(random, 0, 1) == 0;
  input.clip.circles = {{-a, 0, r}, {a, 0, r}};
  input.distance = reach - r;
  if (!isEqual) {
    // Rims around (0, 0) and (0, 21 f) of the radii 13 f and 20 f meet at (+-12 f, 5 f).
    input.clip.circles = {{0, 0, 13 * f - 3}, {0, 21 * f, 20 * f - 3}};
    input.distance = 3;
  }
  for (int k = pick(random, 0, 2); k > 0; --k) {
    input.clip.circles.push_back({static_cast<double>(pick(random, -60, 60)), static_cast<double>(pick(random, 40, 60)),
                                  static_cast<double>(pick(random, 0, 5))});
  }
  const Point meet = isEqual ? Point{0, b} : Point{12 * f, 5 * f};
  Region::Ring ring = {meet};
  for (int k = pick(random, 2, 4); k > 0; --k) {
    ring.push_back({static_cast<double>(pick(random, -50, 50)), static_cast<double>(pick(random, -50, 50))});
  }
  if (pick(random, 0, 1) == 0) {
    // The point lies inside a side.
    const Point p = ring[1];
    ring[0] = {2 * meet.x - p.x, 2 * meet.y - p.y};
  }
  if (pick(random, 0, 2) == 0) {
    // A side along the edge, or along the tangent.
    const double side = pick(random, 0, 1) * 2 - 1;
    ring = {{0, meet.y - pick(random, 0, 20)},
            {0, meet.y + pick(random, 1, 20)},
            {side * 50, meet.y + 30},
            {side * 50, meet.y - 30}};
  }
  input.clip.rings = {ring};
  return input;
}

/// A clip of another family with any distance.
DistanceInput anyFamily(Generator& random) {
  const auto& families = test::clipFamilies();
  DistanceInput input;
  input.clip = families[static_cast<std::size_t>(pick(random, 0, static_cast<int>(families.size()) - 1))].make(random);
  input.distance = test::anyDistance(input.clip, random);
  return input;
}

/// Random circles in a random star with a hole.
DistanceInput anything(Generator& random) {
  DistanceInput input;
  for (int k = pick(random, 1, 4); k > 0; --k) {
    input.clip.circles.push_back({unit(random), unit(random), 0.2 * unit(random)});
  }
  const auto star = [&](double least, double most, int corners) {
    Region::Ring ring;
    for (int k = 0; k < corners; ++k) {
      const double angle = 6.283185307179586 * (k + 0.8 * unit(random)) / corners;
      const double r = least + (most - least) * unit(random);
      ring.push_back({0.5 + r * std::cos(angle), 0.5 + r * std::sin(angle)});
    }
    return ring;
  };
  input.clip.rings = {star(0.3, 0.9, pick(random, 4, 8))};
  if (pick(random, 0, 1) == 0) input.clip.rings.push_back(star(0.05, 0.25, pick(random, 3, 5)));
  input.distance = std::pow(10.0, -2 + 2 * unit(random)) - 0.05;
  return input;
}

/// The discs of another family as those of a power diagram, whose centers may lie outside of their cells.
template <auto make>
DistanceInput asPower(Generator& random) {
  DistanceInput input = make(random);
  const double distance = pick(random, -9, 9);
  for (Circle& c : input.clip.circles) {
    const double reach = c.r + input.distance;
    c.r = reach * std::abs(reach) - distance * std::abs(distance);
  }
  input.clip.metric = Metric::power;
  input.distance = distance;
  input.weights = true;
  return input;
}

/// A power diagram of which rims pass through one point, where a vertex may be. It lies in the region, on its boundary
/// or in a corner of it.
DistanceInput rimsThroughVertex(Generator& random) {
  DistanceInput input;
  input.clip.metric = Metric::power;
  input.distance = pick(random, -9, 9);
  input.weights = true;
  const int onRim = pick(random, 1, 5);
  for (int k = onRim + pick(random, 0, 2); k > 0; --k) {
    const double x = pick(random, -20, 20);
    const double y = pick(random, -20, 20);
    const double less = k > onRim ? pick(random, 0, 400) : 0;
    input.clip.circles.push_back({x, y, x * x + y * y - input.distance * std::abs(input.distance) - less});
  }
  const auto anyPoint = [&] {
    return Point{static_cast<double>(pick(random, -30, 30)), static_cast<double>(pick(random, -30, 30))};
  };
  Region::Ring ring = {anyPoint(), anyPoint(), anyPoint()};
  if (pick(random, 0, 2) == 0) ring[0] = {0, 0};
  if (pick(random, 0, 2) == 0) ring[1] = {-2 * ring[0].x, -2 * ring[0].y};
  if (pick(random, 0, 2) == 0) ring = {{-99, -99}, {99, -99}, {99, 99}, {-99, 99}};
  input.clip.rings = {ring};
  return input;
}

struct DistanceFamily {
  const char* name;
  DistanceInput (*make)(Generator& random);
};
constexpr std::array<DistanceFamily, 9> kFamilies = {{{"cornerOnRim", cornerOnRim},
                                                      {"tangentSide", tangentSide},
                                                      {"rimsAtSide", rimsAtSide},
                                                      {"anyFamily", anyFamily},
                                                      {"anything", anything},
                                                      {"powerCornerOnRim", asPower<cornerOnRim>},
                                                      {"powerTangentSide", asPower<tangentSide>},
                                                      {"powerRimsAtSide", asPower<rimsAtSide>},
                                                      {"rimsThroughVertex", rimsThroughVertex}}};

double lengthOfPiece(const OutlinePiece& piece) {
  return std::hypot(piece.curve.end.x - piece.curve.start.x, piece.curve.end.y - piece.curve.start.y);
}

/// Expects the neighbors, sides, loops and area of an independent clip.
void expectCell(const ClippedDiagram& clipped, CircleIndex circle, const IndependentCell& expected, double size,
                double rounding) {
  SCOPED_TRACE("cell " + std::to_string(std::int32_t{circle}));
  const Outline outline = clipped.outline(circle);
  const double least = 1e-9 * size;
  std::set<std::int32_t> neighbors;
  std::set<std::int32_t> sides;
  std::set<std::int32_t> longNeighbors;
  std::set<std::int32_t> longSides;
  for (const auto& loop : outline) {
    ASSERT_FALSE(loop.empty());
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const OutlinePiece& piece = loop[k];
      EXPECT_EQ(piece.curve.end, loop[(k + 1) % loop.size()].curve.start);
      const bool isLong = lengthOfPiece(piece) > least;
      if (piece.neighbor != kNone) {
        neighbors.insert(piece.neighbor);
        if (isLong) longNeighbors.insert(piece.neighbor);
      }
      if (piece.regionSide != kNone) {
        sides.insert(piece.regionSide);
        if (isLong) longSides.insert(piece.regionSide);
      }
    }
  }
  // Pieces shorter than rounding may be missing.
  const auto expectSame = [&](const std::set<std::int32_t>& all, const std::set<std::int32_t>& ofLength,
                              const std::map<std::int32_t, double>& theirs, const char* what) {
    for (const std::int32_t its : ofLength) EXPECT_TRUE(theirs.count(its) == 1) << what << " " << its;
    for (const auto& [its, length] : theirs) {
      EXPECT_TRUE(all.count(its) == 1 || length < rounding) << what << " " << its << " of the length " << length;
    }
  };
  expectSame(neighbors, longNeighbors, expected.neighbors, "neighbor");
  expectSame(sides, longSides, expected.sides, "side");
  // A cell may have a loop that is a point up to rounding where a corner lies on an edge.
  const auto isPoint = [&](const auto& loop) {
    return std::ranges::all_of(loop, [&](const OutlinePiece& piece) { return lengthOfPiece(piece) <= rounding; });
  };
  if (expected.loops) {
    const auto loops = static_cast<std::ptrdiff_t>(outline.size()) - std::ranges::count_if(outline, isPoint);
    const auto isLongLoop = [&](double length) { return length > 8 * rounding; };
    EXPECT_GE(loops, std::ranges::count_if(*expected.loops, isLongLoop));
    EXPECT_LE(loops, static_cast<std::ptrdiff_t>(expected.loops->size()));
  }
  EXPECT_NEAR(area(outline), expected.area, 1e-12 * size * size + rounding * size);
  // The parts of edges are those of the outline.
  std::set<std::int32_t> listed;
  for (const CircleIndex neighbor : clipped.neighbors(circle)) listed.insert(neighbor);
  EXPECT_EQ(listed, neighbors);
}

class DistanceFamilies : public testing::TestWithParam<std::size_t> {};

/// Calls `check` with clips of a family.
template <class Check>
void forFamily(const DistanceFamily& family, std::uint64_t seed, int count, Check check) {
  Generator random(seed);
  for (int done = 0; done < count;) {
    DistanceInput input = family.make(random);
    // Also tiny and huge ones.
    const double scale = pick(random, 0, 3) == 0 ? std::ldexp(1.0, pick(random, -30, 30)) : 1;
    input.distance *= scale;
    for (Circle& c : input.clip.circles) {
      c = {c.x * scale, c.y * scale, c.r * scale * (input.weights ? scale : 1)};
    }
    for (auto& ring : input.clip.rings) {
      for (Point& p : ring) p = {p.x * scale, p.y * scale};
    }
    const auto region = Region::fromRings(input.clip.rings);
    if (!region) continue;
    ++done;
    SCOPED_TRACE(std::string(family.name) + ", clip " + std::to_string(done) + ", seed " + std::to_string(seed));
    const auto computed = compute(input.clip.circles, {.metric = input.clip.metric, .weights = input.weights});
    const Diagram& diagram = computed.value();
    const auto clipped = ClippedDiagram::from(diagram, *region, input.distance);
    ASSERT_TRUE(clipped) << clipped.error().message;
    check(input, *clipped, random);
    if (testing::Test::HasFailure()) FAIL() << test::describe(input.clip.circles) << " within " << input.distance;
  }
}

TEST_P(DistanceFamilies, HaveTheCellsOfAnIndependentClip) {
  forFamily(kFamilies[GetParam()], seedOr(71), trials(),
            [](const DistanceInput& input, const ClippedDiagram& clipped, Generator&) {
              const auto& [clip, distance, weights] = input;
              const Region& region = clipped.region();
              const auto expected = cellsByBruteForce(clip.circles, region, clip.metric, distance, weights);
              const double rounding = 1e-15 * test::farthestOf(discsOf(input));
              for (std::size_t i = 0; i < expected.size(); ++i) {
                const double size = std::min(test::extentOf(region), 2 * reachOf(input, clip.circles[i]));
                expectCell(clipped, static_cast<std::int32_t>(i), expected[i], size, rounding);
              }
            });
}

std::string nameOfFamily(const testing::TestParamInfo<std::size_t>& family) { return kFamilies[family.param].name; }
INSTANTIATE_TEST_SUITE_P(All, DistanceFamilies, testing::Range(std::size_t{0}, kFamilies.size()), nameOfFamily);

/// Expects polygons that are regions and have the areas of the cells within the tolerance.
void expectValidPolygons(const ClippedDiagram& clipped, double tolerance, double rounding) {
  const ClippedPolygons all = clipped.polygons(tolerance);
  for (std::size_t i = 0; i + 1 < all.polygonOffsets.size(); ++i) {
    SCOPED_TRACE("cell " + std::to_string(i) + ", tolerance " + std::to_string(tolerance));
    const auto polygons = test::polygonsOf(all, i);
    const Outline outline = clipped.outline(static_cast<std::int32_t>(i));
    double size = 0;
    if (!polygons.empty()) {
      const auto cell = Region::fromPolygons(polygons);
      ASSERT_TRUE(cell) << cell.error().message;
      size = cell->area();
    }
    EXPECT_NEAR(size, area(outline), tolerance * perimeter(outline) + rounding);
  }
}

TEST_P(DistanceFamilies, HaveValidPolygonsAtAnyTolerance) {
  forFamily(kFamilies[GetParam()], seedOr(72), 5 * trials(),
            [](const DistanceInput& input, const ClippedDiagram& clipped, Generator& random) {
              if (!test::hasPolygons(discsOf(input))) return;
              const double extent = test::extentOf(clipped.region());
              const double tolerance = std::pow(10.0, -6 + 9 * unit(random)) * extent;
              expectValidPolygons(clipped, tolerance, 1e-12 * test::farthestOf(discsOf(input)) * extent);
            });
}

/// Expects all cells of an independent clip.
void expectCells(const std::vector<Circle>& circles, const Region& region, double distance, double size) {
  const Diagram diagram = compute(circles, {.metric = Metric::circles}).value();
  const auto clipped = ClippedDiagram::from(diagram, region, distance);
  ASSERT_TRUE(clipped) << clipped.error().message;
  const auto expected = cellsByBruteForce(circles, region, Metric::circles, distance);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    expectCell(*clipped, static_cast<std::int32_t>(i), expected[i], size, 1e-12);
  }
}

// Discs exactly through corners of the region, which double arithmetic decides wrongly.
TEST(DistanceClip, DiscsThroughCornersHaveTheRightAreas) {
  expectCells({{-117, -156, 103}, {-199, 133, 24}},
              regionFrom({{{-57.08088757790469, 70.339640768159228}, {0, 0}, {-200, 0}}}), 131.13656918675733, 500);
  expectCells({{-32, -126, 12}, {32, -126, 12}}, regionFrom({{{0, -373}, {25, -373}, {25, 137}, {0, 137}}}),
              237.06424873915566, 500);
  expectCells({{0, 195, 210}, {117, 156, 210}}, regionFrom({{{-76, -165}, {-55, -165}, {-55, -30.5}, {-76, -30.5}}}),
              154.17715469260287, 500);
}

// A circle in the notch between a huge one and another, tangent and nested ones: cells bounded by arcs of all kinds.
TEST(DistanceClip, NestedTangentAndHugeCirclesHaveTheRightCells) {
  const std::vector<Circle> circles = {{0, 0, 3}, {1, 0, 1}, {5, 0, 2}, {2.5, 1.5, 2},   {1e6, 0, 1e6 - 7},
                                       {3, 0, 0}, {5, 1, 1}, {0, 0, 3}, {-4, -4, 0.125}, {-1, 0, 2}};
  const Region box = regionFrom({{{-50, -50}, {50, -50}, {50, 40}, {-50, 40}}});
  for (const double d : {0.01, 0.5, 1.0, 3.0, 50.0}) expectCells(circles, box, d, 1e6);
}

// An edge touches the rim at its apex, where a vertex is, and another edge meets the rim there and elsewhere.
TEST(DistanceClip, ARimThatTouchesAnEdgeInAPointOfAnotherEdgeGoesTheShortWay) {
  const std::vector<Circle> circles = {{8, 6, 0},   {20, 15, 15},  {90, -48, 92}, {90, 56, 96},     {100, -105, 135},
                                       {0, 76, 66}, {-40, 75, 75}, {28, 45, 43},  {105, -100, 135}, {8, -15, 7}};
  const Diagram diagram = compute(circles, {.metric = Metric::circles}).value();
  const Region region = test::regionFrom({{{0, 0}, {-42, 7}, {-74, -94}}});
  const auto clipped = ClippedDiagram::from(diagram, region, 10);
  ASSERT_TRUE(clipped) << clipped.error().message;
  const auto expected = cellsByBruteForce(circles, region, Metric::circles, 10);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(area(clipped->outline(static_cast<std::int32_t>(i))), expected[i].area, 1e-11) << "cell " << i;
  }
}

// A disc far smaller than a rounding step at its center is a tiny disc, or nothing.
TEST(DistanceClip, DiscsThatCollapseInCoordinatesAreEmpty) {
  const std::vector<Circle> circles = {{1, 1, 1e-17}, {5, 5, 1}, {1e15, -1e15, 0.25}};
  const Diagram diagram = compute(circles, {.metric = Metric::circles}).value();
  const Region region = test::regionFrom({{{-2e15, -2e15}, {2e15, -2e15}, {2e15, 2e15}, {-2e15, 2e15}}});
  for (const double distance : {0.0, 1e-18, -1e-17, -5e-18, 1e-300}) {
    const auto clipped = ClippedDiagram::from(diagram, region, distance).value();
    for (const CircleIndex i : {0, 1, 2}) {
      const double radius = circles[at(i)].r + distance;
      const double area = circle_voronoi::area(clipped.outline(i));
      EXPECT_TRUE(i != 1 || std::abs(area - 3.14159265358979 * radius * radius) < 1e-12) << area;
      EXPECT_LE(area, 4 * std::max(radius, 0.0) * std::max(radius, 0.0));
      EXPECT_NEAR(circle_voronoi::area(outlineWithin(diagram, i, distance)), area, 1e-12);
      for (const auto& loop : clipped.outline(i)) EXPECT_FALSE(loop.empty());
    }
    EXPECT_EQ(clipped.polygons(1e-3).polygonOffsets.size(), 4U);
    EXPECT_EQ(clipped.cells().loopOffsets.size(), 4U);
    EXPECT_TRUE(std::isnan(clipped.centroids()[0].x) || clipped.centroids()[0].x == 1);
  }
}

// A chord of the rim cut the hole.
TEST(DistanceClip, ChordsOfRimsDoNotCutHoles) {
  const std::vector<Circle> circles = {{0, 130, 50}, {200, 0, 0}};
  const Diagram diagram = compute(circles, {.metric = Metric::circles}).value();
  const Region region = test::regionFrom({{{0, -800}, {800, 0}, {0, 800}}, {{0, 0}, {60, 40}, {10, 0}}});
  const auto clipped = ClippedDiagram::from(diagram, region, 60).value();
  for (double tolerance = 1e-7; tolerance < 1e5; tolerance *= 3) expectValidPolygons(clipped, tolerance, 1e-9);
}

// A corner in the center of the circle kept corners that chords of the rim cut off from being found.
TEST(DistanceClip, ChordsOfRimsDoNotCutAHoleWithACornerInTheCenter) {
  const Diagram diagram = compute(std::vector<Circle>{{0, 0, 1}, {6, 5, 3}}, {.metric = Metric::circles}).value();
  const Region region = test::regionFrom({{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}, {{0, 0}, {1, 0}, {2, -0.5}, {0, -1}}});
  const auto clipped = ClippedDiagram::from(diagram, region, 1.4142135623730951).value();
  for (double tolerance = 1e-7; tolerance < 1e5; tolerance *= 3) expectValidPolygons(clipped, tolerance, 1e-9);
}

/// Expects that the judge takes the loops of a cell, and refuses them with each fault.
void expectFaultsRefused(const ClippedDiagram& clipped, CircleIndex circle) {
  SCOPED_TRACE("cell " + std::to_string(std::int32_t{circle}));
  Loops loops;
  ClipParts::of(clipped).loopsOf(circle, loops);
  const LoopsWithin right = loopsWithin(ClipParts::of(clipped), circle, loops);
  const AreaBounds bounds = areaBounds(ClipParts::of(clipped), circle, loops);
  const double rounding = 1e-12;
  EXPECT_EQ(faultOf(right, bounds, rounding), nullptr);
  const double its = area(right.outline);
  EXPECT_NE(faultOf(right, {0, its - 1e-9}, rounding), nullptr);
  EXPECT_NE(faultOf(right, {its + 1e-9, its + 1}, rounding), nullptr);
  const auto expectRefused = [&](auto change) {
    LoopsWithin wrong = right;
    change(wrong);
    EXPECT_NE(faultOf(wrong, bounds, rounding), nullptr);
  };
  expectRefused([](LoopsWithin& wrong) { wrong.isSound = false; });
  expectRefused([&](LoopsWithin& wrong) {
    wrong.outline.push_back(right.outline.front());
    wrong.isHole.push_back(0);
  });
  for (std::size_t k = 0; k < right.outline.size(); ++k) {
    for (std::size_t p = 0; p < right.outline[k].size(); ++p) {
      expectRefused([&](LoopsWithin& wrong) {
        wrong.outline[k].erase(wrong.outline[k].begin() + static_cast<std::ptrdiff_t>(p));
      });
    }
    expectRefused([&](LoopsWithin& wrong) { wrong.outline[k].clear(); });
    expectRefused([&](LoopsWithin& wrong) { wrong.isHole[k] = wrong.isHole[k] != 0 ? 0 : 1; });
    expectRefused([](LoopsWithin& wrong) { wrong.isHole.pop_back(); });
    expectRefused([&](LoopsWithin& wrong) {
      for (OutlinePiece& piece : wrong.outline[k]) piece.curve = reversed(piece.curve);
      std::ranges::reverse(wrong.outline[k]);
    });
    if (bounds.least < bounds.most) continue;
    // Without one of its loops.
    expectRefused([&](LoopsWithin& wrong) {
      wrong.outline.erase(wrong.outline.begin() + static_cast<std::ptrdiff_t>(k));
      wrong.isHole.erase(wrong.isHole.begin() + static_cast<std::ptrdiff_t>(k));
    });
  }
}

TEST(DistanceClip, LoopsThatAreWrongAreRefused) {
  const std::vector<Circle> circles = {{0, 0, 1}, {4, 0, 2}, {1, 5, 1}};
  const Diagram diagram = compute(circles, {.metric = Metric::circles}).value();
  const Region region = test::regionFrom({{{-3, -3}, {6, -2}, {5, 6}, {-2, 6}}, {{-1, 0}, {-0.5, -0.5}, {-0.5, 0.5}}});
  const auto clipped = ClippedDiagram::from(diagram, region, 1.25).value();
  for (const CircleIndex i : {0, 1, 2}) expectFaultsRefused(clipped, i);
}

// The center of the second circle lies outside its cell, and the disc of the third one outside the region.
TEST(DistanceClip, LoopsOfPowerDiagramsThatAreWrongAreRefused) {
  const std::vector<Circle> circles = {{0, 0, 5}, {1, 0, 4.5}, {9, 9, 1}};
  const Diagram diagram = compute(circles, {.metric = Metric::power}).value();
  const Region region = test::regionFrom({{{-3, -3}, {6, -2}, {5, 6}, {-2, 6}}, {{-1, 0}, {-0.5, -0.5}, {-0.5, 0.5}}});
  const auto clipped = ClippedDiagram::from(diagram, region, -1).value();
  for (const CircleIndex i : {0, 1}) expectFaultsRefused(clipped, i);
  EXPECT_TRUE(clipped.outline(2).empty());
}

// No loop of such a cell meets the rim of its disc, so only their areas tell whether one is missing.
TEST(DistanceClip, LoopsThatAreWrongAreRefusedAlsoWhollyWithinTheDistance) {
  const std::uint64_t seed = seedOr(73);
  Generator random(seed);
  for (int round = 0; round < 20; ++round) {
    SCOPED_TRACE("round " + std::to_string(round) + ", seed " + std::to_string(seed));
    std::vector<Circle> circles;
    for (int k = 0; k < 3; ++k) circles.push_back({6 * unit(random) - 3, 6 * unit(random) - 3, 0.5 * unit(random)});
    std::vector<Region::Ring> rings = {{{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}};
    for (const double x : {-3.0, 0.0, 3.0}) {
      const Point p = {x + unit(random) - 0.5, 6 * unit(random) - 3};
      rings.push_back({p, {p.x + 0.5, p.y}, {p.x + 0.25, p.y + 0.5}});
    }
    const Diagram diagram = compute(circles, {.metric = Metric::circles}).value();
    const Region region = Region::fromRings(rings).value();
    const auto clipped = ClippedDiagram::from(diagram, region, 40).value();
    for (const CircleIndex i : {0, 1, 2}) {
      Loops loops;
      ClipParts::of(clipped).loopsOf(i, loops);
      if (loops.isHole.empty()) continue;
      EXPECT_EQ(areaBounds(ClipParts::of(clipped), i, loops).least, areaBounds(ClipParts::of(clipped), i, loops).most);
      expectFaultsRefused(clipped, i);
    }
  }
}

}  // namespace
}  // namespace circle_voronoi
