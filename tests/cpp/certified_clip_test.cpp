// SPDX-License-Identifier: GPL-3.0-or-later
// Clips where the boundary of a region meets vertices and edges exactly, against an independent clip.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <random>

#include "at.h"
#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/compute.h"
#include "clip_families.h"
#include "clip_parts.h"
#include "fixtures.h"
#include "independent_clip.h"
#include "judge_clip.h"
#include "report.h"
#include "rings.h"
#include "same_cells.h"

namespace circle_voronoi {
namespace {

using test::areasByBruteForce;
using test::clipFamilies;
using test::ClipFamily;
using test::ClipInput;
using test::extentOf;
using test::hasPolygons;
using test::polygonsOf;
using test::regionFrom;
using test::seedOr;

double largestDifference(const std::vector<double>& a, const std::vector<double>& b) {
  double most = a.size() == b.size() ? 0 : 1e300;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

/// The number of clips of each family: a few, or CIRCLE_VORONOI_CLIPS.
int trials() {
  const char* count = std::getenv("CIRCLE_VORONOI_CLIPS");
  return count == nullptr ? 60 : std::atoi(count);
}

/// Calls `check` with clips of a family.
template <class Check>
void forFamily(const ClipFamily& family, std::uint64_t seed, Check check) {
  std::mt19937_64 random(seed);
  for (int done = 0; done < trials();) {
    const ClipInput input = family.make(random);
    const auto region = Region::fromRings(input.rings);
    if (!region) continue;
    ++done;
    SCOPED_TRACE(std::string(family.name) + ", clip " + std::to_string(done) + ", seed " + std::to_string(seed));
    const Diagram diagram = compute(input.circles, {.metric = input.metric}).value();
    const auto clipped = ClippedDiagram::from(diagram, *region);
    ASSERT_TRUE(clipped) << clipped.error().message;
    check(input, *region, diagram, *clipped);
    if (testing::Test::HasFailure()) return;
  }
}

class ClipFamilies : public testing::TestWithParam<std::size_t> {};

/// Expects the areas of an independent clip.
void expectAreas(const ClipInput& input, const ClippedDiagram& clipped) {
  const Region& region = clipped.region();
  const double extent = extentOf(region);
  // The rounding of rims is that of coordinates.
  const double rounding = clipped.maxDistance() ? 1e-15 * test::farthestOf(input) : 0;
  const double most = (1e-7 * extent + rounding) * extent;
  const auto areas = clipped.areas();
  const auto difference = [&](bool isLong) {
    return largestDifference(areas,
                             areasByBruteForce(input.circles, region, input.metric, isLong, clipped.maxDistance()));
  };
  // Long doubles do not tell a side from an edge to which it is tangent, nor tiny regions from points.
  if (difference(false) < most) return;
  EXPECT_LT(difference(true), most);
}

TEST_P(ClipFamilies, HaveTheAreasOfAnIndependentClip) {
  forFamily(clipFamilies()[GetParam()], seedOr(50),
            [](const ClipInput& input, const Region&, const Diagram&, const ClippedDiagram& clipped) {
              expectAreas(input, clipped);
            });
}

TEST_P(ClipFamilies, HaveTheAreasOfAnIndependentClipWithinADistance) {
  const std::uint64_t seed = seedOr(57);
  std::mt19937_64 random(seed + 1);
  forFamily(clipFamilies()[GetParam()], seed,
            [&](const ClipInput& input, const Region& region, const Diagram& diagram, const ClippedDiagram&) {
              const double distance = test::anyDistance(input, random);
              SCOPED_TRACE("within " + std::to_string(distance));
              const auto clipped = ClippedDiagram::from(diagram, region, distance);
              ASSERT_TRUE(clipped) << clipped.error().message;
              expectAreas(input, *clipped);
              for (std::int32_t i = 0; i < static_cast<std::int32_t>(diagram.circles.size()); ++i) {
                test::expectSameAlone(*clipped, i);
              }
            });
}

TEST_P(ClipFamilies, HaveTheSameSingleCellsToTheBit) {
  forFamily(clipFamilies()[GetParam()], seedOr(51),
            [](const ClipInput&, const Region&, const Diagram& diagram, const ClippedDiagram& clipped) {
              for (std::int32_t i = 0; i < static_cast<std::int32_t>(diagram.circles.size()); ++i) {
                test::expectSameAlone(clipped, i);
                if (diagram.metric == Metric::circles) test::expectSameAmongNeighbors(clipped, i);
              }
            });
}

TEST_P(ClipFamilies, AreConsistent) {
  forFamily(clipFamilies()[GetParam()], seedOr(52),
            [](const ClipInput& input, const Region& region, const Diagram& diagram, const ClippedDiagram& clipped) {
              const double extent = extentOf(region);
              const auto areas = clipped.areas();
              EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), region.area(), 1e-13 * extent * extent);
              double inner = 0;
              for (EdgeIndex e = 0; e < static_cast<std::int32_t>(diagram.edges.size()); ++e) {
                for (const EdgeCurve& part : clipped.edgeParts(e)) inner += arcLength(part);
              }
              const auto perimeters = clipped.perimeters();
              EXPECT_NEAR(std::accumulate(perimeters.begin(), perimeters.end(), 0.0), region.perimeter() + 2 * inner,
                          1e-9 * (region.perimeter() + inner) + 1e-12 * test::farthestOf(input));
              for (std::int32_t i = 0; i < static_cast<std::int32_t>(areas.size()); ++i) {
                const auto at = static_cast<std::size_t>(i);
                EXPECT_NEAR(area(clipped.outline(i)), areas[at], 1e-12 * extent * extent);
                for (const CircleIndex j : clipped.neighbors(i)) {
                  EXPECT_TRUE(std::ranges::count(clipped.neighbors(j), i) == 1);
                }
              }
            });
}

/// Expects that loops go counter-clockwise and holes clockwise, except for rounding.
void expectOrientations(const ClipInput& input, const ClippedDiagram& clipped) {
  const double extent = extentOf(clipped.region());
  const double farthest = std::max(extent, test::farthestOf(input));
  const ClippedCells cells = clipped.cells();
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(clipped.diagram().circles.size()); ++i) {
    const Outline outline = clipped.outline(i);
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const bool isHole = cells.isHole[at(cells.loopOffsets[at(i)]) + k] != 0;
      EXPECT_GE(area({outline[k]}) * (isHole ? -1 : 1), -1e-14 * extent * farthest) << "loop " << k << " of cell " << i;
    }
  }
}

