// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/region.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <span>

#include "circle_voronoi/limits.h"
#include "region_shapes.h"
#include "report.h"
#include "rings.h"

namespace circle_voronoi {
namespace {

using Ring = Region::Ring;

Ring square(double x, double y, double size) { return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}}; }

/// The message of a refusal; empty: the region is valid.
std::string messageOf(const Result<Region>& region) {
  if (region) return "";
  EXPECT_EQ(region.error().code, ErrorCode::badOption);
  return region.error().message;
}

std::string messageOf(const std::vector<Ring>& rings) { return messageOf(Region::fromRings(rings)); }
std::string messageOfPolygons(const std::vector<std::vector<Ring>>& polygons) {
  return messageOf(Region::fromPolygons(polygons));
}

TEST(Region, TakesBothDirectionsClosedRingsAndRepeatedPoints) {
  const Region plain = test::regionFrom({square(0, 0, 4)});
  EXPECT_EQ(plain.area(), 16);
  EXPECT_EQ(plain.perimeter(), 16);
  const Region other = test::regionFrom({{{0, 0}, {0, 0}, {0, 4}, {4, 4}, {4, 4}, {4, 0}, {0, 0}, {0, 0}}});
  EXPECT_EQ(other.area(), 16);
  EXPECT_EQ(other.sideCount(), 4U);
  // Outer rings run counter-clockwise.
  EXPECT_EQ(std::vector<Point>(other.points().begin(), other.points().end()),
            (std::vector<Point>{{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
}

std::vector<Ring> nestedRings() {
  return {square(3, 3, 1), square(0, 0, 10), square(1, 1, 5), square(2, 2, 3), square(20, 0, 1)};
}

TEST(Region, NestsRingsByContainment) {
  const Region region = Region::fromRings(nestedRings()).value();
  EXPECT_EQ(region.polygonCount(), 3U);
  EXPECT_EQ(region.ringCount(), 5U);
  EXPECT_EQ(region.area(), 100 - 25 + 9 - 1 + 1);
  EXPECT_TRUE(region.contains({0.5, 0.5}));
  EXPECT_FALSE(region.contains({1.5, 1.5}));
  EXPECT_TRUE(region.contains({2.5, 2.5}));
  EXPECT_FALSE(region.contains({3.5, 3.5}));
  EXPECT_TRUE(region.contains({20.5, 0.5}));
  EXPECT_FALSE(region.contains({15, 0.5}));
}

TEST(Region, ContainsItsBoundary) {
  const std::vector<Ring> rings = nestedRings();
  const Region region = Region::fromRings(rings).value();
  for (const Ring& ring : rings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point a = ring[k];
      const Point b = ring[(k + 1) % ring.size()];
      EXPECT_TRUE(region.contains(a)) << a.x << " " << a.y;
      EXPECT_TRUE(region.contains({(a.x + b.x) / 2, (a.y + b.y) / 2})) << a.x << " " << a.y;
    }
  }
}

TEST(Region, TellsWhetherItContainsAnyPoint) {
  const Region region = test::regionFrom({{{0, 0}, {1, 1}, {0, 1}}});
  for (const double tiny : {0x1p-60, 0x1p-96, 0x1p-97, 1e-60, 1e-300, 5e-324, -5e-324}) {
    EXPECT_TRUE(region.contains({tiny, tiny})) << tiny;
    EXPECT_TRUE(region.contains({tiny, 1})) << tiny;
  }
  EXPECT_FALSE(region.contains({0x1p-95, 0x1p-96}));
  constexpr double kHuge = std::numeric_limits<double>::max();
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  for (const double far : {0x1p100, 1e60, 1e200, kHuge, kInfinite, std::numeric_limits<double>::quiet_NaN()}) {
    for (const double sign : {-1.0, 1.0}) {
      EXPECT_FALSE(region.contains({sign * far, 0.5})) << sign * far;
      EXPECT_FALSE(region.contains({0.5, sign * far})) << sign * far;
      EXPECT_FALSE(region.contains({sign * far, sign * far})) << sign * far;
    }
  }
}

TEST(Region, TakesPolygonsWithHoles) {
  const std::vector<std::vector<Ring>> polygons = {{square(0, 0, 10), square(1, 1, 2), square(4, 4, 2)},
                                                   {square(4.5, 4.5, 1)}};
  const Region region = Region::fromPolygons(polygons).value();
  EXPECT_EQ(region.area(), 100 - 4 - 4 + 1);
  EXPECT_EQ(region.perimeter(), 40 + 8 + 8 + 4);
  EXPECT_EQ(region.polygonCount(), 2U);
  EXPECT_EQ(region.polygonOf(region.ringOf(5)), 0);
  EXPECT_EQ(region.ringOf(5), 1);
  EXPECT_EQ(region.ringOf(12), 3);
  // Holes above and beside each other, and an island in the upper one.
  const std::vector<std::vector<Ring>> many = {
      {square(0, 0, 10), square(1, 1, 2), square(1, 5, 2), square(6, 1, 2), square(6, 5, 2)}, {square(6.5, 5.5, 1)}};
  const auto other = Region::fromPolygons(many);
  ASSERT_TRUE(other) << other.error().message;
  EXPECT_EQ(other->area(), 100 - 4 * 4 + 1);
}

TEST(Region, RefusesRingsThatCrossThemselves) {
  EXPECT_EQ(messageOf({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}),
            "Side 0 of ring 0 of the region and side 2 of ring 0 of the region cross at (1, 1).");
  // Sides are counted as in the input, with repeated points.
  EXPECT_EQ(messageOf({{{0, 0}, {0, 0}, {2, 2}, {2, 2}, {2, 0}, {0, 2}}}),
            "Side 1 of ring 0 of the region and side 4 of ring 0 of the region cross at (1, 1).");
  // Through a corner, and back along a side.
  EXPECT_EQ(messageOf({{{0, 0}, {4, 0}, {2, 2}, {4, 4}, {0, 4}, {2, 2}}}),
            "Side 2 of ring 0 of the region and side 5 of ring 0 of the region touch at (2, 2).");
  EXPECT_NE(messageOf({{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}}).find("touch at (2, 0)"), std::string::npos);
  EXPECT_NE(messageOf({{{0, 0}, {4, 0}, {6, 0}, {4, 0}, {4, 4}}}).find("overlap beside"), std::string::npos);
  EXPECT_NE(messageOf({{{0, 0}, {4, 0}, {4, 4}, {4, 8}, {4, 2}, {0, 4}}}).find("overlap beside"), std::string::npos);
}

TEST(Region, RefusesRingsThatCrossOrOverlapOthers) {
  EXPECT_EQ(messageOf({square(0, 0, 2), square(1, 1, 2)}),
            "Side 2 of ring 0 of the region and side 3 of ring 1 of the region cross at (1, 2).");
  EXPECT_NE(messageOf({square(0, 0, 2), square(2, 0, 2)}).find("overlap beside"), std::string::npos);
  EXPECT_NE(messageOf({square(0, 0, 2), square(0, 0, 2)}).find("overlap beside"), std::string::npos);
  // Crossing in corners alone.
  EXPECT_NE(messageOf({{{0, 0}, {4, 0}, {4, 4}}, {{3, -1}, {4, 0}, {3, 1}, {0, 0.5}}}).find("cross at"),
            std::string::npos);
  EXPECT_NE(messageOf({{{0, 0}, {4, 0}, {2, 3}}, {{2, -1}, {2, 0}, {3, 1}, {4, 0.5}}}).find("cross at"),
            std::string::npos);
}

TEST(Region, RingsMayTouchInPoints) {
  // A hole in a corner of its polygon, two polygons in a corner, a corner on a side.
  EXPECT_EQ(messageOf({square(0, 0, 4), {{0, 0}, {2, 1}, {1, 2}}}), "");
  EXPECT_EQ(messageOf({square(0, 0, 2), square(2, 2, 2)}), "");
  EXPECT_EQ(messageOf({square(0, 0, 2), {{1, 2}, {2, 4}, {0, 4}}}), "");
  EXPECT_EQ(messageOf({square(0, 0, 4), {{0, 2}, {2, 1}, {2, 3}}}), "");
  const Region region = test::regionFrom({square(0, 0, 4), {{0, 2}, {2, 1}, {2, 3}}});
  EXPECT_EQ(region.area(), 14);
  EXPECT_EQ(region.polygonCount(), 1U);
  // Holes that touch each other and the polygon cut its interior apart.
  EXPECT_EQ(messageOf({square(0, 0, 4), {{0, 2}, {2, 1}, {4, 2}, {2, 3}}}),
            "The rings of polygon 0 of the region touch so that they cut its interior apart.");
}

TEST(Region, RefusesWrongNesting) {
  EXPECT_EQ(messageOfPolygons({{square(0, 0, 4), square(5, 5, 1)}}),
            "Ring 1 of the region is a hole, but lies outside its polygon.");
  EXPECT_EQ(messageOfPolygons({{square(0, 0, 9), square(1, 1, 5), square(2, 2, 1)}}),
            "Ring 2 of the region is a hole inside another hole.");
  EXPECT_EQ(messageOfPolygons({{square(0, 0, 9)}, {square(1, 1, 1)}}),
            "Polygons 0 and 1 of the region overlap: one contains the other. Set `dissolve` to merge them.");
}

TEST(Region, RefusesInvalidInput) {
  const double kNaN = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(messageOf({}), "The region has no ring.");
  EXPECT_EQ(messageOfPolygons({{square(0, 0, 1)}, {}}), "Polygon 1 of the region has no ring.");
  EXPECT_EQ(messageOf({{{0, 0}, {1, 0}, {1, 0}, {0, 0}}}),
            "Ring 0 of the region has fewer than three different points.");
  EXPECT_EQ(messageOf({{{0, 0}, {1, kNaN}, {1, 0}}}), "Point 1 of ring 0 of the region is not finite.");
  const auto errorOf = [](const Ring& ring) { return Region::fromRings(std::vector<Ring>{ring}).error(); };
  const Error large = errorOf({{0, 0}, {1, 8e28}, {1, 0}});
  EXPECT_EQ(large.code, ErrorCode::coordinateTooLarge);
  EXPECT_EQ(large.message, "Point 1 of ring 0 of the region has a coordinate beyond 7.9e28 (2^96).");
  const Error small = errorOf({{0, 0}, {1e-18, 0}, {0, 1e-18}});
  EXPECT_EQ(small.code, ErrorCode::coordinateTooSmall);
  EXPECT_EQ(small.message,
            "The points of the region are too small: all numbers are below 1.4e-17 (2^-56). Multiply them by 1e18.");
  EXPECT_NE(messageOf({{{0, 0}, {1, 1}, {2, 2}}}), "");
}

TEST(Region, RefusesArraysThatDoNotFitTogether) {
  using Offsets = std::vector<std::int32_t>;
  const Ring points = square(0, 0, 1);
  EXPECT_TRUE(Region::fromArrays(points, Offsets{0, 4}, {}));
  EXPECT_TRUE(Region::fromArrays(points, Offsets{0, 4}, Offsets{0, 1}));
  for (const Offsets& rings : {Offsets{}, Offsets{1, 4}, Offsets{0, 3}, Offsets{0, 5}, Offsets{0, 3, 2, 4}}) {
    EXPECT_FALSE(Region::fromArrays(points, rings, {}));
  }
  for (const Offsets& polygons : {Offsets{0}, Offsets{1}, Offsets{0, 2}, Offsets{0, 1, 0, 1}}) {
    EXPECT_FALSE(Region::fromArrays(points, Offsets{0, 4}, polygons));
  }
  // Too many points are refused before any is read.
  const auto large = Region::fromArrays(std::span(points.data(), kMaxRegionSides + 1), {}, {});
  ASSERT_FALSE(large);
  EXPECT_EQ(large.error().code, ErrorCode::tooManyCircles);
}

TEST(Region, DecidesByExactSigns) {
  // A corner one rounding step before a side, on the side, and one step beyond it.
  const double above = std::nextafter(0.5, 1.0);
  const double below = std::nextafter(0.5, 0.0);
  const Ring triangle = {{0, 0}, {1, 1}, {0, 1}};
  EXPECT_EQ(messageOf({triangle, {{0.5, below}, {0.9, 0}, {0.95, 0.5}}}), "");
  EXPECT_EQ(messageOf({triangle, {{0.5, 0.5}, {0.9, 0}, {0.95, 0.5}}}), "");
  EXPECT_NE(messageOf({triangle, {{0.5, above}, {0.9, 0}, {0.95, 0.5}}}), "");
  const Region region = test::regionFrom({triangle});
  EXPECT_TRUE(region.contains({0.5, above}));
  EXPECT_TRUE(region.contains({0.5, 0.5}));
  EXPECT_FALSE(region.contains({0.5, below}));
}

TEST(Region, IsTheSameAtAnyScale) {
  const Ring triangle = {{0, 0}, {3, 1}, {1, 2}};
  for (const double scale : {1e-17, 1e-9, 1e9, 1e27}) {
    Ring scaled;
    for (const Point& p : triangle) scaled.push_back({p.x * scale, p.y * scale});
    const Region region = test::regionFrom({scaled});
    EXPECT_TRUE(region.contains({1.2 * scale, 1 * scale}));
    EXPECT_FALSE(region.contains({0.2 * scale, 1 * scale}));
    EXPECT_NEAR(region.area() / scale / scale, 2.5, scale < 1e-14 ? 1e-11 : 1e-14);
  }
}

/// A star of long thin spikes, with a spiral of strips beside it: long slanted sides near each other.
std::vector<Ring> slantedRings() {
  std::vector<Ring> rings(1);
  for (int k = 0; k < 400; ++k) {
    const double angle = 2 * std::numbers::pi * k / 400;
    const double radius = k % 2 == 0 ? 0.4 : 1;
    rings[0].push_back({9 + radius * std::cos(angle), radius * std::sin(angle)});
  }
  for (int k = 0; k < 100; ++k) {
    const double x = 10.5 + k / 50.0;
    rings.push_back({{x, -1}, {x + 0.008, -1}, {x + 1.008, 1}, {x + 1, 1}});
  }
  return rings;
}

TEST(Region, ContainsIsThatOfAllSides) {
  std::mt19937_64 random(test::seedOr(7));
  std::vector<Ring> rings = slantedRings();
  rings.push_back(test::coastRing(random, {0, 0}, 1, 3000));
  for (int k = 0; k < 20; ++k) rings.push_back(test::starRing(random, {2.0 + k % 5, k / 5 - 2.0}, 0.1, 0.4, 9));
  rings.push_back(test::combRing({-3, 3, 5, 6}, 40));
  rings.push_back(test::spiralRing({-9, -2, -4, 3}, 6));
  const Region region = Region::fromRings(rings).value();
  std::uniform_real_distribution<double> x(-9.5, 14);
  std::uniform_real_distribution<double> y(-3, 6.5);
  for (int k = 0; k < 30000; ++k) {
    const Point p = {x(random), y(random)};
    const auto isAround = [&](const Ring& ring) { return test::isInRing(ring, p); };
    ASSERT_EQ(region.contains(p), std::ranges::count_if(rings, isAround) % 2 == 1) << p.x << " " << p.y;
  }
}

TEST(Region, SidesNearATriangleIncludeAllThatMeetIt) {
  const Region region = Region::fromRings(slantedRings()).value();
  std::mt19937_64 random(test::seedOr(8));
  std::uniform_real_distribution<double> x(7.5, 14);
  std::uniform_real_distribution<double> y(-1.5, 1.5);
  std::uniform_real_distribution<double> share(0, 1);
  std::size_t found = 0;
  for (int k = 0; k < 2000; ++k) {
    const Point a = {x(random), y(random)};
    const double size = k % 2 == 0 ? 0.02 : 2;
    const auto beside = [&] { return Point{a.x + size * share(random), a.y + size * share(random)}; };
    const std::vector<Point> corners = {a, beside(), beside()};
    const auto sides = region.sidesNear(std::span(corners).first(1 + k % 3), 0);
    ASSERT_TRUE(std::is_sorted(sides.begin(), sides.end()));
    found += sides.size();
    // Sides at random places of the triangle, or of its side or corner.
    for (int tries = 0; tries < 20; ++tries) {
      double u = k % 3 > 0 ? share(random) : 0;
      double v = k % 3 > 1 ? share(random) * (1 - u) : 0;
      const Point p = {a.x + u * (corners[1].x - a.x) + v * (corners[2].x - a.x),
                       a.y + u * (corners[1].y - a.y) + v * (corners[2].y - a.y)};
      for (const RegionSideIndex side : region.sidesIn({p.x, p.y, p.x, p.y})) {
        const auto ring = static_cast<std::size_t>(region.ringOf(side));
        const std::int32_t next = side + 1 == region.ringOffsets()[ring + 1] ? region.ringOffsets()[ring] : side + 1;
        const Point from = region.points()[static_cast<std::size_t>(side)];
        const Point to = region.points()[static_cast<std::size_t>(next)];
        const double turn = (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
        const double distance = std::abs(turn) / std::hypot(to.x - from.x, to.y - from.y);
        const auto near = region.sidesNear(std::array{p}, distance * 1.001);
        ASSERT_TRUE(std::binary_search(near.begin(), near.end(), side));
        if (distance > 1e-3) continue;
        const auto wide = region.sidesNear(std::span(corners).first(1 + k % 3), 1.001e-3);
        ASSERT_TRUE(std::binary_search(wide.begin(), wide.end(), side)) << p.x << " " << p.y;
      }
    }
  }
  // Most sides whose boxes meet that of a triangle do not come near it.
  EXPECT_LT(found, 2000U * 40);
}

TEST(Region, RingsNotInBoxesAreAllOthers) {
  std::vector<Ring> rings;
  for (int k = 0; k < 200; ++k) rings.push_back(square(k % 20, k / 20, 0.5));
  const Region region = Region::fromRings(rings).value();
  const auto found = region.ringsNotIn([](const Box& box, RegionRingIndex) { return box.minX > 3 || box.maxY < 2; });
  std::vector<RegionRingIndex> expected;
  for (std::size_t ring = 0; ring < region.ringCount(); ++ring) {
    const Point p = region.points()[static_cast<std::size_t>(region.ringOffsets()[ring])];
    if (!(p.x > 3 || p.y < 2)) expected.push_back(static_cast<std::int32_t>(ring));
  }
  for (const RegionRingIndex ring : expected) EXPECT_TRUE(std::binary_search(found.begin(), found.end(), ring));
  EXPECT_LT(found.size(), region.ringCount() / 2);
}

}  // namespace
}  // namespace circle_voronoi
