// SPDX-License-Identifier: GPL-3.0-or-later
// Unions of polygons as regions.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "circle_voronoi/io.h"
#include "circle_voronoi/region.h"
#include "fixtures.h"
#include "report.h"
#include "rings.h"

namespace circle_voronoi {
namespace {

using Ring = Region::Ring;
using Polygon = std::vector<Ring>;

constexpr RegionOptions kDissolve = {.dissolve = true};

Ring box(double minX, double minY, double maxX, double maxY) {
  return {{minX, minY}, {maxX, minY}, {maxX, maxY}, {minX, maxY}};
}

Region unionOf(const std::vector<Polygon>& polygons) {
  const auto region = Region::fromPolygons(polygons, kDissolve);
  if (!region) throw std::runtime_error(region.error().message);
  return *region;
}

std::string errorOf(const std::vector<Polygon>& polygons) {
  const auto region = Region::fromPolygons(polygons);
  return region ? "" : region.error().message;
}

bool isInAny(const std::vector<Polygon>& polygons, Point p) {
  return std::ranges::any_of(polygons, [&](const Polygon& polygon) {
    return std::ranges::count_if(polygon, [&](const Ring& ring) { return test::isInRing(ring, p); }) % 2 == 1;
  });
}

double distanceToSides(const std::vector<Polygon>& polygons, Point p) {
  double least = 1e300;
  for (const Polygon& polygon : polygons) {
    for (const Ring& ring : polygon) least = std::min(least, test::distanceToRing(ring, p));
  }
  return least;
}

TEST(Dissolve, MergesPolygonsThatShareABorder) {
  // Whole, with T-junctions on either side, and in a single point.
  EXPECT_EQ(unionOf({{box(0, 0, 5, 5)}, {box(5, 0, 9, 5)}}).area(), 45);
  const Region three = unionOf({{box(0, 0, 5, 5)}, {box(5, -1, 9, 2)}, {box(5, 2, 7, 9)}});
  EXPECT_EQ(three.area(), 25 + 12 + 14);
  EXPECT_EQ(three.ringCount(), 1U);
  EXPECT_EQ(unionOf({{box(0, 0, 1, 1)}, {box(1, 1, 2, 2)}, {box(1, 0, 2, 1)}}).area(), 3);
  EXPECT_EQ(unionOf({{box(0, 0, 1, 1)}, {box(0, 0, 1, 1)}}).area(), 1);
}

TEST(Dissolve, MergesPolygonsThatOverlapNestOrFillHoles) {
  EXPECT_EQ(unionOf({{box(0, 0, 4, 4)}, {box(2, 2, 6, 6)}}).area(), 28);
  EXPECT_EQ(unionOf({{box(0, 0, 9, 9)}, {box(2, 2, 6, 6)}}).area(), 81);
  EXPECT_EQ(unionOf({{box(0, 0, 9, 9), box(2, 2, 6, 6)}, {box(2, 2, 6, 6)}}).area(), 81);
  EXPECT_EQ(unionOf({{box(0, 0, 9, 9), box(2, 2, 6, 6)}, {box(3, 1, 5, 7)}}).area(), 81 - 16 + 8);
  const Region ring = unionOf({{box(0, 0, 3, 1)}, {box(2, 0, 3, 3)}, {box(0, 2, 3, 3)}, {box(0, 0, 1, 3)}});
  EXPECT_EQ(ring.area(), 8);
  EXPECT_EQ(ring.ringCount(), 2U);
  EXPECT_FALSE(ring.contains({1.5, 1.5}));
}

TEST(Dissolve, CutsTheInsideApartWhereRingsTouch) {
  // A hole that touches the outer ring twice, and three holes that touch each other around a triangle.
  const Region two = unionOf({{box(0, 0, 4, 4), {{2, 0}, {3, 2}, {2, 4}, {1, 2}}}});
  EXPECT_EQ(two.polygonCount(), 2U);
  EXPECT_EQ(two.area(), 12);
  const Region island =
      unionOf({{box(0, 0, 12, 12), {{4, 4}, {8, 4}, {6, 2}}, {{8, 4}, {6, 8}, {9, 8}}, {{6, 8}, {4, 4}, {3, 8}}}});
  EXPECT_EQ(island.polygonCount(), 2U);
  EXPECT_DOUBLE_EQ(island.area(), 144 - 4 - 6 - 6);
}

TEST(Dissolve, DropsPartsWithoutArea) {
  EXPECT_EQ(unionOf({{box(0, 0, 2, 2)}, {{{0, 0}, {2, 2}}}, {{{0, 0}, {1, 0}, {2, 0}}}}).area(), 4);
  const std::vector<Polygon> flat = {{{{0, 0}, {1, 0}, {2, 0}}}};
  EXPECT_EQ(Region::fromPolygons(flat, kDissolve).error().message, "The region has no area.");
  // A bow tie is two triangles, and a spike is nothing.
  EXPECT_EQ(unionOf({{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}}).area(), 2);
  EXPECT_EQ(unionOf({{{{0, 0}, {2, 0}, {2, 2}, {2, 5}, {2, 2}, {0, 2}}}}).area(), 4);
}

TEST(Dissolve, KeepsTheRuleOfRings) {
  const std::vector<Ring> rings = {box(0, 0, 4, 4), box(1, 1, 4, 3), box(4, 0, 6, 4)};
  const auto region = Region::fromRings(rings, kDissolve);
  ASSERT_TRUE(region) << region.error().message;
  EXPECT_EQ(region->area(), 24 - 6);
}

TEST(Dissolve, KeepsAValidRegionAsItIs) {
  const std::vector<Polygon> polygons = {{{{0.1, 0.2}, {5.3, 0.7}, {3, 4}}, {{2, 1}, {3, 1}, {3, 2}}},
                                         {box(7, 7, 8, 8)}};
  const Region plain = Region::fromPolygons(polygons).value();
  const Region same = unionOf(polygons);
  EXPECT_TRUE(std::ranges::equal(plain.points(), same.points()));
  EXPECT_TRUE(std::ranges::equal(plain.ringOffsets(), same.ringOffsets()));
}

TEST(Dissolve, IsNamedByErrorsAboutSeveralPolygons) {
  const std::string advice = " Set `dissolve` to merge them.";
  EXPECT_EQ(
      errorOf({{box(0, 0, 5, 5)}, {box(5, 0, 9, 5)}}),
      "Side 1 of ring 0 of polygon 0 of the region and side 3 of ring 0 of polygon 1 of the region overlap beside "
      "(5, 0)." +
          advice);
  EXPECT_TRUE(errorOf({{box(0, 0, 4, 4)}, {box(2, 2, 6, 6)}}).ends_with(advice));
  EXPECT_TRUE(errorOf({{box(0, 0, 9, 9)}, {box(2, 2, 6, 6)}}).ends_with(advice));
  EXPECT_FALSE(errorOf({{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}}).ends_with(advice));
  const std::string text = "MULTIPOLYGON (((0 0,5 0,5 10,0 10,0 0)),((5 0,10 0,10 10,5 10,5 0)))";
  EXPECT_TRUE(readRegion(text, "text").error().message.ends_with(advice));
  EXPECT_EQ(readRegion(text, "text", kDissolve).value().area(), 100);
}

Ring randomRing(std::mt19937& random, int kind) {
  const auto below = [&](unsigned count) { return static_cast<double>(random() % count); };
  const auto digit = [&] { return std::ldexp(static_cast<double>(static_cast<int>(random() % 5) - 2), -50); };
  Ring ring;
  const std::size_t count = 3 + random() % 5;
  for (std::size_t k = 0; k < count; ++k) {
    switch (kind) {
      case 0:  // integers, so that sides are shared and touch
        ring.push_back({below(7), below(7)});
        break;
      case 1:  // a grid that is off by a digit
        ring.push_back({below(5) + digit(), below(5) + digit()});
        break;
      case 2:
        ring.push_back({below(1000) / 7, below(1000) / 9});
        break;
      default:  // thin and long
        ring.push_back({below(1000), below(3) + digit()});
    }
  }
  return ring;
}

/// Rings of any kind, most of which cross themselves, are a valid region; and a point away from all sides is in the
/// region exactly if it is in one of the polygons.
TEST(Dissolve, ContainsThePointsOfThePolygons) {
  std::mt19937 random(static_cast<std::uint32_t>(test::seedOr(1)));
  int compared = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const int kind = trial % 4;
    std::vector<Polygon> polygons;
    for (std::size_t k = 0; k < 1 + random() % 6; ++k) {
      Polygon polygon;
      for (std::size_t r = 0; r < 1 + random() % 2; ++r) polygon.push_back(randomRing(random, kind));
      polygons.push_back(std::move(polygon));
    }
    const auto region = Region::fromPolygons(polygons, kDissolve);
    if (!region) {
      EXPECT_EQ(region.error().message, "The region has no area.") << trial;
      continue;
    }
    const Box bounds = region->bounds();
    for (int k = 0; k < 30; ++k) {
      const auto share = [&] { return 1.2 * static_cast<double>(random() % 1024) / 1024 - 0.1; };
      const Point p = {bounds.minX + share() * (bounds.maxX - bounds.minX),
                       bounds.minY + share() * (bounds.maxY - bounds.minY)};
      if (distanceToSides(polygons, p) < 1e-9) continue;
      ++compared;
      EXPECT_EQ(region->contains(p), isInAny(polygons, p)) << trial << ": " << p.x << ' ' << p.y;
    }
  }
  EXPECT_GT(compared, 50'000);
}

TEST(Dissolve, TakesManySides) {
  // A map of squares, each of its own sides, and every third one moved by a digit.
  std::vector<Polygon> polygons;
  constexpr int kSide = 60;
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      const double x = i / 7.0;
      const double y = j / 7.0;
      const double by = (i + j) % 3 == 0 ? 0x1p-49 : 0;
      polygons.push_back({box(x, y, (i + 1) / 7.0 + by, (j + 1) / 7.0 + by)});
    }
  }
  const Region region = unionOf(polygons);
  EXPECT_NEAR(region.area(), kSide * kSide / 49.0, 1e-11);
  EXPECT_EQ(region.polygonCount(), 1U);
}

