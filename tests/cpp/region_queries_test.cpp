// SPDX-License-Identifier: GPL-3.0-or-later
// The largest empty disc inside a region, against known values and an independent search.
#include "circle_voronoi/region_queries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <vector>

#include "circle_voronoi/compute.h"
#include "random.h"
#include "report.h"

namespace circle_voronoi {
namespace region_queries_test {
namespace {

using Ring = Region::Ring;
using Circles = std::vector<Circle>;

using test::regionFrom;

EmptyDisc discIn(const Circles& circles, const Region& region) {
  return largestEmptyDiscInside(compute(circles).value(), region).value().value();
}

/// The clearest path between points that a region joins.
ClearestPath pathIn(const Region& region, const Circles& circles, Point p, Point q) {
  const ClearestPath path = clearestPath(compute(circles).value(), p, q, region).value().value();
  EXPECT_EQ(test::faultOf(region, circles, p, q, path, 1e-9), "");
  return path;
}

const Ring kRoom = {{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 6}, {0, 6}};

/// The distance of a point from the nearest circle or side; negative outside the region.
double clearanceOf(const Circles& circles, const std::vector<Ring>& rings, Point p) {
  double least = 1e300;
  bool isInside = false;
  for (const Ring& ring : rings) {
    isInside ^= test::isInRing(ring, p);
    least = std::min(least, test::distanceToRing(ring, p));
  }
  return isInside ? std::min(least, test::clearanceAlong(circles, p, p)) : -least;
}

/// The largest clearance that a search from many places finds.
double searched(const Circles& circles, const std::vector<Ring>& rings, double size, Random& random) {
  constexpr int kGrid = 60;
  struct Start {
    double clearance;
    Point point;
  };
  std::vector<Start> starts;
  for (int i = 0; i <= kGrid; ++i) {
    for (int j = 0; j <= kGrid; ++j) {
      const Point p = {-size + 2 * size * i / kGrid, -size + 2 * size * j / kGrid};
      starts.push_back({clearanceOf(circles, rings, p), p});
    }
  }
  std::ranges::sort(starts, std::ranges::greater(), &Start::clearance);
  double best = starts.front().clearance;
  for (std::size_t k = 0; k < 25; ++k) {
    auto [clearance, p] = starts[k];
    for (double step = 2 * size / kGrid; step > 1e-9 * size; step *= 0.7) {
      for (int turn = 0; turn < 24; ++turn) {
        const Vector v = random.direction();
        const Point q = {p.x + step * v.x, p.y + step * v.y};
        const double there = clearanceOf(circles, rings, q);
        if (there <= clearance) continue;
        clearance = there;
        p = q;
      }
    }
    best = std::max(best, clearance);
  }
  return best;
}

TEST(LargestDiscInRegion, OfARoomTouchesTwoWallsAndTheCorner) {
  const auto found = discIn({}, regionFrom({kRoom}));
  const double r = 2 * std::numbers::sqrt2 / (1 + std::numbers::sqrt2);
  EXPECT_NEAR(found.disc.r, r, 1e-15);
  EXPECT_NEAR(found.disc.x, r, 1e-15);
  EXPECT_NEAR(found.disc.y, r, 1e-15);
  EXPECT_EQ(found.circles, (std::array<CircleIndex, 3>{kNone, kNone, kNone}));
}

TEST(LargestDiscInRegion, KeepsAwayFromCirclesAndIslands) {
  // A pillar where the arms meet leaves the ends of the arms, where a disc touches three walls.
  const auto beside = discIn({{1, 1, 0.9}}, regionFrom({kRoom}));
  EXPECT_NEAR(beside.disc.r, 1, 1e-15);
  // Between two squares.
  const Ring outer = {{-4, -4}, {4, -4}, {4, 4}, {-4, 4}};
  const Ring island = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const auto around = discIn({}, regionFrom({outer, island}));
  // It touches two walls and the corner of the island.
  const double r = 3 * std::numbers::sqrt2 / (1 + std::numbers::sqrt2);
  EXPECT_NEAR(around.disc.r, r, 1e-14);
  const auto last = discIn({{-2.5, -2.5, 0}, {2.5, -2.5, 0}, {-2.5, 2.5, 0}}, regionFrom({outer, island}));
  EXPECT_NEAR(last.disc.r, r, 1e-14);
  EXPECT_GT(last.disc.x, 0);
  EXPECT_GT(last.disc.y, 0);
}

TEST(LargestDiscInRegion, OfACorridorIsAsWideAsTheCorridor) {
  const auto found = discIn({}, regionFrom({{{0, 0}, {1000, 0}, {1000, 1}, {0, 1}}}));
  EXPECT_EQ(found.disc.r, 0.5);
}

TEST(LargestDiscInRegion, MayTouchManySides) {
  Ring ring;
  for (int k = 0; k < 400; ++k) {
    const Vector v = directionAt(k / 400.0);
    ring.push_back({5 * v.x, 5 * v.y});
  }
  const auto found = discIn({}, regionFrom({ring}));
  EXPECT_NEAR(found.disc.r, 5 * std::cos(std::numbers::pi / 400), 1e-13);
}

TEST(LargestDiscInRegion, IsTheSameAtAnyScale) {
  const Circles circles = {{1, 1, 0.25}, {4, 0.5, 0.1875}, {0.5, 4, 0.125}};
  const auto one = discIn(circles, regionFrom({kRoom}));
  for (const double scale : {0x1p-50, 0x1p+90}) {
    Ring room = kRoom;
    for (Point& p : room) p = {scale * p.x, scale * p.y};
    Circles scaled = circles;
    for (Circle& c : scaled) c = {scale * c.x, scale * c.y, scale * c.r};
    const auto other = discIn(scaled, regionFrom({room}));
    EXPECT_EQ(other.disc.r, scale * one.disc.r);
    EXPECT_EQ(other.disc.x, scale * one.disc.x);
    EXPECT_EQ(other.circles, one.circles);
  }
}

TEST(LargestDiscInRegion, OfACoveredRegionIsThatOfItsCenters) {
  const auto found = discIn({{3, 3, 9}}, regionFrom({kRoom}));
  EXPECT_NEAR(found.disc.r, 3 * std::numbers::sqrt2 - 9, 1e-12);
}

TEST(LargestDiscInRegion, IsWhatASearchFinds) {
  const char* text = std::getenv("CIRCLE_VORONOI_REGION_TRIALS");
  const int trials = text == nullptr ? 40 : std::atoi(text);
  Random random(test::seedOr(7));
  for (int trial = 0; trial < trials; ++trial) {
    SCOPED_TRACE(trial);
    // A star, perhaps with a star of a hole.
    const auto star = [&](double least, double most, bool isWhole) {
      Ring ring;
      const std::size_t count = 4 + random.below(9);
      for (std::size_t k = 0; k < count; ++k) {
        const Vector v = directionAt((static_cast<double>(k) + random.uniform(0, 0.8)) / static_cast<double>(count));
        const double r = random.uniform(least, most);
        ring.push_back({r * v.x, r * v.y});
        if (isWhole) ring.back() = {std::round(ring.back().x), std::round(ring.back().y)};
      }
      return ring;
    };
    const bool isWhole = random.below(2) == 0;
    std::vector<Ring> rings = {star(4, 10, isWhole)};
    if (random.below(2) == 0) rings.push_back(star(1, 2, false));
    const auto region = Region::fromRings(rings);
    if (!region) continue;
    Circles circles;
    for (std::size_t k = random.below(6); k > 0; --k) {
      circles.push_back(
          {random.uniform(-8, 8), random.uniform(-8, 8), random.below(2) == 0 ? 0 : random.uniform(0, 1.5)});
    }
    const auto found = largestEmptyDiscInside(compute(circles).value(), *region).value();
    const double best = searched(circles, rings, 10, random);
    if (best <= 0) continue;
    ASSERT_TRUE(found);
    EXPECT_NEAR(clearanceOf(circles, rings, {found->disc.x, found->disc.y}), found->disc.r, 1e-13);
    // No search finds a larger disc, and the disc is empty.
    EXPECT_GE(found->disc.r, best - 1e-12);
  }
}

TEST(LargestDiscInRegion, DoesNotDependOnHolesUnderCircles) {
  // Large circles around a small gap, and holes at the centers of squares that the search divides.
  Random random(test::seedOr(8));
  for (int trial = 0; trial < 300; ++trial) {
    SCOPED_TRACE(trial);
    const Point gap = {random.uniform(-7, 7), random.uniform(-7, 7)};
    const double size = random.logUniform(-1, 0.3);
    const std::size_t count = 3 + random.below(3);
    Circles circles;
    for (std::size_t k = 0; k < count; ++k) {
      const Vector v = directionAt((static_cast<double>(k) + random.uniform(0, 0.4)) / static_cast<double>(count));
      const double r = random.logUniform(0.7, 2);
      const double distance = r + size * random.uniform(0.7, 1.3);
      circles.push_back({gap.x + distance * v.x, gap.y + distance * v.y, r});
    }
    std::vector<Ring> rings = {{{-8, -8}, {8, -8}, {8, 8}, {-8, 8}}};
    const double bare = discIn(circles, regionFrom(rings)).disc.r;
    for (double x = -7.5; x < 8; ++x) {
      for (double y = -7.5; y < 8; ++y) {
        const double d = 0.025;
        const auto covers = [&](const Circle& c) { return std::hypot(x - c.x, y - c.y) + 2 * d < c.r; };
        if (std::ranges::none_of(circles, covers)) continue;
        rings.push_back({{x - d, y - d}, {x + d, y - d}, {x + d, y + d}, {x - d, y + d}});
      }
    }
    const double found = discIn(circles, regionFrom(rings)).disc.r;
    if (std::max(bare, found) > 0) {
      EXPECT_NEAR(found, bare, 1e-9);
    }
  }
}

TEST(LargestDiscInRegion, IsInTheWidestOfManyThinStripsInAnyDirection) {
  Random random(test::seedOr(11));
  for (const double slant : {0.0, 37.0, -1000.0}) {
    SCOPED_TRACE(slant);
    std::vector<std::vector<Ring>> strips;
    double widest = 0;
    for (int k = 0; k < 200; ++k) {
      const double x = k + random.uniform(0, 0.1);
      const double width = random.uniform(0.3, 0.6);
      widest = std::max(widest, width);
      strips.push_back({{{x, 0}, {x + width, 0}, {x + width + slant, 100}, {x + slant, 100}}});
    }
    const Region region = Region::fromPolygons(strips).value();
    const auto found = discIn({{1e4, 1e4, 1}}, region);
    EXPECT_NEAR(found.disc.r, widest / 2 * 100 / std::hypot(slant, 100), 1e-11);
    EXPECT_TRUE(region.contains({found.disc.x, found.disc.y}));
  }
}

TEST(LargestDiscInRegion, IsInTheWidestGapOfStreetsOfManyDirections) {
  Random random(test::seedOr(12));
  for (int trial = 0; trial < 20; ++trial) {
    SCOPED_TRACE(trial);
    // Quarters of parallel streets, each in a direction of its own. A circle divides some streets.
    std::vector<Ring> rings;
    Circles circles;
    for (int quarter = 0; quarter < 5; ++quarter) {
      const Vector v = directionAt(random.uniform(0, 1));
      for (int k = 0; k < 20; ++k) {
        const double width = random.uniform(0.2, 0.4);
        const auto at = [&](double along, double across) {
          return Point{300 * quarter + along * v.x - across * v.y, along * v.y + across * v.x};
        };
        rings.push_back({at(-100, k), at(100, k), at(100, k + width), at(-100, k + width)});
        if (random.below(3) != 0) continue;
        const Point p = at(random.uniform(-100, 100), k + random.uniform(0, width));
        circles.push_back({p.x, p.y, random.uniform(0, 0.2)});
      }
    }
    circles.push_back({0, 1e4, 1});
    const double found = discIn(circles, regionFrom(rings)).disc.r;
    double widest = 0;
    for (const Ring& ring : rings)
      widest = std::max(widest, std::hypot(ring[2].x - ring[1].x, ring[2].y - ring[1].y) / 2);
    // Each street is longer than its circle.
    EXPECT_NEAR(found, widest, 1e-9);
  }
}

/// The distance of a point from a side, in more digits than doubles have.
long double distanceToSide(Point p, Point a, Point b) {
  const long double x = static_cast<long double>(b.x) - a.x;
  const long double y = static_cast<long double>(b.y) - a.y;
  const long double px = static_cast<long double>(p.x) - a.x;
  const long double py = static_cast<long double>(p.y) - a.y;
  const long double ahead = (px * x + py * y) / (x * x + y * y);
  if (ahead <= 0) return std::sqrt(px * px + py * py);
  if (ahead >= 1) return std::hypot(static_cast<long double>(p.x) - b.x, static_cast<long double>(p.y) - b.y);
  return std::abs(x * py - y * px) / std::sqrt(x * x + y * y);
}

TEST(LargestDiscInRegion, StaysInsideWhereTheRegionIsAFewUnitsOfRoundingWide) {
  Random random(test::seedOr(5));
  int found = 0;
  int thin = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const auto movedBy = [](double value, std::size_t ulps) {
      for (; ulps > 0; --ulps) value = std::nextafter(value, 1e300);
      return value;
    };
    const Point a = {random.uniform(1, 2), random.uniform(1, 2)};
    const Point b = {random.uniform(2, 3), random.uniform(-3, 3)};
    const Ring ring = {a, b, {b.x, movedBy(b.y, random.below(40))}, {a.x, movedBy(a.y, 1 + random.below(40))}};
    const auto region = Region::fromRings(std::vector<Ring>{ring});
    if (!region) continue;
    const auto disc = largestEmptyDiscInside(compute(Circles{{5, 5, 1}}).value(), *region);
    if (!disc) {
      ++thin;
      EXPECT_EQ(disc.error().message, "The region is so thin that rounding leaves no disc inside it.");
      continue;
    }
    ++found;
    const Vertex& its = (*disc)->disc;
    EXPECT_GT(its.r, 0);
    EXPECT_TRUE(region->contains({its.x, its.y}));
    for (std::size_t k = 0; k < region->sideCount(); ++k) {
      const Point end = region->points()[(k + 1) % region->sideCount()];
      EXPECT_LE(its.r, distanceToSide({its.x, its.y}, region->points()[k], end) * (1 + 0x1p-8L)) << trial;
    }
  }
  EXPECT_GT(found, 50);
  EXPECT_GT(thin, 0);
}

/// The robots of a field, after a report about a planner whose paths left the field.
const Circles kRobots = {{-3, 0, 0.09},    {-1.5, 1.2, 0.09}, {-1.4, -1.6, 0.09},
                         {0.4, 0.3, 0.09}, {1.9, -0.7, 0.09}, {2.6, 1.9, 0.09}};

TEST(PathInRegion, StaysInTheField) {
  const Ring strip = {{-4, -0.5}, {4, -0.5}, {4, 0.5}, {-4, 0.5}};
  const Point p = {-3.8, 0.1};
  const Point q = {3.8, 0.2};
  const double clearance = pathIn(regionFrom({strip}), kRobots, p, q).clearance;
  // Between the first robot and the border.
  EXPECT_NEAR(clearance, 0.41, 1e-12);
  EXPECT_LT(clearance, clearestPath(compute(kRobots).value(), p, q).clearance);
}

TEST(PathInRegion, GoesAroundTheCornerOfARoomAndNotThroughItsWalls) {
  const Circles circles = {{5, 5, 1}, {1, 3, 0.1}};
  EXPECT_NEAR(pathIn(regionFrom({kRoom}), circles, {0.5, 5.5}, {5.5, 0.5}).clearance, 0.9, 1e-12);
}

TEST(PathInRegion, IsAsClearBackAlongOneEdge) {
  const Circles circles = {{0, 0, 1}, {10, 0, 1}};
  const Ring hall = {{-3, -6}, {13, -6}, {13, 6}, {-3, 6}};
  for (const double y : {4.0, -4.0}) {
    EXPECT_NEAR(pathIn(regionFrom({hall}), circles, {4.9, y}, {4.8, -y}).clearance, 4, 1e-12);
  }
}

TEST(PathInRegion, IsNoneBetweenPartsAndAnErrorFromOutside) {
  const Diagram diagram = compute(Circles{{0.2, 0.2, 0.1}}).value();
  const Region islands = regionFrom({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{2, 0}, {3, 0}, {3, 1}, {2, 1}}});
  EXPECT_FALSE(clearestPath(diagram, {0.5, 0.5}, {2.5, 0.5}, islands).value());
  EXPECT_TRUE(clearestPath(diagram, {2.5, 0.5}, {2.6, 0.4}, islands).value());
  const auto outside = clearestPath(diagram, {1.5, 0.5}, {2.6, 0.4}, islands);
  ASSERT_FALSE(outside);
  EXPECT_EQ(outside.error().code, ErrorCode::badOption);
  EXPECT_EQ(outside.error().message, "The start of the path lies outside the region.");
  EXPECT_EQ(clearestPath(diagram, {2.6, 0.4}, {1.5, 0.5}, islands).error().message,
            "The end of the path lies outside the region.");
}

TEST(PathInRegion, StartsAtACornerOnABisectorAndAtACenterOnTheBorder) {
  // The corner (0, 1) is equally far from both circles.
  const Ring square = {{0, 1}, {1, 1}, {1, 2}, {0, 2}};
  EXPECT_EQ(pathIn(regionFrom({square}), {{0, 0, 0}, {0, 2, 0}}, {0, 1}, {1, 2}).clearance, 1);
  const Ring unit = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_EQ(pathIn(regionFrom({unit}), {{1, 1, 0}}, {1, 1}, {0, 0}).clearance, 0);

  // The center lies on the border of one arm of a U.
  const Ring u = {{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
  pathIn(regionFrom({u}), {{1, 2, 0}}, {1, 2}, {2.5, 2.5});
}

TEST(PathInRegion, BeginsWhereTheRayFromTheCenterEnds) {
  const Circles circles = {{0, 0, 1}, {10, 0, 1}};
  const Ring hall = {{-3, -6}, {13, -6}, {13, 6}, {-3, 6}};
  const auto path = pathIn(regionFrom({hall}), circles, {2, 2}, {11, 1});
  ASSERT_TRUE(path.entry && path.exit);
  EXPECT_NEAR(path.entry->x, 5, 1e-12);
  EXPECT_NEAR(path.entry->y, 5, 1e-12);
  EXPECT_NEAR(path.exit->x, 13, 1e-12);
  EXPECT_NEAR(path.exit->y, 3, 1e-12);
  // A path that needs no ray begins at its start.
  const auto along = pathIn(regionFrom({hall}), circles, {5, 0}, {5, 1});
  EXPECT_EQ(along.edges, std::vector<EdgeIndex>{0});
  EXPECT_EQ(along.clearance, 4);
}

TEST(PathInRegion, TakesCirclesOfTheirOwnMetric) {
  const Region room = regionFrom({kRoom});
  Diagram diagram = compute(kRobots).value();
  diagram.metric = Metric::centers;
  for (const Diagram& wrong : {diagram, Diagram{}}) {
    const auto path = clearestPath(wrong, {1, 1}, {1, 5}, room);
    ASSERT_FALSE(path);
    EXPECT_EQ(path.error().message, "A clearest path takes a diagram of one circle or more.");
  }
  const auto disc = largestEmptyDiscInside(diagram, room);
  ASSERT_FALSE(disc);
  EXPECT_EQ(disc.error().message, "The largest empty disc takes a diagram of the metric circles.");
}

}  // namespace
}  // namespace region_queries_test
}  // namespace circle_voronoi
