// SPDX-License-Identifier: GPL-3.0-or-later
// Fits at the limits of numbers: the precision of the last bits of weights, and refusals.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/fit_areas.h"
#include "fits.h"
#include "random.h"
#include "report.h"
#include "rings.h"

namespace circle_voronoi {
namespace {

using test::fitShares;

Region regionOfBox(const Box& box) { return Region::from(box).value(); }

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
    const auto fit = fitShares(sites, shares, region);
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
  EXPECT_EQ(errorOf(fitShares(sites, {1e308, 1e308}, square)),
            "badInput: The areas sum to more than the largest number.");
  EXPECT_EQ(errorOf(fitShares(sites, {1, 1e-300}, square)),
            "badInput: Area 1 is too small: 1e-300 of a region with the area 1.");
  EXPECT_EQ(errorOf(fitShares(sites, {1, 1}, regionOfBox({0, 0, 2e28, 2e28}))),
            "badInput: The region has a coordinate beyond 9.903520314283042e+27, the limit of fits (2e+28).");
  for (const Box& box : {Box{-2e28, 0, 0, 1}, Box{0, -2e28, 1, 0}, Box{0, 0, 2e28, 1}, Box{0, 0, 1, 2e28}}) {
    EXPECT_NE(errorOf(fitShares(sites, {1, 1}, regionOfBox(box))).find("beyond 9.9"), std::string::npos);
  }
  for (const Lattice& lattice : {Lattice{{2e28, 0}, {0, 1e27}}, Lattice{{1e27, -2e28}, {1e27, 0}},
                                 Lattice{{1e27, 0}, {-2e28, 1e27}}, Lattice{{1e27, 0}, {0, 2e28}}}) {
    const auto fit = fitAreas(std::span(sites).first(1), std::vector<double>{1}, lattice, {.shares = true});
    ASSERT_FALSE(fit);
    EXPECT_TRUE(fit.error().message.starts_with("The box has a coordinate beyond 9.9")) << fit.error().message;
  }
  const std::string far = errorOf(fitShares({{0.25, 0.5, 0}, {1e29, 0.5, 0}}, {1, 1}, square));
  EXPECT_TRUE(far.starts_with("coordinateTooLarge: Circle 1 has a coordinate or a radius beyond")) << far;
  // Up to the limits it is as everywhere.
  EXPECT_EQ(errorOf(fitShares({{2e27, 8e26, 0}, {6e27, 2.4e27, 0}}, {1, 3}, regionOfBox({0, 0, 8e27, 8e27}))), "");
  EXPECT_EQ(errorOf(fitShares({{2.5e-16, 1e-16, 0}, {7.5e-16, 3e-16, 0}}, {1, 3}, regionOfBox({0, 0, 1e-15, 1e-15}))),
            "");
}

using Polygons = std::vector<std::vector<Region::Ring>>;

Region::Ring squareAt(double x, double y) { return {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}; }

/// Expects that a fit reaches its areas, measured by another clip.
void expectFit(const std::vector<Circle>& sites, const std::vector<double>& shares, const Region& region) {
  const auto fit = fitShares(sites, shares, region);
  ASSERT_TRUE(fit) << fit.error().message;
  EXPECT_LE(fit->error, fit->tolerance);
  if (fit->error > 1e-9) return;
  EXPECT_EQ(fit->tolerance, 1e-9);
  const std::vector<double> areas = ClippedDiagram::from(fit->diagram, region).value().areas();
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const double target = shares[i] / sum * region.area();
    EXPECT_NEAR(areas[i], target, 1.1e-9 * target) << "site " << i;
  }
}

/// Two and more sites, at random or on half integers, and shares over decades or equal.
struct Wanted {
  std::vector<Circle> sites;
  std::vector<double> shares;

  Wanted(double width, double height, Random& random) {
    const bool isAligned = random.below(3) == 0;
    const bool isEqual = random.below(3) == 0;
    const double decades = random.below(4) == 0 ? 4 : 1;
    const auto place = [&](double size) {
      return isAligned ? static_cast<double>(random.below(static_cast<std::size_t>(2 * size) + 1)) / 2
                       : random.uniform(0, size);
    };
    for (std::size_t k = 2 + random.below(11); k > 0; --k) {
      const Circle site = {place(width), place(height), 0};
      if (std::ranges::any_of(sites, [&](const Circle& s) { return s.x == site.x && s.y == site.y; })) continue;
      sites.push_back(site);
      shares.push_back(isEqual ? 1 : random.logUniform(0, decades));
    }
  }
};