/// A ring around a point, of corners at any distance between a share of the radius and all of it.
Ring starAround(Point center, double radius, double least, std::size_t corners, std::mt19937& random) {
  constexpr double kTurn = 6.283185307179586;
  Ring ring;
  for (std::size_t k = 0; k < corners; ++k) {
    const double share = least + (1 - least) * static_cast<double>(random() % 65536) / 65536;
    const double angle = kTurn * static_cast<double>(k) / static_cast<double>(corners) + 0.3;
    ring.push_back({center.x + radius * share * std::cos(angle), center.y + radius * share * std::sin(angle)});
  }
  return ring;
}

/// Moves a number by up to `most` steps of doubles.
double movedByDigits(double value, int most, std::mt19937& random) {
  const int steps = static_cast<int>(random() % static_cast<unsigned>(2 * most + 1)) - most;
  for (int k = 0; k < std::abs(steps); ++k) value = std::nextafter(value, steps < 0 ? -1e300 : 1e300);
  return value;
}

Ring movedByDigits(Ring ring, int most, std::mt19937& random) {
  for (Point& p : ring) p = {movedByDigits(p.x, most, random), movedByDigits(p.y, most, random)};
  return ring;
}

/// Sides of copies of a polygon that differ in their last digits cross anew wherever crossings are rounded.
TEST(Dissolve, EndsForCopiesThatDifferInTheLastDigits) {
  std::mt19937 random(static_cast<std::uint32_t>(test::seedOr(3)));
  for (int trial = 0; trial < 400; ++trial) {
    const std::size_t corners = std::array<std::size_t, 6>{3, 4, 7, 12, 40, 200}[random() % 6];
    const std::size_t copies = std::array<std::size_t, 5>{2, 3, 8, 15, 30}[random() % 5];
    if (corners * copies > 1000) continue;
    const double radius = std::array{1.0, 1e-9, 1e9}[random() % 3];
    const double far = std::array{0.0, 0.0, 1.0, 1e3, -1e6}[random() % 5] * radius;
    const Point center = {far, 0.7 * far};
    const int digits = 1 + trial % 4;
    const Ring ring = starAround(center, radius, std::array{0.9, 0.5, 0.1}[random() % 3], corners, random);
    std::vector<Polygon> polygons;
    for (std::size_t k = 0; k < copies; ++k) {
      Ring copy = movedByDigits(ring, digits, random);
      std::rotate(copy.begin(), copy.begin() + static_cast<std::ptrdiff_t>(random() % corners), copy.end());
      if (random() % 2 == 0) std::ranges::reverse(copy);
      polygons.push_back({std::move(copy)});
    }
    const Region region = unionOf(polygons);
    const double digit = 0x1p-52 * (std::abs(far) + radius);
    EXPECT_NEAR(region.area(), test::areaOf(ring), 4 * (digits + 4) * digit * test::regionFrom({ring}).perimeter())
        << trial;
    // Two copies of a side cross once at most.
    EXPECT_LE(region.sideCount(), corners * (copies * copies + 4 * copies)) << trial;
  }
}

