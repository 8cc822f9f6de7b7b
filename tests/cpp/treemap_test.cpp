// SPDX-License-Identifier: GPL-3.0-or-later
// Treemaps, judged by the areas and the parts of their polygons.
#include "circle_voronoi/treemap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "at.h"
#include "circle_voronoi/fit_areas.h"
#include "divide_region.h"
#include "random.h"
#include "region_shapes.h"
#include "report.h"

namespace circle_voronoi::treemap_test {
namespace {

using Polygons = std::vector<std::vector<Region::Ring>>;
using Nodes = std::vector<TreemapNode>;

Region regionOf(const Polygons& polygons) { return Region::fromPolygons(polygons).value(); }

Polygons polygonsOf(const Treemap& map, std::size_t node) {
  const ClippedPolygons& all = map.polygons;
  Polygons polygons;
  for (auto p = at(all.polygonOffsets[node]); p < at(all.polygonOffsets[node + 1]); ++p) {
    auto& rings = polygons.emplace_back();
    for (auto r = at(all.ringOffsets[p]); r < at(all.ringOffsets[p + 1]); ++r) {
      rings.emplace_back(all.points.begin() + all.pointOffsets[r], all.points.begin() + all.pointOffsets[r + 1]);
    }
  }
  return polygons;
}

double areaOf(const Polygons& polygons) { return polygons.empty() ? 0 : regionOf(polygons).area(); }

Region pentagon() { return test::regionFrom({{{0, 0}, {5, -1}, {8, 3}, {4, 7}, {-1, 4}}}); }

/// A tree of nodes with a few children each, values over decades, and some of them zero.
Nodes randomTree(std::size_t size, std::size_t branches, double decades, Random& random) {
  Nodes nodes = {{-1, 0}};
  for (std::size_t i = 1; i < size; ++i) {
    const auto parent = static_cast<std::int32_t>((i - 1) / branches);
    nodes.push_back({parent, random.below(20) == 0 ? 0 : random.logUniform(0, decades)});
  }
  return nodes;
}

/// Each point lies on a side of the region, but for rounding, or inside.
void expectInside(const Polygons& polygons, const Region& region, double slack) {
  const auto isNear = [&](Point p) { return region.contains(p) || !region.sidesNear(std::vector{p}, slack).empty(); };
  for (const auto& rings : polygons) {
    for (const Region::Ring& ring : rings) {
      for (const Point p : ring) EXPECT_TRUE(isNear(p)) << p.x << ' ' << p.y;
    }
  }
}

void expectTreemap(const Nodes& nodes, const Treemap& map, const Region& region, double polygonSlack) {
  ASSERT_EQ(map.polygons.polygonOffsets.size(), nodes.size() + 1);
  std::vector<double> values(nodes.size(), 0);
  std::vector<double> ofChildren(nodes.size(), 0);
  std::vector<int> children(nodes.size(), 0);
  for (std::size_t i = nodes.size(); i-- > 0;) {
    if (children[i] == 0) values[i] = nodes[i].value;
    if (i == 0) break;
    values[at(nodes[i].parent)] += values[i];
    ++children[at(nodes[i].parent)];
    ofChildren[at(nodes[i].parent)] += areaOf(polygonsOf(map, i));
  }
  const double size = std::sqrt(region.area());
  double error = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    SCOPED_TRACE("node " + std::to_string(i));
    const Polygons polygons = polygonsOf(map, i);
    EXPECT_NEAR(map.values[i], values[i], 1e-12 * values[i]);
    const double target = values[i] / values[0] * region.area();
    EXPECT_NEAR(map.areas[i], target, 1e-9 * target);
    EXPECT_NEAR(areaOf(polygons), target, 1e-9 * target + polygonSlack * size * std::sqrt(target));
    if (target == 0) {
      EXPECT_TRUE(polygons.empty());
      continue;
    }
    error = std::max(error, std::abs(map.areas[i] - target) / target);
    if (children[i] > 0) {
      EXPECT_NEAR(ofChildren[i], target, 2e-9 * target);
    }
    if (i > 0) expectInside(polygons, regionOf(polygonsOf(map, at(nodes[i].parent))), 1e-14 * size);
  }
  EXPECT_NEAR(map.error, error, 1e-14);
}

TEST(Treemap, FillsEachCellWithTheCellsOfItsChildren) {
  Random random(5);
  for (const std::size_t branches : {2U, 5U, 40U}) {
    for (const double decades : {0.0, 2.0, 4.0}) {
      for (const Metric metric : {Metric::power, Metric::circles}) {
        SCOPED_TRACE(std::to_string(branches) + " branches, " + std::to_string(decades) + " decades");
        const Nodes nodes = randomTree(120, branches, decades, random);
        TreemapOptions options;
        options.metric = metric;
        const auto map = treemap(nodes, pentagon(), options);
        ASSERT_TRUE(map) << map.error().message;
        expectTreemap(nodes, *map, pentagon(), metric == Metric::power ? 0 : 0x1p-10);
      }
    }
  }
}

TEST(Treemap, WorksInRegionsOfAnyShape) {
  Random random(6);
  const Region::Ring square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const Region::Ring hole = {{0.2, 0.2}, {0.8, 0.2}, {0.8, 0.8}, {0.2, 0.8}};
  const Region::Ring far = {{3, 0}, {4, 0}, {4, 1}, {3, 1}};
  const std::vector<Region> regions = {Region::fromRings(std::vector{square, hole, far}).value(),
                                       test::regionFrom({test::combRing({0, 0, 1, 1}, 6)}),
                                       test::regionFrom({test::spiralRing({0, 0, 1, 1}, 2)})};
  for (std::size_t k = 0; k < regions.size(); ++k) {
    SCOPED_TRACE("region " + std::to_string(k));
    const Nodes nodes = randomTree(60, 6, 1, random);
    const auto map = treemap(nodes, regions[k]);
    ASSERT_TRUE(map) << map.error().message;
    expectTreemap(nodes, *map, regions[k], 0);
  }
}

TEST(Treemap, OfConvexRegionsHasConvexCells) {
  Random random(7);
  const auto map = treemap(randomTree(150, 6, 2, random), pentagon()).value();
  for (std::size_t i = 0; i < map.values.size(); ++i) {
    if (map.values[i] == 0) continue;
    const Polygons polygons = polygonsOf(map, i);
    ASSERT_EQ(polygons.size(), 1U);
    ASSERT_EQ(polygons[0].size(), 1U);
    const Region::Ring& ring = polygons[0][0];
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point p = ring[k];
      const Point q = ring[(k + 1) % ring.size()];
      const Point r = ring[(k + 2) % ring.size()];
      EXPECT_GE((q.x - p.x) * (r.y - q.y) - (q.y - p.y) * (r.x - q.x), -1e-13);
    }
  }
}