TEST_P(ClipFamilies, HaveLoopsInTheirDirectionsAlsoWithinADistance) {
  const std::uint64_t seed = seedOr(59);
  std::mt19937_64 random(seed + 1);
  forFamily(clipFamilies()[GetParam()], seed,
            [&](const ClipInput& input, const Region& region, const Diagram& diagram, const ClippedDiagram& clipped) {
              expectOrientations(input, clipped);
              const double distance = test::anyDistance(input, random);
              SCOPED_TRACE("within " + std::to_string(distance));
              const auto near = ClippedDiagram::from(diagram, region, distance);
              ASSERT_TRUE(near) << near.error().message;
              expectOrientations(input, *near);
            });
}

/// The parts of edges in a region: the edge, and the sides on which it begins and ends.
std::vector<std::array<std::int32_t, 3>> partsInside(const ClippedDiagram& clipped) {
  std::vector<std::array<std::int32_t, 3>> parts;
  const ClippedEdges edges = clipped.edges();
  for (std::size_t k = 0; k < edges.edge.size(); ++k) {
    parts.push_back({edges.edge[k], edges.startSide[k], edges.endSide[k]});
  }
  return parts;
}

/// Returns rings of whole numbers moved by (e, f), or nothing for others and if that rounds a coordinate.
std::optional<std::vector<Region::Ring>> movedRings(std::vector<Region::Ring> rings, double e, double f) {
  for (auto& ring : rings) {
    for (Point& p : ring) {
      const Point to = {p.x + e, p.y + f};
      if (p.x != std::round(p.x) || p.y != std::round(p.y) || to.x - e != p.x || to.y - f != p.y) return std::nullopt;
      p = to;
    }
  }
  return rings;
}