TEST(Dissolve, EndsForTheCopiesOfAFixture) {
  std::ifstream file(test::fileOfFixtures("regions/copies-off-by-last-digits.geojson"));
  const std::string text((std::istreambuf_iterator<char>(file)), {});
  const auto region = readRegion(text, "copies", kDissolve);
  ASSERT_TRUE(region) << region.error().message;
  EXPECT_EQ(region->polygonCount(), 1U);
  // The area of the first copy, in fractions.
  EXPECT_NEAR(region->area(), 0.7305337845063771, 1e-14);
  EXPECT_LE(region->sideCount(), 7U * 8 * 12);
}

/// Squares of a map whose corners are off by some digits, and grids that cross under nearly the same directions.
TEST(Dissolve, KeepsAreasWhereSidesAlmostCoincide) {
  std::mt19937 random(static_cast<std::uint32_t>(test::seedOr(4)));
  for (int trial = 0; trial < 60; ++trial) {
    std::vector<Polygon> polygons;
    const int side = 2 + trial % 9;
    const double far = trial % 3 == 0 ? 1e5 : 0;
    const double angle = trial % 2 == 0 ? 0 : 0.1 * trial;
    const double x = std::cos(angle);
    const double y = std::sin(angle);
    for (int i = 0; i < side; ++i) {
      for (int j = 0; j < side; ++j) {
        Ring ring;
        for (const auto& [u, v] : {std::pair{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}) {
          ring.push_back({far + u * x - v * y, far + u * y + v * x});
        }
        polygons.push_back({movedByDigits(ring, 1 + trial % 4, random)});
      }
    }
    const Region region = unionOf(polygons);
    EXPECT_NEAR(region.area(), side * side, 0x1p-48 * (far + side) * side * side * 8) << trial;
  }
}

}  // namespace
}  // namespace circle_voronoi
