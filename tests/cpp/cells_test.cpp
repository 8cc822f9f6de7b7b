// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "circle_voronoi/compute.h"
#include "circle_voronoi_families/families.h"
#include "diagrams.h"
#include "far_apart.h"
#include "fixtures.h"
#include "random.h"
#include "regions.h"
#include "vectors.h"

namespace circle_voronoi {
namespace {

using test::diagramOf;

/// A square around the middle of the circles; `share` 1: as wide as their bounding box is wide or high.
Box boxAround(const std::vector<Circle>& circles, double share) {
  const Box box = test::boundingBoxOf(circles);
  const double size = std::max(box.maxX - box.minX, box.maxY - box.minY);
  const double half = share * (size > 0 ? size : 1) / 2;
  const Point middle = {box.minX / 2 + box.maxX / 2, box.minY / 2 + box.maxY / 2};
  return {middle.x - half, middle.y - half, middle.x + half, middle.y + half};
}

std::int32_t nearest(const std::vector<Circle>& circles, Point p) {
  std::int32_t best = 0;
  for (std::size_t i = 1; i < circles.size(); ++i) {
    if (distance(Metric::circles, circles[i], p) <
        distance(Metric::circles, circles[static_cast<std::size_t>(best)], p))
      best = static_cast<std::int32_t>(i);
  }
  return best;
}

Point randomPoint(const Box& box, Random& random) {
  return {random.uniform(box.minX, box.maxX), random.uniform(box.minY, box.maxY)};
}

Region randomPolygon(const Box& box, Random& random) {
  std::vector<double> turns;
  for (std::size_t i = 3 + random.below(6); i > 0; --i) turns.push_back(random.unit());
  std::ranges::sort(turns);
  const Point middle = randomPoint(box, random);
  const double radius = (box.maxX - box.minX) * random.logUniform(-2, 0);
  std::vector<Point> corners;
  for (const double turn : turns) {
    const Vector direction = directionAt(turn);
    corners.push_back({middle.x + radius * direction.x, middle.y + radius * direction.y});
  }
  return test::regionOf(corners);
}

/// Loops are closed without gaps, and their areas add up to the region's. No area is negative except for rounding.
void expectPartition(const Diagram& diagram, const Region& region, double rounding = 1e-12) {
  double sum = 0;
  for (std::size_t i = 0; i < diagram.circles.size(); ++i) {
    const Outline parts = outline(diagram, static_cast<std::int32_t>(i), region);
    for (const auto& loop : parts) {
      ASSERT_FALSE(loop.empty());
      for (std::size_t k = 0; k < loop.size(); ++k) {
        ASSERT_EQ(loop[k].curve.end, loop[(k + 1) % loop.size()].curve.start) << "cell " << i << " piece " << k;
      }
    }
    const double part = area(parts);
    ASSERT_GE(part, -rounding * region.area()) << "cell " << i;
    sum += part;
  }
  EXPECT_NEAR(sum / region.area(), 1, std::max(rounding, 1e-9));
}

TEST(Cells, SidesTurnCounterClockwiseAndLinkUp) {
  for (const FamilyInfo& family : families()) {
    SCOPED_TRACE(family.name);
    const auto circles = generate(family.family, 200, 1);
    const Diagram diagram = diagramOf(circles);
    std::size_t count = 0;
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(circles.size()); ++i) {
      const auto range = diagram.sides(i);
      const std::vector<SideIndex> sides(range.begin(), range.end());
      count += sides.size();
      for (std::size_t k = 0; k < sides.size(); ++k) {
        ASSERT_EQ(diagram.circleOf(sides[k]), i);
        ASSERT_EQ(diagram.targetOf(sides[k]), diagram.originOf(sides[(k + 1) % sides.size()]));
      }
      const auto around = neighbors(diagram, i);
      for (const CircleIndex j : around) {
        ASSERT_EQ(std::ranges::count(neighbors(diagram, j), i), std::ranges::count(around, j));
      }
    }
    EXPECT_EQ(count, 2 * diagram.edges.size());
    for (const HiddenCircle& hidden : diagram.hidden) {
      EXPECT_FALSE(diagram.hasCell(hidden.circle));
      EXPECT_TRUE(outline(diagram, hidden.circle, test::regionOf(boxAround(circles, 1.1))).empty());
    }
  }
}

TEST(Cells, ContainTheNearestPoints) {
  Random random(2);
  for (const FamilyInfo& family : families()) {
    if (test::isTooWideToDraw(family.family)) continue;
    SCOPED_TRACE(family.name);
    const auto circles = generate(family.family, 60, 2);
    const Diagram diagram = diagramOf(circles);
    const Box box = boxAround(circles, 1.2);
    for (int k = 0; k < 200; ++k) {
      const Point p = randomPoint(box, random);
      const double least = distance(Metric::circles, circles[static_cast<std::size_t>(nearest(circles, p))], p);
      for (std::int32_t i = 0; i < static_cast<std::int32_t>(circles.size()); ++i) {
        const double own = distanceFrom(diagram, i, p);
        EXPECT_EQ(contains(diagram, i, p), diagram.hasCell(i) && own == least) << i;
      }
    }
  }
}

TEST(Cells, AreasAddUpToTheRegion) {
  Random random(3);
  for (const FamilyInfo& family : families()) {
    if (test::isTooWideToDraw(family.family)) continue;
    for (const std::size_t count : {1U, 2U, 3U, 5U, 20U, 100U, 300U}) {
      SCOPED_TRACE(std::string(family.name) + " " + std::to_string(count));
      const auto circles = generate(family.family, count, count);
      const Diagram diagram = diagramOf(circles);
      // Cells between circles that touch inside but for rounding are narrower than the rounding of their vertices.
      const double rounding = family.family == Family::nestedTangent ? 1e-8 : 1e-12;
      expectPartition(diagram, test::regionOf(boxAround(circles, 1.5)), rounding);
      expectPartition(diagram, test::regionOf(boxAround(circles, 1)), rounding);
      expectPartition(diagram, test::regionOf(boxAround(circles, 1000)), rounding);
      expectPartition(diagram, test::regionOf(boxAround(circles, 0.3)), rounding);
      expectPartition(diagram, randomPolygon(boxAround(circles, 1), random), rounding);
    }
  }
}

TEST(Cells, AreaCentroidAndPerimeterAreThoseOfAFinePolygon) {
  Random random(5);
  for (const Family family : {Family::logUniform, Family::twoHuge, Family::intersecting, Family::chaos}) {
    const auto circles = generate(family, 10, 5);
    const Diagram diagram = diagramOf(circles);
    const Region region = test::regionOf(boxAround(circles, 1.3));
    const double size = std::sqrt(region.area());
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(circles.size()); ++i) {
      const Outline parts = outline(diagram, i, region);
      if (parts.empty()) continue;
      const Box box = region.bounds();
      const Point origin = {(box.minX + box.maxX) / 2, (box.minY + box.maxY) / 2};
      double twice = 0, x = 0, y = 0, around = 0;
      for (const auto& loop : parts) {
        for (const auto& piece : loop) {
          const auto points = polyline(piece.curve, 0);
          for (std::size_t k = 1; k < points.size(); ++k) {
            const Vector u = {points[k - 1].x - origin.x, points[k - 1].y - origin.y};
            const Vector v = {points[k].x - origin.x, points[k].y - origin.y};
            twice += cross(u, v);
            x += cross(u, v) * (u.x + v.x) / 3;
            y += cross(u, v) * (u.y + v.y) / 3;
            around += length({v.x - u.x, v.y - u.y});
          }
        }
      }
      EXPECT_NEAR(area(parts), twice / 2, 1e-7 * region.area());
      EXPECT_NEAR(perimeter(parts), around, 1e-6 * around);
      if (area(parts) < 1e-3 * region.area()) continue;
      EXPECT_NEAR(centroid(parts).x, origin.x + x / twice, 1e-4 * size);
      EXPECT_NEAR(centroid(parts).y, origin.y + y / twice, 1e-4 * size);
    }
  }
}

