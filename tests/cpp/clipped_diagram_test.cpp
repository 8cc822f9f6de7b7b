// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/clipped_diagram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <random>
#include <span>
#include <tuple>
#include <utility>

#include "circle_voronoi/compute.h"
#include "circle_voronoi/finder.h"
#include "circle_voronoi_families/families.h"
#include "in_outline.h"
#include "region_shapes.h"
#include "report.h"
#include "rings.h"
#include "same_cells.h"

namespace circle_voronoi {
namespace {

using test::hardRegions;
using test::RegionShape;
using test::seedOr;

// A clip refers to its diagram and its region, so neither may be a temporary object.
template <class ItsDiagram, class ItsRegion>
constexpr bool kCanClip = requires(ItsDiagram&& diagram, ItsRegion&& region) {
  ClippedDiagram::from(std::forward<ItsDiagram>(diagram), std::forward<ItsRegion>(region));
  ClippedDiagram::from(std::forward<ItsDiagram>(diagram), std::forward<ItsRegion>(region), 1.0);
};
template <class ItsDiagram, class ItsRegion>
constexpr bool kCanClipCells = requires(ItsDiagram&& diagram, ItsRegion&& region, std::span<const CircleIndex> cells) {
  ClippedDiagram::ofCells(std::forward<ItsDiagram>(diagram), std::forward<ItsRegion>(region), cells);
  ClippedDiagram::ofCells(std::forward<ItsDiagram>(diagram), std::forward<ItsRegion>(region), cells, 1.0);
};
static_assert(kCanClip<const Diagram&, const Region&> && kCanClip<Diagram&, Region&>);
static_assert(!kCanClip<Diagram, const Region&> && !kCanClip<const Diagram, const Region&>);
static_assert(!kCanClip<const Diagram&, Region> && !kCanClip<const Diagram&, const Region>);
static_assert(kCanClipCells<const Diagram&, const Region&> && kCanClipCells<Diagram&, Region&>);
static_assert(!kCanClipCells<Diagram, const Region&> && !kCanClipCells<const Diagram, const Region&>);
static_assert(!kCanClipCells<const Diagram&, Region> && !kCanClipCells<const Diagram&, const Region>);

double sumOf(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// Circles in the unit square, on a grid, in each other, with one huge.
std::vector<std::pair<std::string, std::vector<Circle>>> inputs(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<std::pair<std::string, std::vector<Circle>>> all;
  auto& few = all.emplace_back("few", std::vector<Circle>()).second;
  for (int i = 0; i < 5; ++i) few.push_back({unit(random), unit(random), 0.1 * unit(random)});
  auto& many = all.emplace_back("many", std::vector<Circle>()).second;
  for (int i = 0; i < 300; ++i) many.push_back({unit(random), unit(random), 0.03 * unit(random)});
  auto& grid = all.emplace_back("grid", std::vector<Circle>()).second;
  for (int i = 0; i < 10; ++i) {
    for (int j = 0; j < 10; ++j) grid.push_back({2.0 * i, 2.0 * j, 0.5});
  }
  auto& mixed = all.emplace_back("grid of two sizes", std::vector<Circle>()).second;
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 8; ++j) mixed.push_back({4.0 * i, 3.0 * j, (i + j) % 2 == 0 ? 1.0 : 0.25});
  }
  auto& huge = all.emplace_back("one huge", std::vector<Circle>{{0.5, 0.5, 0.3}}).second;
  for (int i = 0; i < 100; ++i) huge.push_back({unit(random), unit(random), 0.01 * unit(random)});
  auto& overlapping = all.emplace_back("overlapping", std::vector<Circle>()).second;
  for (int i = 0; i < 60; ++i) overlapping.push_back({unit(random), unit(random), 0.4 * unit(random)});
  auto& far = all.emplace_back("far from the origin", std::vector<Circle>()).second;
  for (int i = 0; i < 40; ++i) far.push_back({1e6 + unit(random), -3e6 + unit(random), 0.05 * unit(random)});
  all.emplace_back("one", std::vector<Circle>{{0.3, 0.4, 0.1}});
  all.emplace_back("two", std::vector<Circle>{{0.3, 0.4, 0.1}, {0.8, 0.3, 0.02}});
  all.emplace_back("three in a row", std::vector<Circle>{{0, 0, 0.1}, {1, 0, 0.1}, {2, 0, 0.1}});
  return all;
}

/// Calls `check` with many diagrams and regions that are hard for them.
template <class Check>
void forHardRegions(Check check) {
  const std::uint64_t seed = seedOr(30);
  std::mt19937_64 random(seed);
  for (const auto& [name, circles] : inputs(random)) {
    for (const Metric metric : {Metric::circles, Metric::centers, Metric::power}) {
      const Diagram diagram = compute(circles, {.metric = metric}).value();
      for (const RegionShape& shape : hardRegions(diagram, random)) {
        SCOPED_TRACE(name + ", " + std::string(metricName(metric)) + ", " + shape.name + ", seed " +
                     std::to_string(seed));
        const auto clipped = ClippedDiagram::from(diagram, shape.region);
        ASSERT_TRUE(clipped) << clipped.error().message;
        check(diagram, shape.region, *clipped);
      }
    }
  }
}

TEST(ClippedDiagram, OutlinesAreClosedAndShareTheirPoints) {
  forHardRegions([](const Diagram& diagram, const Region&, const ClippedDiagram& clipped) {
    // The ends of each piece of an edge, in the direction of the edge, and how often it occurs.
    std::map<std::tuple<std::int32_t, double, double, double, double>, std::array<int, 2>> pieces;
    for (std::size_t i = 0; i < diagram.circles.size(); ++i) {
      for (const auto& loop : clipped.outline(static_cast<std::int32_t>(i))) {
        for (std::size_t k = 0; k < loop.size(); ++k) {
          const EdgeCurve& curve = loop[k].curve;
          EXPECT_EQ(curve.end, loop[(k + 1) % loop.size()].curve.start);
          if (loop[k].side == kNone) continue;
          const bool isAlong = loop[k].side % 2 == 0;
          const Point start = isAlong ? curve.start : curve.end;
          const Point end = isAlong ? curve.end : curve.start;
          ++pieces[{Diagram::edgeOf(loop[k].side), start.x, start.y, end.x, end.y}][isAlong ? 0 : 1];
        }
      }
    }
    for (const auto& [piece, count] : pieces) EXPECT_EQ(count[0], count[1]);
  });
}

TEST(ClippedDiagram, AreasAreThoseOfTheOutlinesAndSumToThatOfTheRegion) {
  forHardRegions([](const Diagram&, const Region& region, const ClippedDiagram& clipped) {
    const std::vector<double> areas = clipped.areas();
    const Box box = region.bounds();
    // For regions that are thinner than rounding.
    const double thin = 1e-16 * region.perimeter() * (box.maxX - box.minX + box.maxY - box.minY);
    EXPECT_NEAR(sumOf(areas), region.area(), 1e-12 * region.area() + thin);
    const double farthest = std::max({std::abs(box.minX), std::abs(box.minY), std::abs(box.maxX), std::abs(box.maxY)});
    const double rounding = 1e-14 * farthest * region.perimeter();
    for (std::size_t i = 0; i < areas.size(); ++i) {
      EXPECT_NEAR(area(clipped.outline(static_cast<std::int32_t>(i))), areas[i], rounding);
    }
  });
}

/// Expects that cells have the random points of a box that are in the region, nearest to their circles, and within the
/// distance.
void expectSamples(const ClippedDiagram& clipped, const Box& box, int count, std::mt19937_64& random) {
  const Diagram& diagram = clipped.diagram();
  const Finder finder(diagram);
  std::uniform_real_distribution<double> x(box.minX, box.maxX);
  std::uniform_real_distribution<double> y(box.minY, box.maxY);
  for (int k = 0; k < count; ++k) {
    const Point p = {x(random), y(random)};
    const CircleIndex nearest = finder.find(p);
    double gap = -1e300;
    if (const auto most = clipped.maxDistance()) {
      const double its = distanceFrom(diagram, nearest, p);
      // A power is the square of a length.
      gap = diagram.metric == Metric::power ? std::copysign(std::sqrt(std::abs(its)), its) - *most : its - *most;
    }
    double least = std::abs(gap);
    for (const SideIndex side : diagram.sides(nearest)) {
      least = std::min(least, distanceDifference(diagram, nearest, diagram.neighborOf(side), p));
    }
    if (least < 1e-9 * (std::abs(p.x) + std::abs(p.y))) continue;
    bool isInside = false;
    for (const auto& loop : clipped.outline(nearest)) isInside ^= hasInLoop(loop, p);
    EXPECT_EQ(isInside, gap < 0 && clipped.region().contains(p)) << p.x << " " << p.y << " in " << nearest;
  }
}

TEST(ClippedDiagram, ContainsWhatIsInTheRegionAndNearest) {
  std::mt19937_64 random(seedOr(31));
  forHardRegions([&](const Diagram&, const Region& region, const ClippedDiagram& clipped) {
    expectSamples(clipped, region.bounds(), 40, random);
  });
}

TEST(ClippedDiagram, ARegionAndItsComplementAddUp) {
  std::mt19937_64 random(seedOr(33));
  const Region::Ring box = {{-0.5, -0.5}, {1.5, -0.5}, {1.5, 1.5}, {-0.5, 1.5}};
  for (const auto& [name, circles] : inputs(random)) {
    const Diagram diagram = compute(circles, {.metric = Metric::circles}).value();
    const Region::Ring star = test::starRing(random, {0.5, 0.5}, 0.1, 0.9, 50);
    const Region whole = test::regionFrom({box});
    const Region inside = test::regionFrom({star});
    const Region outside = test::regionFrom({box, star});
    const auto areasIn = [&](const Region& region) { return ClippedDiagram::from(diagram, region)->areas(); };
    const auto all = areasIn(whole);
    const auto parts = areasIn(inside);
    const auto rest = areasIn(outside);
    for (std::size_t i = 0; i < circles.size(); ++i) EXPECT_NEAR(parts[i] + rest[i], all[i], 1e-13) << name;
  }
}

TEST(ClippedDiagram, NeighborsShareAnEdgeInTheRegion) {
  const Diagram diagram =
      compute(std::vector<Circle>{{0, 0, 1}, {4, 0, 1}, {2, 3, 1}}, {.metric = Metric::circles}).value();
  const Region all = Region::from(Box{-9, -9, 9, 9}).value();
  EXPECT_EQ(ClippedDiagram::from(diagram, all)->neighbors(0).size(), 2U);
  // Below the vertex only the edge of the first two circles is left, and in a hole of the region none.
  const Region below = Region::from(Box{-1, -5, 5, 0}).value();
  EXPECT_EQ(ClippedDiagram::from(diagram, below)->neighbors(0), std::vector<CircleIndex>{1});
  EXPECT_TRUE(ClippedDiagram::from(diagram, below)->neighbors(2).empty());
  const Region ring =
      test::regionFrom({{{-1, -5}, {1.9, -5}, {1.9, 0}, {-1, 0}}, {{2.1, -5}, {5, -5}, {5, 0}, {2.1, 0}}});
  EXPECT_TRUE(ClippedDiagram::from(diagram, ring)->neighbors(0).empty());
}

TEST(ClippedDiagram, MaxDistanceAndRegionAreWhatSamplesSay) {
  std::mt19937_64 random(seedOr(34));
  for (const auto& [name, circles] : inputs(random)) {
    if (name == "grid" || name == "grid of two sizes" || name == "far from the origin") continue;
    for (const Metric metric : {Metric::circles, Metric::centers, Metric::power}) {
      const Diagram diagram = compute(circles, {.metric = metric}).value();
      const Region region = test::regionFrom(
          {test::starRing(random, {0.5, 0.5}, 0.3, 0.8, 40), test::starRing(random, {0.5, 0.5}, 0.02, 0.2, 11)});
      for (const double distance : {0.02, 0.1, 0.3, 5.0}) {
        SCOPED_TRACE(name + ", " + std::string(metricName(metric)) + ", " + std::to_string(distance));
        const ClippedDiagram clipped = ClippedDiagram::from(diagram, region, distance).value();
        expectSamples(clipped, {-0.2, -0.2, 1.2, 1.2}, 200, random);
        if (distance < 5) continue;
        const auto near = clipped.areas();
        const auto all = ClippedDiagram::from(diagram, region)->areas();
        for (std::size_t i = 0; i < circles.size(); ++i) EXPECT_NEAR(near[i], all[i], 1e-13);
      }
    }
  }
}

TEST(ClippedDiagram, FlatArraysAreTheOutlines) {
  std::mt19937_64 random(seedOr(35));
  const auto circles = inputs(random)[1].second;
  const Diagram diagram = compute(circles, {.metric = Metric::circles}).value();
  const Region region = test::regionFrom(
      {test::starRing(random, {0.5, 0.5}, 0.1, 0.6, 40), test::starRing(random, {0.5, 0.5}, 0.001, 0.01, 5)});
  for (const std::optional<double> distance : {std::optional<double>(), std::optional<double>(0.05)}) {
    const ClippedDiagram clipped = ClippedDiagram::from(diagram, region, distance).value();
    const ClippedCells cells = clipped.cells();
    ASSERT_EQ(cells.loopOffsets.size(), circles.size() + 1);
    std::size_t piece = 0;
    std::size_t loop = 0;
    for (std::size_t i = 0; i < circles.size(); ++i) {
      const Outline expected = clipped.outline(static_cast<std::int32_t>(i));
      ASSERT_EQ(static_cast<std::size_t>(cells.loopOffsets[i + 1] - cells.loopOffsets[i]), expected.size());
      for (const auto& pieces : expected) {
        EXPECT_EQ(cells.isHole[loop++] != 0, area({pieces}) < 0);
        for (const OutlinePiece& one : pieces) {
          EXPECT_EQ(cells.x[piece], one.curve.start.x);
          EXPECT_EQ(cells.y[piece], one.curve.start.y);
          EXPECT_EQ(cells.side[piece], one.side);
          EXPECT_EQ(cells.regionSide[piece], one.regionSide);
          EXPECT_EQ(cells.r[piece], one.r);
          ++piece;
        }
        EXPECT_EQ(cells.pieceOffsets[loop], static_cast<std::int32_t>(piece));
      }
    }
    const ClippedCells some = clipped.cells(std::vector<CircleIndex>{7, 3});
    EXPECT_EQ(some.loopOffsets.size(), 3U);
    EXPECT_EQ(some.loopOffsets[1], cells.loopOffsets[8] - cells.loopOffsets[7]);
    const ClippedEdges edges = clipped.edges();
    std::size_t row = 0;
    for (EdgeIndex e = 0; e < static_cast<std::int32_t>(diagram.edges.size()); ++e) {
      for (const EdgeCurve& part : clipped.edgeParts(e)) {
        EXPECT_EQ(edges.edge[row], e);
        EXPECT_EQ(edges.start[row], part.start);
        EXPECT_EQ(edges.end[row], part.end);
        EXPECT_EQ(edges.from[row], part.from);
        EXPECT_EQ(edges.to[row], part.to);
        ++row;
      }
    }
    EXPECT_EQ(edges.edge.size(), row);
  }
}

TEST(ClippedDiagram, MeasuresWithinADistanceAreThoseOfTheOutlines) {
  std::mt19937_64 random(seedOr(37));
  const auto circles = inputs(random)[1].second;
  const Diagram diagram = compute(circles, {.metric = Metric::circles}).value();
  const Region region = test::regionFrom({test::starRing(random, {0.5, 0.5}, 0.1, 0.6, 40)});
  const ClippedDiagram clipped = ClippedDiagram::from(diagram, region, 0.05).value();
  const std::vector<double> areas = clipped.areas();
  const std::vector<Point> centroids = clipped.centroids();
  const std::vector<double> perimeters = clipped.perimeters();
  int empty = 0;
  int arcs = 0;
  for (std::size_t i = 0; i < circles.size(); ++i) {
    const Outline outline = clipped.outline(static_cast<std::int32_t>(i));
    EXPECT_EQ(areas[i], area(outline));
    EXPECT_EQ(perimeters[i], perimeter(outline));
    if (outline.empty()) {
      ++empty;
      EXPECT_TRUE(std::isnan(centroids[i].x) && std::isnan(centroids[i].y));
    } else {
      EXPECT_EQ(centroids[i], centroid(outline));
    }
    for (const auto& loop : outline) arcs += static_cast<int>(std::ranges::count_if(loop, &OutlinePiece::isOnCircle));
  }
  EXPECT_GT(empty, 0);
  EXPECT_GT(arcs, 10);
}

TEST(ClippedDiagram, AnEndThatTheMaximumDistanceCutsLiesOnNoSideOfTheRegion) {
  const Region region = test::regionFrom({{{-4, -1}, {4, -1}, {4, 4}, {-4, 4}}});
  // The edge goes along the y axis, up or down.
  for (const std::vector<Circle>& circles : {std::vector<Circle>{{-1, 0, 0}, {1, 0, 0}}, {{1, 0, 0}, {-1, 0, 0}}}) {
    const Diagram diagram = compute(circles).value();
    const ClippedEdges edges = ClippedDiagram::from(diagram, region, 3).value().edges();
    ASSERT_EQ(edges.edge.size(), 1U);
    const bool isUp = edges.start[0].y < edges.end[0].y;
    EXPECT_EQ((isUp ? edges.start : edges.end)[0].y, -1);
    EXPECT_EQ((isUp ? edges.startSide : edges.endSide)[0], 0);
    EXPECT_NEAR((isUp ? edges.end : edges.start)[0].y, std::sqrt(8), 1e-15);
    EXPECT_EQ((isUp ? edges.endSide : edges.startSide)[0], kNone);
  }
}

TEST(ClippedDiagram, SomeCellsAreClippedAsAllAre) {
  std::mt19937_64 random(seedOr(36));
  forHardRegions([&](const Diagram& diagram, const Region& region, const ClippedDiagram& clipped) {
    const auto count = static_cast<std::int32_t>(diagram.circles.size());
    std::set<CircleIndex> some;
    for (std::int32_t i = 0; i < count; i += 3) some.insert(i);
    // A few at random, some with all neighbors.
    std::uniform_int_distribution<std::int32_t> pick(0, count - 1);
    for (int k = 0; k < 3; ++k) {
      const CircleIndex i = pick(random);
      some.insert(i);
      for (const CircleIndex neighbor : neighbors(diagram, i)) some.insert(neighbor);
    }
    const auto chosen = ClippedDiagram::ofCells(diagram, region, std::vector<CircleIndex>(some.rbegin(), some.rend()));
    ASSERT_TRUE(chosen) << chosen.error().message;
    for (std::int32_t i = 0; i < count; ++i) {
      SCOPED_TRACE("cell " + std::to_string(i));
      if (some.contains(i)) {
        test::expectSameCell(clipped, i, *chosen, i, [](CircleIndex j) { return std::int32_t{j}; });
        EXPECT_EQ(chosen->areas()[static_cast<std::size_t>(i)], clipped.area(i));
        test::expectSameAlone(clipped, i);
      } else {
        EXPECT_EQ(chosen->placeOf(i), ClippedDiagram::Place::outside);
      }
    }
  });
}

TEST(ClippedDiagram, OfEquallyLargeEmptyDiscsTheFirstIsTheLargest) {
  const Diagram diagram = compute(std::vector<Circle>{{0, 0, 0.5}}).value();
  const Box box = {-1, -1, 1, 1};
  const Region region = Region::from(box).value();
  const auto found = ClippedDiagram::from(diagram, region)->largestEmptyDisc();
  EXPECT_EQ(found->disc.x, -1);
  EXPECT_EQ(found->disc.y, -1);
}

TEST(ClippedDiagram, RefusesUnsupportedArguments) {
  const std::vector<Circle> circles = {{0, 0, 1}, {4, 0, 1}};
  const Diagram diagram = compute(circles, {.metric = Metric::circles}).value();
  const Region region = Region::from(Box{0, 0, 1, 1}).value();
  EXPECT_EQ(ClippedDiagram::from(diagram, region, 1.3e30).error().code, ErrorCode::badOption);
  const Diagram none = compute(std::vector<Circle>{}, {.metric = Metric::circles}).value();
  EXPECT_TRUE(ClippedDiagram::from(none, region)->areas().empty());
  EXPECT_FALSE(ClippedDiagram::from(none, region)->largestEmptyDisc());
}

TEST(ClippedDiagram, HolesFollowTheLoopsAroundThemAlsoWithinADistance) {
  const auto square = [](double x, double y, double size) {
    return Region::Ring{{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
  };
  const std::vector<std::vector<Region::Ring>> polygons = {{square(0, 0, 3)},
                                                           {square(6, 6, 4), square(6.5, 6.5, 0.5)},
                                                           {square(0, 7, 3)},
                                                           {square(4, 4, 1.9), square(4.5, 4.5, 1)}};
  const Diagram diagram = compute(std::vector<Circle>{{5, 5, 1}, {40, 5, 1}}).value();
  const Region region = Region::fromPolygons(polygons).value();
  const Outline outline = ClippedDiagram::from(diagram, region, 3)->outline(0);
  ASSERT_EQ(outline.size(), 6U);
  int holes = 0;
  std::size_t around = 0;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    if (area(Outline{outline[k]}) > 0) {
      around = k;
      continue;
    }
    ++holes;
    EXPECT_TRUE(hasInLoop(outline[around], outline[k].front().curve.start)) << "loop " << k;
  }
  EXPECT_EQ(holes, 2);
}

}  // namespace
}  // namespace circle_voronoi