// Clips are decided as if the region were moved by (e, f), where f is far smaller than e.
TEST_P(ClipFamilies, HaveThePartsOfEdgesOfARegionThatIsMovedALittle) {
  forFamily(clipFamilies()[GetParam()], seedOr(60),
            [](const ClipInput& input, const Region&, const Diagram& diagram, const ClippedDiagram& clipped) {
              // One shift is larger than other distances, or not large enough beside f, where the results differ.
              std::array<std::vector<std::array<std::int32_t, 3>>, 2> moved;
              for (std::size_t k = 0; k < moved.size(); ++k) {
                const auto rings = movedRings(input.rings, k == 0 ? 0x1p-11 : 0x1p-20, 0x1p-44);
                if (!rings) return;
                const Region region = Region::fromRings(*rings).value();
                moved[k] = partsInside(ClippedDiagram::from(diagram, region).value());
              }
              if (moved[0] == moved[1]) {
                EXPECT_EQ(partsInside(clipped), moved[0]);
              }
            });
}

/// Expects that the polygons of each cell are valid, and returns their areas.
std::vector<double> areasOfValidPolygons(const ClippedDiagram& clipped, double tolerance) {
  const ClippedPolygons all = clipped.polygons(tolerance);
  std::vector<double> areas;
  for (std::size_t i = 0; i + 1 < all.polygonOffsets.size(); ++i) {
    areas.push_back(0);
    const auto polygons = polygonsOf(all, i);
    if (polygons.empty()) continue;
    const auto cell = Region::fromPolygons(polygons);
    EXPECT_TRUE(cell) << "cell " << i << ": " << cell.error().message;
    if (cell) areas.back() = cell->area();
  }
  return areas;
}

TEST_P(ClipFamilies, HaveValidPolygonsThatMakeUpTheRegion) {
  forFamily(clipFamilies()[GetParam()], seedOr(56),
            [](const ClipInput& input, const Region& region, const Diagram&, const ClippedDiagram& clipped) {
              if (!hasPolygons(input)) return;
              const double extent = extentOf(region);
              for (const double tolerance : {1.0, 0.01}) {
                const auto areas = areasOfValidPolygons(clipped, tolerance * extent);
                EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), region.area(), 1e-11 * extent * extent);
              }
            });
}

TEST_P(ClipFamilies, DoNotDependOnOrderAndPlace) {
  std::mt19937_64 random(seedOr(53));
  forFamily(clipFamilies()[GetParam()], seedOr(54),
            [&](const ClipInput& input, const Region& region, const Diagram& diagram, const ClippedDiagram& clipped) {
              const double extent = extentOf(region);
              const auto areas = clipped.areas();
              const auto expectSame = [&](const std::vector<Circle>& circles, const std::vector<Region::Ring>& rings,
                                          const std::vector<double>& expected, const char* what) {
                const Diagram other = compute(circles, {.metric = input.metric}).value();
                const Region moved = Region::fromRings(rings).value();
                const auto again = ClippedDiagram::from(other, moved);
                ASSERT_TRUE(again) << what << ": " << again.error().message;
                EXPECT_LT(largestDifference(again->areas(), expected), 1e-12 * extent * extent) << what;
              };
              auto rings = input.rings;
              for (auto& ring : rings) std::ranges::rotate(ring, ring.begin() + 1);
              expectSame(input.circles, rings, areas, "another first corner");
              rings = input.rings;
              for (auto& ring : rings) std::ranges::reverse(ring);
              expectSame(input.circles, rings, areas, "the other orientation");

              auto circles = input.circles;
              rings = input.rings;
              for (Circle& c : circles) c = {-c.y, c.x, c.r};
              for (auto& ring : rings) {
                for (Point& p : ring) p = {-p.y, p.x};
              }
              expectSame(circles, rings, areas, "a quarter turn");

              // Only where nothing is rounded.
              bool isExact = true;
              const auto moved = [&](double& value, double by) {
                isExact = isExact && (value + by) - by == value;
                value += by;
              };
              circles = input.circles;
              rings = input.rings;
              for (Circle& c : circles) {
                moved(c.x, 12);
                moved(c.y, -7);
              }
              for (auto& ring : rings) {
                for (Point& p : ring) {
                  moved(p.x, 12);
                  moved(p.y, -7);
                }
              }
              if (isExact) expectSame(circles, rings, areas, "another place");

              // Among identical circles, the first has the cell.
              if (!diagram.hidden.empty()) return;
              std::vector<std::size_t> order(input.circles.size());
              std::iota(order.begin(), order.end(), std::size_t{0});
              std::ranges::shuffle(order, random);
              std::vector<double> permuted;
              circles.clear();
              for (const std::size_t i : order) {
                circles.push_back(input.circles[i]);
                permuted.push_back(areas[i]);
              }
              expectSame(circles, input.rings, permuted, "another order");
            });
}