TEST(Cells, OneCircleHasTheWholeBox) {
  const std::vector<Circle> circles = {{0, 0, 1}, {0.1, 0, 0.5}};
  const Diagram diagram = diagramOf(circles);
  const Box box = {2, 3, 5, 4};
  EXPECT_TRUE(diagram.sides(0).empty());
  EXPECT_EQ(area(outline(diagram, 0, test::regionOf(box))), 3);
  EXPECT_EQ(perimeter(outline(diagram, 0, test::regionOf(box))), 8);
  EXPECT_EQ(centroid(outline(diagram, 0, test::regionOf(box))), (Point{3.5, 3.5}));
  EXPECT_TRUE(outline(diagram, 1, test::regionOf(box)).empty());
}

TEST(Cells, ARegionMayCutACellApart) {
  // A tall cell between two large circles, seen through a window that misses its middle: a small circle in the way.
  const std::vector<Circle> circles = {{0, 0, 10}, {0, 10.6, 0.1}};
  const Diagram diagram = diagramOf(circles);
  // The branch bends around the small circle; a box below its apex sees the large circle's cell on both sides of it.
  const Box box = {-8, 10.3, 8, 14};
  EXPECT_EQ(outline(diagram, 1, test::regionOf(box)).size(), 1U);
  const Outline parts = outline(diagram, 0, test::regionOf(Box{-8, 10.5, 8, 14}));
  EXPECT_EQ(parts.size(), 2U);
  EXPECT_NEAR(area(parts) + area(outline(diagram, 1, test::regionOf(Box{-8, 10.5, 8, 14}))), 16 * 3.5, 1e-12);
}

