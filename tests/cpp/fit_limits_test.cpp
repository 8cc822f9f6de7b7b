// SPDX-License-Identifier: GPL-3.0-or-later
// Fits at the limits of numbers: the precision of the last bits of weights, and refusals.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/fit_areas.h"
#include "random.h"

namespace circle_voronoi {
namespace {

Region regionOfBox(const Box& box) { return Region::from(box).value(); }

Result<AreaFit> fitToShares(const std::vector<Circle>& sites, const std::vector<double>& shares, const Region& region) {
  AreaFitOptions options;
  options.shares = true;
  return fitAreas(sites, shares, region, options);
}

std::string errorOf(const Result<AreaFit>& fit) {
  return fit ? "" : std::string(errorCodeName(fit.error().code)) + ": " + fit.error().message;
}

/// The largest relative error of an area with these weights; 1 or more if a cell is hidden.
double errorAt(const std::vector<Circle>& sites, const std::vector<double>& weights, const std::vector<double>& targets,
               const Region& region) {
  std::vector<Circle> circles = sites;
  for (std::size_t i = 0; i < circles.size(); ++i) circles[i].r = weights[i];
  const Diagram diagram = compute(circles).value();
  const std::vector<double> areas = ClippedDiagram::from(diagram, region).value().areas();
  double error = 0;
  for (std::size_t i = 0; i < areas.size(); ++i) error = std::max(error, std::abs(areas[i] - targets[i]) / targets[i]);
  return error;
}

/// Two sites next to each other, of which one has next to nothing, among some others.
TEST(AreaFitLimits, NoChangeOfALastBitMakesTheErrorSmaller) {
  Random random(17);
  const Region region = regionOfBox({0, 0, 1, 1});
  int coarse = 0;
  for (int trial = 0; trial < 48; ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    std::vector<Circle> sites = {{0.3, 0.4, 0}, {0.3 + std::pow(10, -2 - trial % 3), 0.4, 0}};
    std::vector<double> shares = {1, std::pow(10, -4 - trial % 6)};
    for (int k = 0; k < trial / 12; ++k) {
      sites.push_back({random.unit(), random.unit(), 0});
      shares.push_back(random.uniform(0.1, 1));
    }
    const auto fit = fitToShares(sites, shares, region);
    if (!fit) {
      // Only where no weight gives the area, even nearly.
      EXPECT_EQ(fit.error().code, ErrorCode::notConverged) << fit.error().message;
      EXPECT_LE(shares[1], 1e-8) << fit.error().message;
      continue;
    }
    EXPECT_LT(fit->error, 1);
    if (fit->error <= 1e-9) continue;
    ++coarse;
    const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
    std::vector<double> targets;
    for (const double share : shares) targets.push_back(share / sum);
    for (std::size_t i = 0; i < sites.size(); ++i) {
      for (const double towards : {0.0, 10.0}) {
        std::vector<double> weights = fit->weights;
        weights[i] = std::nextafter(weights[i], towards);
        EXPECT_GE(errorAt(sites, weights, targets, region), 0.99 * fit->error) << i;
      }
    }
  }
  EXPECT_GE(coarse, 12);
}

TEST(AreaFitLimits, RefusesWhatLeavesTheRangeOfNumbers) {
  const std::vector<Circle> sites = {{0.25, 0.5, 0}, {0.75, 0.5, 0}};
  const Region square = regionOfBox({0, 0, 1, 1});
  EXPECT_EQ(errorOf(fitToShares(sites, {1e308, 1e308}, square)),
            "badInput: The areas sum to more than the largest number.");
  EXPECT_EQ(errorOf(fitToShares(sites, {1, 1e-300}, square)),
            "badInput: Area 1 is too small: 1e-300 of a region with the area 1.");
  EXPECT_EQ(errorOf(fitToShares(sites, {1, 1}, regionOfBox({0, 0, 2e28, 2e28}))),
            "badInput: The region has a coordinate beyond 9.903520314283042e+27, the limit of fits (2e+28).");
  for (const Box& box : {Box{-2e28, 0, 0, 1}, Box{0, -2e28, 1, 0}, Box{0, 0, 2e28, 1}, Box{0, 0, 1, 2e28}}) {
    EXPECT_NE(errorOf(fitToShares(sites, {1, 1}, regionOfBox(box))).find("beyond 9.9"), std::string::npos);
  }
  for (const Lattice& lattice : {Lattice{{2e28, 0}, {0, 1e27}}, Lattice{{1e27, -2e28}, {1e27, 0}},
                                 Lattice{{1e27, 0}, {-2e28, 1e27}}, Lattice{{1e27, 0}, {0, 2e28}}}) {
    const auto fit = fitAreas(std::span(sites).first(1), std::vector<double>{1}, lattice, {.shares = true});
    ASSERT_FALSE(fit);
    EXPECT_TRUE(fit.error().message.starts_with("The box has a coordinate beyond 9.9")) << fit.error().message;
  }
  const std::string far = errorOf(fitToShares({{0.25, 0.5, 0}, {1e29, 0.5, 0}}, {1, 1}, square));
  EXPECT_TRUE(far.starts_with("coordinateTooLarge: Circle 1 has a coordinate or a radius beyond")) << far;
  // Up to the limits it is as everywhere.
  EXPECT_EQ(errorOf(fitToShares({{2e27, 8e26, 0}, {6e27, 2.4e27, 0}}, {1, 3}, regionOfBox({0, 0, 8e27, 8e27}))), "");
  EXPECT_EQ(errorOf(fitToShares({{2.5e-16, 1e-16, 0}, {7.5e-16, 3e-16, 0}}, {1, 3}, regionOfBox({0, 0, 1e-15, 1e-15}))),
            "");
}

}  // namespace
}  // namespace circle_voronoi