std::string nameOfFamilyTest(const testing::TestParamInfo<std::size_t>& family) {
  std::string name = clipFamilies()[family.param].name;
  std::ranges::replace(name, ' ', '_');
  return name;
}
INSTANTIATE_TEST_SUITE_P(All, ClipFamilies, testing::Range(std::size_t{0}, clipFamilies().size()), nameOfFamilyTest);

// A side begins at a vertex, in the direction of the tangent of an edge there. A single cell was empty.
TEST(ClippedDiagram, ACellIsTheSameAloneWhereASideIsTangentToAnEdgeInItsCorner) {
  std::vector<Circle> circles = {{100, 0, 89.5}, {-8, -15, 6.5}, {-33, 44, 44.5}, {55, 132, 132.5}, {-57, -76, 84.5}};
  Region::Ring ring = {{0, 0}, {-13300, 0}, {-4200, -5300}, {-4000, -19500}, {4500, -1600}, {18000, 7600}};
  for (int turn = 0; turn < 8; ++turn) {
    SCOPED_TRACE("turn " + std::to_string(turn));
    const Diagram diagram = compute(circles).value();
    const Region region = test::regionFrom({ring});
    const auto clipped = ClippedDiagram::from(diagram, region).value();
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(circles.size()); ++i) test::expectSameAlone(clipped, i);
    // Quarter turns, and then their mirror images.
    const auto turned = [&](Point p) { return turn == 3 ? Point{p.y, p.x} : Point{-p.y, p.x}; };
    for (Circle& c : circles) {
      const Point p = turned({c.x, c.y});
      c = {p.x, p.y, c.r};
    }
    for (Point& p : ring) p = turned(p);
  }
}

// Two cells without vertices, whose coordinates would round. Shares of sides and parameters of edges must not.
TEST(ClippedDiagram, AreasFarFromTheOriginAreThoseAtTheOrigin) {
  const std::uint64_t seed = seedOr(61);
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  const auto number = [&] { return std::round(std::uniform_real_distribution<double>(-4096, 4096)(random)) / 64; };
  for (int round = 0; round < 200; ++round) {
    std::vector<Circle> circles;
    for (int i = 0; i < 2; ++i) circles.push_back({number(), number(), std::abs(number()) / 4});
    const Region::Ring ring = {{number() - 64, number() - 64},
                               {number() + 64, number() - 64},
                               {number() + 64, number() + 64},
                               {number() - 64, number() + 64}};
    for (const Metric metric : {Metric::circles, Metric::centers, Metric::power}) {
      const auto areasAt = [&](double offset) {
        auto there = circles;
        auto corners = ring;
        for (Circle& c : there) c = {c.x + offset, c.y - offset, c.r};
        for (Point& p : corners) p = {p.x + offset, p.y - offset};
        const Diagram diagram = compute(there, {.metric = metric}).value();
        const Region region = test::regionFrom({corners});
        return ClippedDiagram::from(diagram, region).value().areas();
      };
      const auto near = areasAt(0);
      for (const double offset : {0x1p20, 0x1p30}) {
        EXPECT_LT(largestDifference(areasAt(offset), near), 1e-15 * 256 * 256) << "at " << offset;
      }
    }
  }
}

struct ClipFixture {
  std::string name;
  ClipInput input;
  std::vector<double> areas;
  double largestEmptyDisc = 0;
};

std::vector<ClipFixture> clipFixtures() {
  std::vector<ClipFixture> fixtures;
  for (const auto& entry : std::filesystem::directory_iterator(test::fileOfFixtures("clips"))) {
    std::ifstream file(entry.path());
    const nlohmann::json json = nlohmann::json::parse(file);
    ClipFixture& fixture = fixtures.emplace_back();
    fixture.name = entry.path().stem().string();
    for (const nlohmann::json& c : json["circles"]) {
      fixture.input.circles.push_back({c[0].get<double>(), c[1].get<double>(), c[2].get<double>()});
    }
    for (const nlohmann::json& ring : json["rings"]) {
      auto& points = fixture.input.rings.emplace_back();
      for (const nlohmann::json& p : ring) points.push_back({p[0].get<double>(), p[1].get<double>()});
    }
    fixture.areas = json["areas"].get<std::vector<double>>();
    fixture.largestEmptyDisc = json["largestEmptyDisc"].get<double>();
  }
  return fixtures;
}