/// The mean roundness of the cells of leaves, which is 1 for discs.
double roundnessOf(const Treemap& map, const Nodes& nodes) {
  double sum = 0;
  double count = 0;
  std::vector<bool> isLeaf(nodes.size(), true);
  for (std::size_t i = 1; i < nodes.size(); ++i) isLeaf[at(nodes[i].parent)] = false;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!isLeaf[i] || map.values[i] == 0) continue;
    const Region cell = regionOf(polygonsOf(map, i));
    sum += 4 * 3.141592653589793 * cell.area() / (cell.perimeter() * cell.perimeter());
    ++count;
  }
  return sum / count;
}

TEST(Treemap, RelaxingMakesCellsRounder) {
  Random random(8);
  const Nodes nodes = randomTree(200, 12, 2, random);
  TreemapOptions options;
  options.relax = 0;
  const double before = roundnessOf(treemap(nodes, pentagon(), options).value(), nodes);
  const double after = roundnessOf(treemap(nodes, pentagon()).value(), nodes);
  EXPECT_GT(after, before);
  EXPECT_GT(after, 0.7);
}

std::vector<std::optional<Circle>> sitesOf(const Treemap& map) {
  std::vector<std::optional<Circle>> sites;
  for (std::size_t i = 0; i < map.values.size(); ++i) {
    sites.push_back(map.values[i] > 0 ? std::optional(map.sites[i]) : std::nullopt);
  }
  return sites;
}