TEST(Cells, FillBoxesThatMeetTheirEdgesInTies) {
  struct Case {
    const char* what;
    std::vector<Circle> circles;
    std::vector<Box> boxes;
  };
  const std::vector<Case> cases = {
      {"sides along edges, and corners at a vertex",
       {{0, 0, 0.5}, {2, 0, 0.5}, {0, 2, 0.5}, {2, 2, 0.5}},
       {{0, 0, 1, 1}, {0, 0, 1, 2}, {-1, -1, 1, 3}, {1, 1, 2, 2}, {0, 0, 2, 2}}},
      {"two sides on the boundary of a cell", {{25, 0, 1}, {27, 0, 1}, {21, 0, 1}}, {{23, -1, 26, 1}}},
      {"a side that touches an edge in its apex",
       {{1, 3, 0}, {1, 0, 1}},
       {{1, 0, 3, 2}, {0, 0, 2, 2}, {0, 2, 2, 3}, {-1, 1, 1, 2}}},
      {"all edges in one corner, as seen from the box",
       {{9, 0, 0}, {0, 0, 0}, {-0x1.2cp-60, -0x1.2cp-60, 0}, {-0x1.2cp-89, 0x1.4p-92, 0}},
       {{-2.9e28, -2.2e28, 0, 0}}},
      // By rounding, the edge crosses the side many times, and there the lead over the circle far away is huge.
      {"a side on the edge to a circle far away",
       {{0x1.64p+94, 0, 0x1.4p+30}, {-0x1.28p+25, -0x1p+28, 8}, {0, 0, 8}},
       {{-0x1.ab4p+93, -0x1.ab4p+93, 0x1.64p+93, 0x1.64p+93}}},
      {"an edge so long that its vertex hides the side of the axis",
       {{-0x1.8p+95, 0x1.2p+60, 0},
        {2, 0x1.8p-92, 0},
        {0x1.d8p-26, -0x1.fcp+75, 0x1.fcp+75},
        {2, 0x1.8p-36, 0},
        {0x1p+61, 0x1.8p-32, 0x1p-40}},
       {{-0x1.a668p+99, -0x1.a666p+99, 0x1.a664p+99, 0x1.a667p+99}}}};
  for (const auto& [what, circles, boxes] : cases) {
    SCOPED_TRACE(what);
    const Diagram diagram = diagramOf(circles);
    for (const Box& box : boxes) expectPartition(diagram, test::regionOf(box));
  }
}

/// The distance from the center of circle i at which its cell ends in a direction: where another circle becomes as
/// near, for one at d from the center and with a radius larger by s at (d^2 - s^2) / (2 (d u + s)), or at the box.
double reach(const std::vector<Circle>& circles, std::size_t i, Vector u, const Box& box) {
  const Circle& c = circles[i];
  double end = u.x > 0 ? (box.maxX - c.x) / u.x : (box.minX - c.x) / u.x;
  end = std::min(end, u.y > 0 ? (box.maxY - c.y) / u.y : (box.minY - c.y) / u.y);
  for (std::size_t j = 0; j < circles.size(); ++j) {
    const Vector d = {circles[j].x - c.x, circles[j].y - c.y};
    const double s = circles[j].r - c.r;
    const double forward = d.x * u.x + d.y * u.y + s;
    if (j != i && forward > 0) end = std::min(end, (d.x * d.x + d.y * d.y - s * s) / (2 * forward));
  }
  return end;
}

