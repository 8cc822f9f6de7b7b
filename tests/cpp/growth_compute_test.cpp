// SPDX-License-Identifier: GPL-3.0-or-later
// Diagrams take n log n steps. growth_test.cpp counts the signs of more families.
#include <gtest/gtest.h>

#include "circle_voronoi/certify.h"
#include "circle_voronoi/comparison.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/curve.h"
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
  expectGrowth({"computeComparison", "comparison.h",
                [](const GrowthInput& input) {
                  return [circles = input.circles] { EXPECT_TRUE(computeComparison(circles, Metric::centers)); };
                },
                circleFamilies()});
}

TEST(GrowthOfDiagrams, OfPowers) {
  expectGrowth(
      {"powerDiagram", "comparison.h",
       [](const GrowthInput& input) { return [circles = input.circles] { EXPECT_TRUE(powerDiagram(circles)); }; },
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
