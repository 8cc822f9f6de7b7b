// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/finder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "circle_voronoi/cells.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi_families/families.h"
#include "far_apart.h"
#include "random.h"

namespace circle_voronoi {
namespace {

std::vector<Point> pointsAround(const std::vector<Circle>& circles, std::size_t count, Random& random) {
  std::vector<Point> points;
  while (points.size() < count) {
    const Circle& c = circles[random.below(circles.size())];
    const Vector direction = random.direction();
    const double d = (c.r > 0 ? c.r : 1) * random.logUniform(-2, 3);
    points.push_back({c.x + d * direction.x, c.y + d * direction.y});
  }
  return points;
}

TEST(Finder, FindsANearestCircle) {
  Random random(1);
  for (const FamilyInfo& family : families()) {
    if (test::isTooWideToDraw(family.family)) continue;
    for (const std::size_t count : {1U, 2U, 3U, 10U, 100U, 1000U}) {
      SCOPED_TRACE(std::string(family.name) + " " + std::to_string(count));
      const auto circles = generate(family.family, count, count);
      const auto computed = compute(circles);
      ASSERT_TRUE(computed);
      const Diagram& diagram = computed.value();
      const Finder finder(diagram);
      const auto points = pointsAround(circles, 300, random);
      const auto found = finder.findAll(points);
      for (std::size_t k = 0; k < points.size(); ++k) {
        const Point p = points[k];
        double least = distance(Metric::circles, circles[0], p);
        for (const Circle& c : circles) least = std::min(least, distance(Metric::circles, c, p));
        const double rounding = 1e-14 * (std::abs(p.x) + std::abs(p.y) + std::abs(least));
        ASSERT_LE(distanceFrom(diagram, found[k], p), least + rounding) << "point " << k;
        const auto hint = static_cast<std::int32_t>(random.below(circles.size()));
        ASSERT_LE(distanceFrom(diagram, finder.find(p, hint), p), least + rounding)
            << "point " << k << " from " << hint;
      }
    }
  }
}

// Only circles within a few ranks of the queried places keep their sides, and a walk needs sides to go on. The test
// thus shows that the walks are short.
TEST(Finder, TakesFewStepsAmongManyCirclesOnALine) {
  constexpr std::int32_t kCount = 100'000;
  constexpr std::int32_t kPeriod = 100;
  constexpr std::int32_t kFew = 4;
  for (const bool isColumn : {false, true}) {
    std::vector<Circle> circles;
    for (std::int32_t i = 0; i < kCount; ++i) {
      const double place = i;
      circles.push_back(isColumn ? Circle{7, place, 0.25} : Circle{place, 7, 0.25});
    }
    Diagram diagram = compute(circles).value();
    const Finder finder(diagram);
    for (std::int32_t i = 0; i < kCount; ++i) {
      if (std::abs(i % kPeriod - kPeriod / 2) > kFew) diagram.links.firstSide[static_cast<std::size_t>(i)] = kNone;
    }
    for (std::int32_t i = kPeriod / 2; i < kCount; i += kPeriod) {
      ASSERT_EQ(finder.find(isColumn ? Point{7.5, i + 0.25} : Point{i + 0.25, 7.5}), i);
    }
  }
}

// It looks at the diagram, which is not to go before it.
static_assert(std::is_constructible_v<Finder, const Diagram&>);
static_assert(!std::is_constructible_v<Finder, Diagram>);
static_assert(!std::is_constructible_v<Finder, const Diagram>);

TEST(Finder, FindsNothingAmongNoCircles) {
  const Diagram diagram = compute({}).value();
  EXPECT_EQ(Finder(diagram).find({0, 0}), kNone);
}

}  // namespace
}  // namespace circle_voronoi