TEST(Cells, OfTheBronzeFilterHaveTheAreasOfAQuadratureOverAllCircles) {
  const auto circles = test::readFixture("bronzefilter");
  const Diagram diagram = diagramOf(circles);
  const Box box = boxAround(circles, 1.02);
  expectPartition(diagram, test::regionOf(box));
  constexpr int kRays = 2000;
  constexpr double kFullTurn = 2 * std::numbers::pi;
  for (std::size_t i = 0; i < circles.size(); ++i) {
    double sum = 0;
    for (int k = 0; k < kRays; ++k) {
      const double end = reach(circles, i, directionAt((k + 0.5) / kRays), box);
      sum += end * end / 2;
    }
    const double expected = sum * kFullTurn / kRays;
    EXPECT_NEAR(area(outline(diagram, static_cast<std::int32_t>(i), test::regionOf(box))), expected, 1e-3 * expected)
        << i;
  }
}

TEST(Cells, APointOnTheBorderIsInBoth) {
  const std::vector<Circle> circles = {{0, 0, 3}, {10, 0, 1}};
  const Diagram diagram = compute(circles).value();
  EXPECT_TRUE(contains(diagram, 0, {6, 0}));
  EXPECT_TRUE(contains(diagram, 1, {6, 0}));
  EXPECT_FALSE(contains(diagram, 0, {6.001, 0}));
  EXPECT_FALSE(contains(diagram, 1, {5.999, 0}));
}

TEST(Cells, ContainNothingThatIsNotANumber) {
  const Diagram diagram = compute(std::vector<Circle>{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}}).value();
  for (std::int32_t i = 0; i < 3; ++i) EXPECT_FALSE(contains(diagram, i, {std::nan(""), 0})) << i;
}

TEST(Cells, DoNotContainWhatIsNearerToOneBeyondATiedNeighbor) {
  // Far above, the first circle and the last, whose cell is a needle between others, are equally near up to rounding.
  // The second circle is much nearer.
  const std::vector<Circle> circles = {
      {2, -0x1p94, 0x1p94}, {0, 0x1.ap95, 1}, {0, 0x1.8p58, 0}, {-128, 0, 0}, {-0x1.fcp82, 0, 0x1.8p-63}};
  const Diagram diagram = compute(circles).value();
  const Point p = {-0x1p92, 0x1.24p122};
  for (std::int32_t i = 0; i < 5; ++i) EXPECT_EQ(contains(diagram, i, p), i == 1) << i;
}

TEST(Cells, TheirOutlinesHaveNoSegmentWithoutLength) {
  // The edge between the circles goes through two corners of the box. A cell has its corner on a side of the box.
  const std::vector<std::tuple<std::vector<Circle>, Box, double>> cases = {
      {{{-1, 1, 0.5}, {1, -1, 0.5}}, {0, 0, 4, 4}, 8}, {{{0, 4, 0}, {4, 4, 0}, {4, -1, 0}}, {2, 0, 8, 2}, 3}};
  for (const auto& [circles, box, size] : cases) {
    const Outline shape = outline(diagramOf(circles), 1, test::regionOf(box));
    ASSERT_EQ(shape.size(), 1U);
    for (const OutlinePiece& piece : shape[0]) EXPECT_TRUE(piece.side != kNone || piece.curve.start != piece.curve.end);
    EXPECT_DOUBLE_EQ(area(shape), size);
  }
}

