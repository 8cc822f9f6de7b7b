// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons of cells in regions: against Boost.Geometry as an independent oracle, and as a coverage.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>
#include <map>
#include <random>
#include <tuple>

#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/compute.h"
#include "clip_families.h"
#include "in_circle.h"
#include "region_shapes.h"
#include "regions.h"
#include "report.h"
#include "rings.h"
#include "rounded.h"
#include "valid_polygons.h"

namespace circle_voronoi {
namespace {

namespace bg = boost::geometry;
using BoostPoint = bg::model::d2::point_xy<double>;
using BoostPolygon = bg::model::polygon<BoostPoint, false>;  // counter-clockwise
using BoostPolygons = bg::model::multi_polygon<BoostPolygon>;

std::vector<Circle> randomCircles(std::mt19937_64& random, int count, double largest) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Circle> circles;
  for (int i = 0; i < count; ++i) circles.push_back({unit(random), unit(random), largest * unit(random)});
  return circles;
}

BoostPolygons boostOf(const std::vector<std::vector<Region::Ring>>& polygons) {
  BoostPolygons result;
  for (const auto& rings : polygons) {
    BoostPolygon& polygon = result.emplace_back();
    for (const Region::Ring& ring : rings) {
      auto& target = &ring == &rings.front() ? polygon.outer() : polygon.inners().emplace_back();
      for (const Point& p : ring) target.emplace_back(p.x, p.y);
    }
    bg::correct(polygon);
  }
  return result;
}

/// A cell in a large box as a fine polygon.
BoostPolygon fineCell(const Diagram& diagram, CircleIndex circle, const Region& box, double tolerance) {
  BoostPolygon polygon;
  for (const auto& loop : outline(diagram, circle, box)) {
    for (const OutlinePiece& piece : loop) {
      const auto points = polyline(piece.curve, tolerance);
      for (std::size_t k = 0; k + 1 < points.size(); ++k) polygon.outer().emplace_back(points[k].x, points[k].y);
    }
  }
  bg::correct(polygon);
  return polygon;
}

TEST(ClippedPolygons, AreasAreThoseOfBoostGeometry) {
  std::mt19937_64 random(test::seedOr(3));
  const Region box = test::regionOf(Box{-3, -3, 4, 4});
  for (int trial = 0; trial < 3; ++trial) {
    const auto circles = randomCircles(random, 30, 0.1);
    const Diagram diagram = compute(circles, {.metric = trial == 1 ? Metric::power : Metric::circles}).value();
    const std::vector<std::vector<Region::Ring>> shapes = {
        {test::starRing(random, {0.5, 0.5}, 0.2, 0.8, 25), test::starRing(random, {0.5, 0.5}, 0.02, 0.15, 9)},
        {test::combRing({0.1, 0.05, 0.95, 0.9}, 7)},
        {test::coastRing(random, {0.5, 0.5}, 0.4, 80)},
        {test::spiralRing({0, 0, 1, 1}, 3)}};
    for (const auto& rings : shapes) {
      const Region region = Region::fromRings(rings).value();
      const ClippedDiagram clipped = ClippedDiagram::from(diagram, region).value();
      const std::vector<double> areas = clipped.areas();
      const BoostPolygons clip = boostOf(test::polygonsOf(region));
      for (std::size_t i = 0; i < circles.size(); ++i) {
        BoostPolygons parts;
        bg::intersection(fineCell(diagram, static_cast<std::int32_t>(i), box, 1e-8), clip, parts);
        EXPECT_NEAR(areas[i], bg::area(parts), 1e-7) << "cell " << i;
      }
    }
  }
}

/// Checks that polygons cover a region without gaps and overlaps: each of their sides is one of another polygon, the
/// other way round, or lies on the boundary of the region; and each polygon is valid.
void expectCoverage(const ClippedPolygons& polygons, const Region& region, double areaError) {
  std::map<std::tuple<double, double, double, double>, int> sides;
  double area = 0;
  for (std::size_t row = 0; row + 1 < polygons.polygonOffsets.size(); ++row) {
    const auto cell = test::polygonsOf(polygons, row);
    for (const Region::Ring& ring : cell | std::views::join) {
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const Point p = ring[k];
        const Point q = ring[(k + 1) % ring.size()];
        ++sides[{p.x, p.y, q.x, q.y}];
      }
    }
    const BoostPolygons shapes = boostOf(cell);
    area += bg::area(shapes);
    for (const BoostPolygon& polygon : shapes) {
      std::string reason;
      EXPECT_TRUE(bg::is_valid(polygon, reason)) << reason << " in cell " << row;
    }
  }
  const Box box = region.bounds();
  const double near =
      1e-14 * std::max({std::abs(box.minX), std::abs(box.maxX), std::abs(box.minY), std::abs(box.maxY)});
  const auto boundary = test::sidesOf(region);
  const auto isOnBoundary = [&](Point p) {
    return std::ranges::any_of(boundary, [&](const auto& side) { return test::distanceToSide(p, side) <= near; });
  };
  for (const auto& [side, count] : sides) {
    const auto& [x, y, u, v] = side;
    EXPECT_EQ(count, 1);
    const auto twin = sides.find({u, v, x, y});
    if (twin != sides.end()) continue;
    EXPECT_TRUE(isOnBoundary({(x + u) / 2, (y + v) / 2})) << x << " " << y << " to " << u << " " << v;
  }
  EXPECT_NEAR(area, region.area(), areaError);
}

