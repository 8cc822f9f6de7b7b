// SPDX-License-Identifier: GPL-3.0-or-later
// Diagrams take n log n steps. growth_test.cpp counts the signs of more families.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "circle_voronoi/certify.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/curve.h"
#include "circle_voronoi/sphere.h"
#include "growth.h"

namespace circle_voronoi::test {
namespace {

TEST(GrowthOfDiagrams, OfCircles) {
  expectGrowth({"compute", "compute.h",
                [](const GrowthInput& input) { return [circles = input.circles] { EXPECT_TRUE(compute(circles)); }; },
                circleFamilies()});
}

TEST(GrowthOfDiagrams, OfTheirProof) {
  expectGrowth({"certify", "certify.h",
                ofDiagram([](const Diagram& diagram) { EXPECT_TRUE(certify(diagram).value().certified()); }),
                circleFamilies()});
}

TEST(GrowthOfDiagrams, OfCenters) {
  expectGrowth({"compute of centers", "compute.h",
                [](const GrowthInput& input) {
                  return [circles = input.circles] { EXPECT_TRUE(compute(circles, {.metric = Metric::centers})); };
                },
                circleFamilies()});
}

TEST(GrowthOfDiagrams, OfPowers) {
  expectGrowth({"compute of powers", "compute.h",
                [](const GrowthInput& input) {
                  return [circles = input.circles] { EXPECT_TRUE(compute(circles, {.metric = Metric::power})); };
                },
                circleFamilies()});
}

/// The circles on a sphere of radius 1, over half of it.
std::vector<Cap> capsOf(const std::vector<Circle>& circles) {
  double size = 0;
  for (const Circle& c : circles) size = std::max({size, std::abs(c.x), std::abs(c.y)});
  std::vector<Cap> caps;
  for (const Circle& c : circles) caps.push_back({90 * c.x / size, 60 * c.y / size, c.r / size});
  return caps;
}

TEST(GrowthOfDiagrams, OfCaps) {
  expectGrowth({"computeSphere", "sphere.h",
                [](const GrowthInput& input) {
                  return [caps = capsOf(input.circles)] { EXPECT_TRUE(computeSphere(caps, {.radius = 1})); };
                },
                circleFamilies()});
}

TEST(GrowthOfDiagrams, OfCellsOnASphere) {
  expectGrowth({"checkSphere, areas, cellPolygons, farthestPlace, closestPair", "sphere.h",
                [](const GrowthInput& input) {
                  const auto sphere = kept(computeSphere(capsOf(input.circles), {.radius = 1}).value());
                  return [sphere] {
                    EXPECT_TRUE(checkSphere(*sphere));
                    static_cast<void>(areas(*sphere));
                    EXPECT_TRUE(cellPolygons(*sphere, {.tolerance = 0.01}));
                    static_cast<void>(farthestPlace(*sphere));
                    static_cast<void>(closestPair(*sphere));
                  };
                },
                circleFamilies()});
}

TEST(GrowthOfDiagrams, OfCurves) {
  expectGrowth({"edgeCurve", "curve.h", ofDiagram([](const Diagram& diagram) {
                  for (std::size_t e = 0; e < diagram.edges.size(); ++e) {
                    static_cast<void>(edgeCurve(diagram, static_cast<std::int32_t>(e)));
                  }
                }),
                circleFamilies()});
}

}  // namespace
}  // namespace circle_voronoi::test
