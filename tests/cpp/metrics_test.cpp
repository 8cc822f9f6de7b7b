// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "circle_voronoi/cells.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/finder.h"
#include "circle_voronoi_families/families.h"
#include "far_apart.h"
#include "random.h"
#include "regions.h"
#include "rounded.h"

namespace circle_voronoi {
namespace {

class Metrics : public testing::TestWithParam<Metric> {};

TEST_P(Metrics, CellsContainTheNearestPointsAndFillTheBox) {
  Random random(1);
  for (const FamilyInfo& family : families()) {
    if (test::isTooWideToDraw(family.family)) continue;
    for (const std::size_t count : {1U, 2U, 3U, 10U, 100U}) {
      SCOPED_TRACE(std::string(family.name) + " " + std::to_string(count));
      const auto circles = generate(family.family, count, count);
      const auto computed = compute(circles, {.metric = GetParam()});
      ASSERT_TRUE(computed) << computed.error().message;
      const Diagram& diagram = computed.value();
      const Finder finder(diagram);
      const Box box = test::validBoxOf(circles);
      for (int k = 0; k < 100; ++k) {
        const Point p = {random.uniform(box.minX, box.maxX), random.uniform(box.minY, box.maxY)};
        double least = std::numeric_limits<double>::infinity();
        double largest = 0;
        for (const Circle& c : circles) {
          least = std::min(least, distance(GetParam(), c, p));
          largest = std::max({largest, std::abs(p.x), std::abs(p.y), c.r});
        }
        const double rounding = 1e-14 * largest * (GetParam() == Metric::power ? largest : 1);
        ASSERT_LE(distanceFrom(diagram, finder.find(p), p), least + rounding);
      }
      double sum = 0;
      for (std::size_t i = 0; i < count; ++i)
        sum += area(outline(diagram, static_cast<std::int32_t>(i), test::regionOf(box)));
      EXPECT_NEAR(sum / ((box.maxX - box.minX) * (box.maxY - box.minY)), 1, 1e-9);
    }
  }
}

TEST_P(Metrics, EdgesAreStraightAndAtEqualDistances) {
  if (GetParam() == Metric::circles) return;
  const auto circles = generate(Family::uniform, 200, 5);
  const Diagram diagram = compute(circles, {.metric = GetParam()}).value();
  for (std::size_t e = 0; e < diagram.edges.size(); ++e) {
    const EdgeCurve curve = edgeCurve(diagram, static_cast<std::int32_t>(e));
    EXPECT_TRUE(curve.isStraight());
    const auto at = [&](std::int32_t i, double s) {
      return distance(GetParam(), circles[static_cast<std::size_t>(i)], pointAt(curve.bisector, s));
    };
    for (const double s : {0.5, 1.0, 4.0}) {
      EXPECT_NEAR(at(diagram.edges[e].left, s), at(diagram.edges[e].right, s), 1e-9);
    }
  }
}

TEST_P(Metrics, OfEqualCirclesIsTheirDiagram) {
  auto circles = generate(Family::uniform, 300, 6);
  for (Circle& c : circles) c.r = 0.5;
  const Diagram expected = compute(circles).value();
  const Diagram actual = compute(circles, {.metric = GetParam()}).value();
  const auto sorted = [](std::vector<std::array<CircleIndex, 3>> triples) {
    for (auto& triple : triples) std::ranges::rotate(triple, std::ranges::min_element(triple));
    std::ranges::sort(triples);
    return triples;
  };
  EXPECT_EQ(sorted(actual.vertexCircles), sorted(expected.vertexCircles));
  EXPECT_EQ(actual.hull, expected.hull);
}

TEST_P(Metrics, RejectsWhatComputeRejects) {
  const std::vector<Circle> circles = {{0, 0, 1}, {1, 0, -1}};
  const auto result = compute(circles, {.metric = GetParam()});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::negativeRadius);
  EXPECT_TRUE(compute({}, {.metric = GetParam()}));
}

std::string nameOfMetricTest(const testing::TestParamInfo<Metric>& metric) {
  constexpr const char* kNames[] = {"circles", "centers", "power"};
  return kNames[static_cast<int>(metric.param)];
}

INSTANTIATE_TEST_SUITE_P(Metrics, Metrics, testing::Values(Metric::circles, Metric::centers, Metric::power),
                         nameOfMetricTest);

TEST(PowerDiagram, TheRadiusOfAVertexIsThatOfTheCircleAtRightAngles) {
  const std::vector<Circle> circles = {{0, 0, 1}, {8, 0, 1}, {0, 8, 1}};
  const Diagram diagram = compute(circles, {.metric = Metric::power}).value();
  ASSERT_EQ(diagram.vertices.size(), 1U);
  EXPECT_EQ(diagram.vertices[0].x, 4);
  EXPECT_EQ(diagram.vertices[0].y, 4);
  EXPECT_DOUBLE_EQ(diagram.vertices[0].r, std::sqrt(31));
}

TEST(PowerDiagram, ACircleMayHaveNoCellThoughNoneContainsIt) {
  const std::vector<Circle> circles = {{0, 0, 3}, {4, 0, 3}, {2, 3, 1}, {2, 0.3, 1.9}};
  EXPECT_TRUE(compute(circles).value().hidden.empty());
  const Diagram power = compute(circles, {.metric = Metric::power}).value();
  ASSERT_EQ(power.hidden.size(), 1U);
  EXPECT_EQ(power.hidden[0].circle, 3);
  // A corner of the triangle around its center.
  EXPECT_TRUE(power.hasCell(power.hidden[0].by));
}

TEST(PowerDiagram, CirclesInAColumnFollowOneAnother) {
  for (const bool isColumn : {false, true}) {
    std::vector<Circle> circles;
    for (int k = 0; k < 40; ++k) {
      const double place = 7 * k % 40;
      circles.push_back(isColumn ? Circle{7, place, 1} : Circle{place, 7, 1});
    }
    const Diagram diagram = compute(circles, {.metric = Metric::power}).value();
    const auto placeOf = [&](CircleIndex i) {
      const Circle& c = circles[static_cast<std::size_t>(i)];
      return isColumn ? c.y : c.x;
    };
    ASSERT_EQ(diagram.edges.size(), 39U);
    for (const Edge& edge : diagram.edges) {
      EXPECT_EQ(std::abs(placeOf(edge.left) - placeOf(edge.right)), 1) << isColumn;
    }
  }
}

// The same bits wherever the heap puts things.
TEST(PowerDiagram, DoesNotDependOnAddresses) {
  const auto circles = generate(Family::grid, 36, 1);
  const Diagram expected = compute(circles, {.metric = Metric::power}).value();
  Random random(1);
  std::vector<std::unique_ptr<char[]>> holes(500);
  for (int trial = 0; trial < 30; ++trial) {
    for (auto& hole : holes) {
      hole = random.below(2) == 0 ? nullptr : std::make_unique<char[]>(1 + random.below(8000));
    }
    const Diagram diagram = compute(circles, {.metric = Metric::power}).value();
    ASSERT_TRUE(diagram.edges == expected.edges);
    ASSERT_TRUE(diagram.vertices == expected.vertices);
    ASSERT_EQ(diagram.hull, expected.hull);
  }
}

TEST(PowerDiagram, VerticesOfCentersNextToEachOtherAreRight) {
  const double ulp = 0x1p-52;
  const std::vector<std::vector<Circle>> inputs = {{{1, 1, 0}, {1 + ulp, 1, 0}, {3, 1 + 2 * ulp, 0}},
                                                   {{1, 1, 0.5}, {1, 1 + ulp, 0.5}, {2, 5, 1}, {-3, 2, 0.25}},
                                                   {{1, 1, 0}, {1 + ulp, 1 + ulp, 0}, {2, 2 + 2 * ulp, 0}, {5, 0, 1}},
                                                   {{0, 0, 0}, {1, 1, 0}, {2, 2 + 2 * ulp, 0}},
                                                   {{1e10, 1, 0}, {1e10 + 0x1p-19, 1, 0}, {0, 0, 0}, {0, 1e10, 0}}};
  for (const auto& circles : inputs) {
    const auto diagram = compute(circles, {.metric = Metric::power});
    ASSERT_TRUE(diagram) << diagram.error().message;
    ASSERT_FALSE(diagram.value().vertices.empty());
    for (std::size_t v = 0; v < diagram.value().vertices.size(); ++v) {
      const auto& [x, y, radius] = diagram.value().vertices[v];
      // The differences of equal powers are linear in the vertex: exact in long double but for a few bits.
      const auto circleAt = [&](std::size_t k) {
        return circles[static_cast<std::size_t>(diagram.value().vertexCircles[v][k])];
      };
      for (const std::size_t k : {1U, 2U}) {
        const auto [ax, ay, ar] = circleAt(0);
        const auto [bx, by, br] = circleAt(k);
        const long double dx = static_cast<long double>(bx) - ax;
        const long double dy = static_cast<long double>(by) - ay;
        const long double difference = 2 * (dx * (x - ax) + dy * (y - ay)) - dx * dx - dy * dy +
                                       static_cast<long double>(br) * br - static_cast<long double>(ar) * ar;
        const long double scale = std::abs(dx * x) + std::abs(dy * y) + std::abs(dx * ax) + std::abs(dy * ay);
        EXPECT_LE(std::abs(difference), 4 * 0x1p-53 * scale + 0x1p-53 * (ar * ar + br * br)) << v;
      }
      EXPECT_NEAR(radius * std::abs(radius) / distance(Metric::power, circleAt(0), {x, y}), 1, 1e-6);
    }
  }
}

// Centers as near to one another, and vertices as far off, as there are numbers.
TEST(PowerDiagram, EveryVertexInRangeIsRight) {
  // Digits enough for sums of squares of radii and distances.
  using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<600>, boost::multiprecision::et_off>;
  Random random(1);
  int given = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const int size = static_cast<int>(random.below(130)) - 34;
    const auto exponent = [&] { return size - static_cast<int>(random.below(random.below(2) == 0 ? 10 : 140)); };
    // Squares of radii are exact.
    const auto radius = [&] {
      return rounded(std::ldexp(static_cast<double>(random.below(1 << 20)), exponent() - 20));
    };
    const auto place = [&] { return rounded(std::ldexp(random.uniform(-1, 1), exponent())); };
    std::vector<Circle> circles = {{0, 0, radius()}, {place(), place(), radius()}, {place(), place(), radius()}};
    if (random.below(2) == 0) circles[2].r = circles[1].r = circles[0].r;
    SCOPED_TRACE(testing::Message() << "trial " << trial << std::hexfloat << " " << circles[0].r << " " << circles[1].x
                                    << " " << circles[1].y << " " << circles[1].r << " " << circles[2].x << " "
                                    << circles[2].y << " " << circles[2].r);
    const Real r = circles[0].r;
    const auto half = [&](const Circle& c) -> Real {
      return (Real(c.x) * c.x + Real(c.y) * c.y + r * r - Real(c.r) * c.r) / 2;
    };
    const auto& [u, v] = std::pair(circles[1], circles[2]);
    const Real determinant = Real(u.x) * v.y - Real(u.y) * v.x;
    if (determinant == 0) continue;
    const Real x = (half(u) * v.y - half(v) * u.y) / determinant;
    const Real y = (half(v) * u.x - half(u) * v.x) / determinant;
    const Real square = x * x + y * y;
    const auto diagram = compute(circles, {.metric = Metric::power});
    if (!diagram) {
      EXPECT_EQ(diagram.error().code, ErrorCode::coordinateTooSmall);
    } else if (!diagram.value().vertices.empty()) {
      ++given;
      const Vertex& vertex = diagram.value().vertices[0];
      const Real error = 0x1p-36 * sqrt(square) + std::numeric_limits<double>::min();
      EXPECT_LE(abs(Real(vertex.x) - x), error);
      EXPECT_LE(abs(Real(vertex.y) - y), error);
      const Real power = Real(vertex.r) * std::abs(vertex.r);
      EXPECT_LE(abs(power - (square - r * r)), 0x1p-36 * (square + r * r) + Real("1e-600"));
    }
    if (testing::Test::HasFailure()) FAIL();
  }
  EXPECT_GT(given, 200);
}

TEST(PowerDiagram, TheFarthestVertexIsFinite) {
  const double step = kCoordinateStep;
  const double limit = kCoordinateLimit;
  const std::vector<std::vector<Circle>> inputs = {{{0, 0, limit}, {step, 0, 0}, {0, step, limit / 2}},
                                                   {{0, 0, 0}, {limit, 0, 0}, {-limit, step, 0}},
                                                   {{0, 0, limit}, {limit, 0, 0}, {-limit, step, limit / 4}}};
  for (const auto& circles : inputs) {
    const Diagram diagram = compute(circles, {.metric = Metric::power}).value();
    for (const Vertex& vertex : diagram.vertices) {
      EXPECT_TRUE(std::isfinite(vertex.x) && std::isfinite(vertex.y) && std::isfinite(vertex.r));
    }
  }
}

}  // namespace
}  // namespace circle_voronoi