TEST(ClippedPolygons, APartThatIsThinnerThanTheToleranceLeavesNoPoints) {
  // The right side of the region cuts off the tip of the first cell, which a chord along that side stands for.
  const std::vector<Circle> circles = {{4, 0, 0}, {0, 0, 2}};
  const Diagram diagram = compute(circles, {.metric = Metric::circles}).value();
  const Region region = test::regionFrom({{{-1, -2}, {3.1, -2}, {3.1, 2}, {-1, 2}}});
  const ClippedPolygons polygons = ClippedDiagram::from(diagram, region).value().polygons(1);
  EXPECT_EQ(polygons.polygonOffsets, (std::vector<std::int32_t>{0, 0, 1}));
  EXPECT_EQ(polygons.pointOffsets, (std::vector<std::int32_t>{0, 6}));
  EXPECT_EQ(polygons.points.size(), 6U);
}

TEST(ClippedPolygons, AHoleThatTouchesASideTwiceCutsOffWhatLiesBetween) {
  const PointRing outer = {{0, 0}, {6, 0}, {6, 6}, {0, 6}};
  const PointRing hole = {{2, 6}, {3, 4}, {4, 6}, {3, 2}};
  // Each side of the square once, as its points are sorted from left to right.
  for (int turn = 0; turn < 4; ++turn) {
    const auto turned = [turn](PointRing ring) {
      for (Point& p : ring) {
        for (int k = 0; k < turn; ++k) p = {6 - p.y, p.x};
      }
      return ring;
    };
    const auto polygons = validPolygons({{turned(outer)}, {turned(hole), true}});
    EXPECT_EQ(polygons.size(), 2U);
    const auto region = Region::fromPolygons(polygons);
    ASSERT_TRUE(region) << turn << ": " << region.error().message;
    EXPECT_EQ(region.value().area(), 34);
  }
}

TEST(ClippedPolygons, ALakeOfAnIslandIsAHoleOfTheIsland) {
  // The whole cell of the circle in the middle lies around a lake with an island, which has a lake itself.
  const Diagram diagram =
      compute(std::vector<Circle>{{0, 0, 0}, {20, 0, 0}, {-20, 0, 0}, {0, 20, 0}, {0, -20, 0}}).value();
  const auto square = [](double half) {
    return Region::Ring{{-half, -half}, {half, -half}, {half, half}, {-half, half}};
  };
  const Region region =
      Region::fromRings(std::vector<Region::Ring>{square(40), square(4), square(3), square(2)}).value();
  const ClippedDiagram clipped = ClippedDiagram::from(diagram, region).value();
  const auto isHole = clipped.cells().isHole;
  EXPECT_EQ(std::vector(isHole.begin(), isHole.begin() + 4), (std::vector<std::uint8_t>{0, 1, 0, 1}));
  expectCoverage(clipped.polygons(1e-3), region, 1e-9);
}