TEST(ClipFixtures, HaveTheRightAreas) {
  const auto fixtures = clipFixtures();
  EXPECT_GE(fixtures.size(), 10U);
  for (const ClipFixture& fixture : fixtures) {
    SCOPED_TRACE(fixture.name);
    const Region region = Region::fromRings(fixture.input.rings).value();
    const Diagram diagram = compute(fixture.input.circles).value();
    const auto clipped = ClippedDiagram::from(diagram, region);
    ASSERT_TRUE(clipped) << clipped.error().message;
    const double extent = extentOf(region);
    EXPECT_LT(largestDifference(clipped->areas(), fixture.areas), 1e-11 * extent * extent);
    const auto independent = areasByBruteForce(fixture.input.circles, region, Metric::circles, true);
    EXPECT_LT(largestDifference(clipped->areas(), independent), 1e-9 * extent * extent);
    EXPECT_NEAR(clipped->largestEmptyDisc()->disc.r, fixture.largestEmptyDisc,
                1e-11 * std::abs(fixture.largestEmptyDisc));
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(fixture.areas.size()); ++i) {
      test::expectSameAlone(*clipped, i);
    }
  }
}

TEST(ClipFixtures, HaveValidPolygons) {
  for (const ClipFixture& fixture : clipFixtures()) {
    SCOPED_TRACE(fixture.name);
    const Region region = Region::fromRings(fixture.input.rings).value();
    const Diagram diagram = compute(fixture.input.circles).value();
    const auto clipped = ClippedDiagram::from(diagram, region).value();
    const double extent = extentOf(region);
    const auto areas = areasOfValidPolygons(clipped, 1e-4 * extent);
    EXPECT_LT(largestDifference(areas, clipped.areas()), 1e-3 * extent * extent);
    EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), region.area(), 1e-12 * extent * extent);
  }
}

TEST(ClippedPolygons, AreRightWhereManyCornersLieAlongOneEdge) {
  // A comb whose teeth end on both sides of the curved edge between two circles, or touch it.
  const std::vector<Circle> circles = {{0, -200, 0}, {0, 200, 100}};
  const Diagram diagram = compute(circles).value();
  Region::Ring ring;
  for (int k = -1000; k <= 1000; ++k) {
    const double x = 0.1 * k;
    // By bisection, the height of the border.
    double low = -200;
    double high = 200;
    for (int i = 0; i < 60; ++i) {
      const double y = (low + high) / 2;
      (std::hypot(x, y + 200) < std::hypot(x, y - 200) - 100 ? low : high) = y;
    }
    ring.push_back({x, low + (k % 3 - 1) * 1e-4});
  }
  ring.push_back({110, 150});
  ring.push_back({-110, 150});
  const Region region = test::regionFrom({ring});
  const auto clipped = ClippedDiagram::from(diagram, region).value();
  for (const double tolerance : {1e-6, 1e-3, 10.0}) {
    const auto areas = areasOfValidPolygons(clipped, tolerance);
    EXPECT_NEAR(areas[0] + areas[1], region.area(), 1e-9 * region.area());
    EXPECT_NEAR(areas[0], clipped.areas()[0], 0.02 + 300 * std::min(tolerance, 1e-3));
  }
}

/// A clip whose parts can be corrupted.
class CorruptedClip : public testing::Test {
 protected:
  CorruptedClip() {
    std::mt19937_64 random(seedOr(55));
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Circle> circles;
    for (int i = 0; i < 30; ++i) circles.push_back({unit(random), unit(random), 0.05 * unit(random)});
    diagram_ = compute(circles).value();
    scope_ = {diagram_, std::nullopt};
    const auto clipped = ClippedDiagram::from(diagram_, region_).value();
    crossings_ = ClipParts::of(clipped).crossings;
    levels_.assign(ClipParts::of(clipped).arcs.levels().begin(), ClipParts::of(clipped).arcs.levels().end());
    arcs_.assign(ClipParts::of(clipped).arcs.all().begin(), ClipParts::of(clipped).arcs.all().end());
    moments_ = ClipParts::of(clipped).moments;
    EXPECT_EQ(fault(), nullptr);
    EXPECT_EQ(areaFault(), nullptr);
    EXPECT_FALSE(crossings_.rings.empty());
  }