TEST(Treemap, KeepsTheSitesOfAnEarlierOne) {
  Random random(9);
  Nodes nodes = randomTree(100, 9, 2, random);
  const auto before = treemap(nodes, pentagon()).value();
  const auto sites = sitesOf(before);
  TreemapOptions options;
  options.previous = sites;
  const auto same = treemap(nodes, pentagon(), options).value();
  for (std::size_t i = 0; i < nodes.size(); ++i) EXPECT_EQ(polygonsOf(same, i), polygonsOf(before, i));

  for (std::size_t i = nodes.size() - 20; i < nodes.size(); ++i) nodes[i].value *= 1.01;
  const auto after = treemap(nodes, pentagon(), options).value();
  expectTreemap(nodes, after, pentagon(), 0);
  int moved = 0;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const Circle& a = before.sites[i];
    const Circle& b = after.sites[i];
    moved += a.x != b.x || a.y != b.y ? 1 : 0;
  }
  EXPECT_LE(moved, 5);
}

// Rounding of the largest area is more than the smallest one.
TEST(Treemap, ReachesValuesOverEightDecadesAtAnyScale) {
  Random random(test::seedOr(12));
  for (int exponent = -50; exponent <= 60; exponent += 10) {
    const double size = std::ldexp(1.0, exponent);
    const Region square = Region::from(Box{3 * size, 3 * size, 4 * size, 4 * size}).value();
    for (const std::size_t branches : {3U, 9U, 60U}) {
      SCOPED_TRACE("2^" + std::to_string(exponent) + ", " + std::to_string(branches) + " branches");
      const Nodes nodes = randomTree(60, branches, 8, random);
      const auto map = treemap(nodes, square);
      ASSERT_TRUE(map) << map.error().message;
      EXPECT_LE(map->error, 1e-9);
    }
  }
}

TEST(Treemap, OfEqualValuesInASquareIsAGrid) {
  const Nodes nodes = {{-1, 0}, {0, 1}, {0, 1}, {0, 1}, {0, 1}};
  const auto map = treemap(nodes, Region::from(Box{0, 0, 2, 2}).value()).value();
  for (std::size_t i = 1; i < 5; ++i) EXPECT_NEAR(map.areas[i], 1, 1e-9);
}

TEST(Treemap, RefusesWhatIsNoTreeWithTheNode) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [](const Nodes& nodes) { return treemap(nodes, pentagon()).error(); };
  const auto expectRefused = [&](const Nodes& nodes, std::int64_t node) {
    const Error error = refused(nodes);
    EXPECT_EQ(error.code, ErrorCode::badInput) << error.message;
    EXPECT_EQ(error.circle, node) << error.message;
  };
  expectRefused({}, kNone);
  expectRefused({{-1, 0}, {0, 1}, {2, 1}}, 2);
  expectRefused({{-1, 0}, {-1, 1}}, 1);
  expectRefused({{3, 0}, {0, 1}}, 0);
  expectRefused({{-1, 0}, {0, 1}, {0, -1}}, 2);
  expectRefused({{-1, 0}, {0, nan}}, 1);
  expectRefused({{-1, 0}, {0, 0}, {0, 0}}, 0);
}

TEST(Treemap, TellsItsProgressAndStopsWhereTheCallerThrows) {
  Random random(10);
  const Nodes nodes = randomTree(50, 4, 1, random);
  TreemapOptions options;
  std::size_t last = 0;
  std::size_t all = 0;
  options.progress = [&](std::size_t done, std::size_t count) {
    EXPECT_GE(done, last);
    EXPECT_LE(done, count);
    last = done;
    all = count;
  };
  EXPECT_TRUE(treemap(nodes, pentagon(), options));
  EXPECT_EQ(last, all);
  options.progress = [](std::size_t done, std::size_t) {
    if (done == 2) throw std::runtime_error("enough");
  };
  EXPECT_THROW(treemap(nodes, pentagon(), options), std::runtime_error);
}

TEST(Treemap, StartsInPartsOfTheRightAreas) {
  Random random(11);
  std::vector<double> shares;
  for (int i = 0; i < 500; ++i) shares.push_back(random.logUniform(0, 3));
  const std::vector<Point> middles = middlesOfParts(pentagon(), shares);
  for (const Point p : middles) EXPECT_TRUE(pentagon().contains(p));
  std::vector<Point> sorted = middles;
  std::ranges::sort(sorted, {}, [](Point p) { return std::pair(p.x, p.y); });
  EXPECT_EQ(std::ranges::adjacent_find(sorted), sorted.end());
}

}  // namespace
}  // namespace circle_voronoi::treemap_test