TEST(ClippedPolygons, HolesLieInThePolygonAroundThemWhereManyTouch) {
  // Squares that touch in corners, each with a smaller one inside, and in every third an island with a lake.
  std::vector<Region::Ring> rings;
  for (int k = 0; k < 30; ++k) {
    const auto add = [&](double half) {
      rings.push_back({{k - half, k - half}, {k + half, k - half}, {k + half, k + half}, {k - half, k + half}});
    };
    add(0.5);
    add(0.4);
    if (k % 3 == 0) add(0.3);
    if (k % 3 == 0) add(0.2);
  }
  const Region region = Region::fromRings(rings).value();
  const Diagram diagram = compute(std::vector<Circle>{{3, 1, 1}, {50, 20, 1}}, {.metric = Metric::circles}).value();
  expectCoverage(ClippedDiagram::from(diagram, region).value().polygons(1e-3), region, 1e-9);
}

TEST(ClippedPolygons, AreAValidCoverageAtAnyTolerance) {
  std::mt19937_64 random(test::seedOr(4));
  for (int trial = 0; trial < 12; ++trial) {
    const auto circles = randomCircles(random, 25, trial % 2 == 0 ? 0.1 : 0.4);
    const Diagram diagram = compute(circles, {.metric = Metric::circles}).value();
    const std::vector<std::vector<Region::Ring>> shapes = {
        {test::starRing(random, {0.5, 0.5}, 0.2, 0.8, 60)},
        {test::starRing(random, {0.5, 0.5}, 0.5, 0.8, 30), test::starRing(random, {0.5, 0.5}, 0.02, 0.4, 40)},
        {test::coastRing(random, {0.5, 0.5}, 0.4, 300)},
        {test::combRing({0.05, 0.05, 0.95, 0.9}, 30)}};
    for (std::size_t k = 0; k < shapes.size(); ++k) {
      const Region region = Region::fromRings(shapes[k]).value();
      const ClippedDiagram clipped = ClippedDiagram::from(diagram, region).value();
      for (const double tolerance : {1e-5, 1e-2, 10.0}) {
        SCOPED_TRACE("trial " + std::to_string(trial) + ", shape " + std::to_string(k) + ", tolerance " +
                     std::to_string(tolerance));
        expectCoverage(clipped.polygons(tolerance), region, 1e-12);
      }
    }
  }
}

TEST(ClippedPolygons, HaveRoundedCornersAlsoAtCirclesOfTheSmallestNumbers) {
  // The vertices of the smallest circles lie between the multiples of the step.
  std::mt19937_64 random(test::seedOr(5));
  const auto number = [&] {
    return std::ldexp(static_cast<double>(random() % 8), static_cast<int>(random() % 94) - 96);
  };
  const Region region = test::regionFrom({{{-1, -1}, {1, -1}, {1, 1}, {0, 0.5}, {-1, 1}}});
  for (int trial = 0; trial < 200; ++trial) {
    SCOPED_TRACE(trial);
    std::vector<Circle> circles = {{0, 0, 0}, {0.5, 0, number()}};
    for (int i = 0; i < 6; ++i) circles.push_back({number(), number(), number()});
    const Diagram diagram = compute(circles, {.metric = Metric::circles}).value();
    const ClippedPolygons polygons = ClippedDiagram::from(diagram, region).value().polygons(1e-3);
    for (const Point& p : polygons.points) ASSERT_EQ(p, rounded(p));
  }
}

TEST(ClippedPolygons, CornersBetweenAnArcAndItsChordCountWhateverPartOfTheBoundaryCameBefore) {
  const Diagram diagram = compute(std::vector<Circle>{{0, 0, 5}, {8, 0, 0.5}}, {.metric = Metric::circles}).value();
  // A corner in the second cell, after a stretch far from its border in the first one; and a hole after another hole.
  const std::vector<std::vector<Region::Ring>> shapes = {
      {{{6.26, 0}, {6.884, 20}, {-30, 20}, {-30, -20}, {6.884, -20}}},
      {{{-20, -4}, {20, -4}, {20, 4}, {-20, 4}},
       {{-10, -1}, {-9, -1}, {-9, 1}},
       {{6.6, -0.2}, {6.8, -0.2}, {6.8, 0.2}}}};
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    const Region region = Region::fromRings(shapes[k]).value();
    const ClippedDiagram clipped = ClippedDiagram::from(diagram, region).value();
    for (const double tolerance : {1e-4, k == 0 ? 0.1 : 1.3}) {
      SCOPED_TRACE("shape " + std::to_string(k) + ", tolerance " + std::to_string(tolerance));
      expectCoverage(clipped.polygons(tolerance), region, 1e-9);
    }
  }
}

}  // namespace
}  // namespace circle_voronoi