TEST(Cells, MeasuresOfWholeCellsAreInfiniteWhereTheCellIsUnbounded) {
  // The cell of the first circle is a square.
  const std::vector<Circle> circles = {{0, 0, 1}, {4, 0, 1}, {0, 4, 1}, {-4, 0, 1}, {0, -4, 1}, {0.25, 0, 0.5}};
  const Diagram diagram = diagramOf(circles);
  EXPECT_DOUBLE_EQ(cellArea(diagram, 0), 16);
  EXPECT_DOUBLE_EQ(cellPerimeter(diagram, 0), 16);
  EXPECT_NEAR(cellCentroid(diagram, 0).x, 0, 1e-15);
  EXPECT_NEAR(cellCentroid(diagram, 0).y, 0, 1e-15);
  for (CircleIndex i = 1; i < 5; ++i) {
    EXPECT_EQ(cellArea(diagram, i), std::numeric_limits<double>::infinity());
    EXPECT_EQ(cellPerimeter(diagram, i), std::numeric_limits<double>::infinity());
    EXPECT_TRUE(std::isnan(cellCentroid(diagram, i).x));
  }
  EXPECT_EQ(cellArea(diagram, 5), 0) << "hidden";
  EXPECT_EQ(cellPerimeter(diagram, 5), 0);
  EXPECT_TRUE(std::isnan(cellCentroid(diagram, 5).y));
  const std::vector<Circle> one = {{1, 2, 3}};
  EXPECT_EQ(cellArea(diagramOf(one), 0), std::numeric_limits<double>::infinity()) << "the plane";
}

TEST(Cells, TheCentroidOfANeedleIsInItsBox) {
  // Its two curves are far longer than their ends are apart.
  const std::vector<Circle> circles = {{2, -0x1p+94, 0x1p+94}, {-66, -0x1p-90, 0x1.4p-88}, {-0x1.48p+81, 38, 4}};
  const Diagram diagram = diagramOf(circles);
  const Point middle = centroid(outline(diagram, 1, test::regionOf(Box{-1e30, -3e29, 1e30, 1e30})));
  EXPECT_LT(std::abs(middle.x), 1e30);
  EXPECT_GE(middle.y, 0);
  EXPECT_LE(middle.y, 1e30);
}

TEST(Cells, ACellThatTouchesTheBoxInItsVertexAloneIsEmpty) {
  const std::vector<Circle> circles = {{0, 0, 0}, {0, 0x1p-10, 1}, {-0x1.18p-74, -0x1.18p+95, 58}, {15, 0x1.ep-1, 7}};
  const Diagram diagram = diagramOf(circles);
  const Box box = {-0x1.5p+94, -0x1.cp+95, 0x1.18p+94, -0x1.18p+94};
  EXPECT_TRUE(outline(diagram, 1, test::regionOf(box)).empty());
}

TEST(Cells, TheCentroidOfAnOutlineWithoutAreaIsThatOfItsPoints) {
  const Point p{1, 2};
  const Point q{1 + 1.0 / 3, 2 + 1.0 / 7};
  const Point r{1 + 2.0 / 3, 2 + 2.0 / 7};
  // There and back by way of q: but for rounding there is no area.
  const Outline line = {{{segment(p, q)}, {segment(q, r)}, {segment(r, q)}, {segment(q, p)}}};
  EXPECT_NEAR(centroid(line).x, q.x, 1e-15);
  EXPECT_NEAR(centroid(line).y, q.y, 1e-15);
  const Outline thin = {{{segment(p, q)}, {segment(q, r)}, {segment(r, p)}}};
  EXPECT_NEAR(centroid(thin).x, q.x, 1e-15);
  EXPECT_NEAR(centroid(thin).y, q.y, 1e-15);
  // As thin as rounding makes them, either way round.
  Random random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const double slope = random.uniform(-1, 1);
    const auto on = [&](double x) { return Point{x, slope * x}; };
    const double x = random.uniform(0, 1);
    const double far = random.uniform(1, 2);
    const double back = random.uniform(0, 1);
    // Roundings of two triangles, which may cancel in the area but not in the moments.
    const Outline sliver = {
        {{segment(on(0), on(x))}, {segment(on(x), on(far))}, {segment(on(far), on(back))}, {segment(on(back), on(0))}}};
    EXPECT_NEAR(centroid(sliver).x, (x + far + back) / 4, 1e-12) << slope << ", " << x << ", " << far << ", " << back;
    EXPECT_NEAR(centroid(sliver).y, slope * (x + far + back) / 4, 1e-12)
        << slope << ", " << x << ", " << far << ", " << back;
  }
}

}  // namespace
}  // namespace circle_voronoi