/// A border through a corner has no length inside.
TEST(AreaFitLimits, PartsMayTouchInCornersOnly) {
  Random random(test::seedOr(21));
  expectFit({{0, 0, 0}, {2, 2, 0}}, {3, 1}, Region::fromPolygons(Polygons{{squareAt(0, 0)}, {squareAt(1, 1)}}).value());
  for (int trial = 0; trial < 200; ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    const int side = 2 + trial % 4;
    Polygons polygons;
    for (int i = 0; i < side; ++i) {
      for (int j = 0; j < side; ++j) {
        const bool isThere = trial % 3 == 0 ? i == j : (i + j) % 2 == 0 && random.below(10) > 0;
        if (isThere || i + j == 0) polygons.push_back({squareAt(i, j)});
      }
    }
    // Anywhere, or in one part alone.
    const double reach = trial % 5 == 0 ? 1 : side;
    const Wanted wanted(reach, reach, random);
    expectFit(wanted.sites, wanted.shares, Region::fromPolygons(polygons).value());
  }
}

/// The rate at which area passes jumps by many decades where a border comes out of the bridge.
TEST(AreaFitLimits, PartsMayHangTogetherByAThinBridge) {
  Random random(test::seedOr(22));
  for (int trial = 0; trial < 150; ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    const double top = 0.5 + random.logUniform(-9, -1);
    const Region region = test::regionFrom(
        {{{0, 0}, {1, 0}, {1, 0.5}, {2, 0.5}, {2, 0}, {3, 0}, {3, 1}, {2, 1}, {2, top}, {1, top}, {1, 1}, {0, 1}}});
    const Wanted wanted(3, trial % 2 == 0 ? 3 : 1, random);
    expectFit(wanted.sites, wanted.shares, region);
  }
}

/// The weights are those of the same sites at the origin, as differences of coordinates are exact.
TEST(AreaFitLimits, FitsFarAwayAreThoseAtTheOrigin) {
  Random random(test::seedOr(23));
  for (int trial = 0; trial < 60; ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    const double far = std::ldexp(1.0, 7 + trial % 30) * (trial % 2 == 0 ? 3 : -5);
    const double other = trial % 3 == 0 ? 0 : far;
    const double step = 0x1p-12;
    std::vector<Circle> here;
    std::vector<Circle> there;
    std::vector<double> shares;
    for (std::size_t k = 2 + random.below(10); k > 0; --k) {
      const Circle site = {step * static_cast<double>(random.below(4096)),
                           step * static_cast<double>(random.below(4096)), 0};
      if (std::ranges::any_of(here, [&](const Circle& s) { return s.x == site.x && s.y == site.y; })) continue;
      here.push_back(site);
      there.push_back({far + site.x, other + site.y, 0});
      shares.push_back(random.logUniform(0, 1));
    }
    const Region square = Region::fromPolygons(Polygons{{squareAt(0, 0)}}).value();
    const Region moved = Region::fromPolygons(Polygons{{squareAt(far, other)}}).value();
    const AreaFit one = fitShares(here, shares, square).value();
    const auto fit = fitShares(there, shares, moved);
    ASSERT_TRUE(fit) << fit.error().message;
    EXPECT_EQ(fit->weights, one.weights);
    EXPECT_EQ(fit->areas, one.areas);
    EXPECT_LE(fit->error, 1e-9);
    EXPECT_EQ(fit->tolerance, 1e-9);
    for (std::size_t i = 0; i < there.size(); ++i) {
      EXPECT_EQ(fit->diagram.circles[i].x, there[i].x);
      EXPECT_EQ(fit->diagram.circles[i].y, there[i].y);
    }
    // Sites that move have coordinates of their own, with areas as exact.
    const AreaFit relaxed = fitShares(there, shares, moved, 2).value();
    EXPECT_LE(relaxed.error, 1e-9);
    std::vector<Circle> back = relaxed.diagram.circles;
    for (Circle& c : back) c = {c.x - far, c.y - other, c.r};
    const Diagram diagram = compute(back).value();
    const auto areas = ClippedDiagram::from(diagram, square).value().areas();
    for (std::size_t i = 0; i < areas.size(); ++i) EXPECT_NEAR(areas[i], relaxed.areas[i], 1e-14);
  }
}

TEST(AreaFitLimits, CoordinatesWithoutExactDifferencesAllowTheirLastBits) {
  const double far = 5e6;
  const std::vector<Circle> sites = {{far + 0.2, 0.3, 0}, {far + 0.7, 0.6, 0}, {1e-9, 0.5, 0}};
  const auto fit = fitShares(sites, {1, 2, 3}, regionOfBox({far, 0, far + 1, 1}));
  ASSERT_TRUE(fit) << fit.error().message;
  EXPECT_LE(fit->error, fit->tolerance);
  EXPECT_LE(fit->tolerance, 1e-5);
  const auto periodic =
      fitAreas(std::span(sites).first(2), std::vector<double>{1, 2}, Lattice{{2, 0}, {0, 2}}, {.shares = true});
  ASSERT_TRUE(periodic);
  EXPECT_LE(periodic->error, periodic->tolerance);
  EXPECT_EQ(periodic->tolerance, 1e-9);
}

}  // namespace
}  // namespace circle_voronoi
