// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/hidden_warning.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "circle_voronoi/compute.h"
#include "circle_voronoi/sphere.h"

namespace circle_voronoi {
namespace {

/// Four circles and `count` smaller ones inside the first, by all metrics.
std::vector<Circle> crowd(int count) {
  std::vector<Circle> circles = {{-20, 0, 90}, {20, 0, 90}, {0, 20, 90}, {0, -20, 90}};
  for (int k = 0; k < count; ++k) circles.push_back({0.5 * k, 0, 1});
  return circles;
}

TEST(HiddenWarning, CountsCirclesIfMoreThanAQuarterIsHidden) {
  EXPECT_EQ(hiddenWarning(compute({}).value()), "");
  EXPECT_EQ(hiddenWarning(compute(crowd(1)).value()), "");
  const Diagram diagram = compute(crowd(2)).value();
  ASSERT_EQ(diagram.hidden.size(), 2U);
  EXPECT_TRUE(hiddenWarning(diagram).starts_with("2 of 6 circles are hidden")) << hiddenWarning(diagram);
}

TEST(HiddenWarning, IsForDistancesFromCirclesAlone) {
  const Diagram power = compute(crowd(2), {.metric = Metric::power}).value();
  ASSERT_EQ(power.hidden.size(), 2U);
  EXPECT_EQ(hiddenWarning(power), "");
}

TEST(HiddenWarning, CountsCapsOfASphere) {
  std::vector<Cap> caps = {{0, 0, 500}, {90, 0, 1}, {180, 0, 1}, {-90, 0, 1}};
  caps.push_back({1, 0, 10});
  EXPECT_EQ(hiddenWarning(computeSphere(caps).value()), "");
  caps.push_back({0, 1, 10});
  const std::string warning = hiddenWarning(computeSphere(caps).value());
  EXPECT_TRUE(warning.starts_with("2 of 6 circles are hidden")) << warning;
}

}  // namespace
}  // namespace circle_voronoi