  ClipRecord record() const { return {diagram_, region_, scope_, crossings_, levels_, arcs_}; }
  const char* fault() const { return faultOf(record()); }
  const char* areaFault() const { return faultOf(record(), moments_); }

  /// Expects that the judge notices a change of a part, and takes it back.
  template <class Part, class Change>
  void expectRefused(Part& part, Change change) {
    const Part right = part;
    change();
    EXPECT_NE(fault(), nullptr);
    part = right;
  }

  /// With a hole in one cell.
  Region region_ =
      test::regionFrom({{{0.1, 0.2}, {0.9, 0.1}, {0.8, 0.9}, {0.15, 0.8}}, {{0.5, 0.5}, {0.5001, 0.5}, {0.5, 0.5001}}});
  Diagram diagram_;
  ClipScope scope_ = {diagram_, std::nullopt};
  Crossings crossings_;
  std::vector<std::int32_t> levels_;
  std::vector<Arc> arcs_;
  CellMoments moments_;
};

TEST_F(CorruptedClip, IsRefusedForEachLevelThatIsWrong) {
  for (std::int32_t& level : levels_) {
    const std::int32_t right = level;
    for (const std::int32_t wrong : {-1, 0, 1, 2}) {
      level = wrong;
      EXPECT_EQ(fault() == nullptr, wrong == right);
    }
    level = right;
  }
}

TEST_F(CorruptedClip, IsRefusedForEachCrossingThatIsWrong) {
  const auto edges = static_cast<std::int32_t>(diagram_.edges.size());
  for (std::size_t c = 0; c < crossings_.all.size(); ++c) {
    auto& crossing = crossings_.all[c];
    auto& next = crossings_.next[c];
    expectRefused(crossing, [&] { crossing.isEntry = !crossing.isEntry; });
    expectRefused(crossing, [&] { crossing.edge = (crossing.edge + 1) % edges; });
    expectRefused(crossing, [&] { crossing.side = 4; });  // of the hole
    expectRefused(crossing, [&] { crossing.share = 1.5; });
    expectRefused(next, [&] { next = crossings_.next[at(next)]; });
    expectRefused(next, [&] { next = kNone; });
  }
  expectRefused(crossings_, [&] {
    crossings_.all.pop_back();
    crossings_.next.pop_back();
  });
}

TEST_F(CorruptedClip, IsRefusedForEachArcThatIsWrong) {
  const auto edges = static_cast<std::int32_t>(diagram_.edges.size());
  for (std::size_t a = 0; a < arcs_.size(); ++a) {
    expectRefused(arcs_, [&] { arcs_.erase(arcs_.begin() + static_cast<std::ptrdiff_t>(a)); });
    expectRefused(arcs_, [&] { arcs_.push_back(Arc(arcs_[a])); });
    expectRefused(arcs_, [&] { std::swap(arcs_[a].start, arcs_[a].end); });
    expectRefused(arcs_, [&] { arcs_[a].edge = (arcs_[a].edge + 1) % edges; });
  }
}

TEST_F(CorruptedClip, IsRefusedForARingThatIsNowhereOrTwice) {
  auto& rings = crossings_.rings;
  expectRefused(rings, [&] { rings.clear(); });
  expectRefused(rings, [&] { rings.insert(rings.end(), rings.front()); });
  expectRefused(rings, [&] { rings.front().ring = 7; });
}

TEST_F(CorruptedClip, IsRefusedForAreasThatAreOffByLittleMoreThanRoundingOrNegative) {
  auto& moments = moments_.moments;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const std::size_t other = (i + 1) % moments.size();
    const auto right = moments;
    for (const double wrong : {moments[i].area + 5e-11, std::nan("")}) {
      moments[i].area = wrong;
      EXPECT_NE(areaFault(), nullptr);
    }
    moments = right;
    moments[i].area += 1e-6;
    moments[other].area -= 1e-6;
    EXPECT_EQ(areaFault() == nullptr, moments[other].area >= -1e-9);
    moments = right;
  }
}

}  // namespace
}  // namespace circle_voronoi
