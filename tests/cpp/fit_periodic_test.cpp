// SPDX-License-Identifier: GPL-3.0-or-later
// Fits of areas in the box of a lattice, judged by the periodic diagram of the circles that they return.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "cell_measure.h"
#include "circle_voronoi/cells.h"
#include "circle_voronoi/certify.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/compute_periodic.h"
#include "circle_voronoi/fit_areas.h"
#include "circle_voronoi/periodic_diagram.h"
#include "fits.h"
#include "random.h"
#include "regions.h"

namespace circle_voronoi {
namespace {

using Circles = std::vector<Circle>;
using test::fitShares;
using test::sharesOver;

Circles sitesIn(const Lattice& lattice, std::size_t count, Random& random) {
  Circles sites;
  for (std::size_t i = 0; i < count; ++i) {
    const double u = random.unit();
    const double v = random.unit();
    sites.push_back({u * lattice.a.x + v * lattice.b.x, u * lattice.a.y + v * lattice.b.y, 0});
  }
  return sites;
}

/// The areas of the cells that sites have with some weights, by computePeriodic alone.
std::vector<double> areasOf(Circles sites, const std::vector<double>& weights, const Lattice& lattice,
                            Metric metric = Metric::circles) {
  for (std::size_t i = 0; i < sites.size(); ++i) sites[i].r = weights[i];
  Options options;
  options.metric = metric;
  options.weights = true;
  const auto periodic = computePeriodic(sites, lattice, options).value();
  std::vector<double> areas;
  for (CircleIndex i = 0; i < periodic.circleCount; ++i) areas.push_back(area(outline(periodic.diagram, i)));
  return areas;
}

void expectFits(const Result<PeriodicAreaFit>& fit, const Circles& sites, const std::vector<double>& shares,
                const Lattice& lattice) {
  ASSERT_TRUE(fit) << fit.error().message;
  EXPECT_EQ(*std::ranges::min_element(fit->weights), 0);
  EXPECT_TRUE(certify(fit->periodic.diagram).value().certified());
  EXPECT_TRUE(checkPeriodic(fit->periodic));
  const std::vector<double> areas = areasOf(sites, fit->weights, lattice, fit->periodic.diagram.metric);
  const double whole = test::boxArea(lattice);
  EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), whole, 1e-12 * whole);
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const double target = shares[i] / sum * whole;
    EXPECT_NEAR(areas[i], target, 1.001e-9 * target) << "site " << i;
    EXPECT_EQ(areas[i], fit->areas[i]) << "site " << i;
    EXPECT_EQ(fit->periodic.diagram.circles[i].r, fit->weights[i]);
  }
  EXPECT_LE(fit->error, 1e-9);
}

TEST(PeriodicAreaFit, ReachesAreasInBoxesOfAllShapes) {
  const std::vector<std::pair<std::string, Lattice>> lattices = {{"square", {{1, 0}, {0, 1}}},
                                                                 {"clockwise", {{0, 1}, {1, 0}}},
                                                                 {"hexagonal", {{1, 0}, {0.5, 0.8660254037844386}}},
                                                                 {"long", {{30, 0}, {0, 1}}},
                                                                 {"sheared", {{8, 1}, {23, 3}}}};
  for (const auto& [name, lattice] : lattices) {
    for (const std::size_t count : {1U, 2U, 3U, 4U, 20U, 150U}) {
      for (const double decades : {0.0, 1.0, 2.0}) {
        SCOPED_TRACE(name + ", " + std::to_string(count) + " sites over " + std::to_string(decades) + " decades");
        Random random(count);
        const Circles sites = sitesIn(lattice, count, random);
        const std::vector<double> shares = sharesOver(decades, count, random);
        for (const Metric metric : {Metric::circles, Metric::power}) {
          SCOPED_TRACE(metricName(metric));
          expectFits(fitShares(sites, shares, lattice, 0, metric), sites, shares, lattice);
        }
      }
    }
  }
}

TEST(PeriodicAreaFit, ReachesAreasWhereverTheSitesLie) {
  const Lattice lattice = {{4, 0}, {1, 3}};
  Random random(5);
  for (const std::string name : {"clusters", "grid", "on a line", "in one corner", "in many boxes", "with radii"}) {
    SCOPED_TRACE(name);
    Circles sites;
    for (int i = 0; i < 64; ++i) {
      const double u = random.unit();
      const double v = random.unit();
      if (name == "clusters") sites.push_back({i % 4 + 1e-3 * u, i % 3 + 1e-3 * v, 0});
      if (name == "grid") sites.push_back({0.5 * (i % 8), 0.375 * (i / 8), 0});
      if (name == "on a line") sites.push_back({4 * u, 1, 0});
      if (name == "in one corner") sites.push_back({0.01 * u, 0.01 * v, 0});
      if (name == "in many boxes") sites.push_back({200 * u - 100, 200 * v - 100, 0});
      if (name == "with radii") sites.push_back({4 * u, 3 * v, (i % 5) * 2.0});
    }
    const std::vector<double> shares = sharesOver(1, sites.size(), random);
    for (const Metric metric : {Metric::circles, Metric::power}) {
      SCOPED_TRACE(metricName(metric));
      expectFits(fitShares(sites, shares, lattice, 0, metric), sites, shares, lattice);
    }
  }
}

// Two sites half a period apart have two borders, as between parallel lines of equal sites. The borders depend only on
// the difference of the weights, so equal areas need equal weights.
TEST(PeriodicAreaFit, OfOneSiteAndOfEqualSharesHasTheWeightsOfSymmetry) {
  const auto one = fitAreas(Circles{{3, 4, 2}}, std::vector{6.0}, Lattice{{2, 0}, {1, 3}}).value();
  EXPECT_EQ(one.weights, std::vector{0.0});
  EXPECT_EQ(one.steps, 0);
  EXPECT_NEAR(one.areas[0], 6, 1e-12);
  const auto two = fitAreas(Circles{{0, 0, 0.2}, {1, 0.5, 0}}, std::vector{1.0, 1.0}, Lattice{{2, 0}, {0, 1}}).value();
  EXPECT_NEAR(two.weights[0], two.weights[1], 1e-9);
}

TEST(PeriodicAreaFit, SpringsAreTheDerivativeOfTheAreas) {
  Random random(7);
  const Lattice lattice = {{1, 0}, {0.3, 0.8}};
  int compared = 0;
  for (int trial = 0; trial < 30; ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    Circles circles = sitesIn(lattice, 1 + random.below(9), random);
    for (Circle& c : circles) c.r = 1 + random.uniform(0, 0.1);
    const PeriodicDiagram periodic = computePeriodic(circles, lattice).value();
    if (!periodic.diagram.hidden.empty()) continue;
    const std::size_t chosen = random.below(circles.size());
    constexpr double kStep = 1e-6;
    std::vector<double> weights;
    for (const Circle& c : circles) weights.push_back(c.r);
    weights[chosen] += kStep;
    const std::vector<double> up = areasOf(circles, weights, lattice);
    weights[chosen] -= 2 * kStep;
    const std::vector<double> down = areasOf(circles, weights, lattice);
    test::expectDerivatives(measureCells(periodic).springs, chosen, up, down, kStep);
    ++compared;
  }
  EXPECT_GT(compared, 15);
}

TEST(PeriodicAreaFit, DoesNotDependOnWhereTheBoxIs) {
  const Lattice lattice = {{1, 0}, {0.25, 1}};
  Random random(11);
  const Circles sites = sitesIn(lattice, 30, random);
  const std::vector<double> shares = sharesOver(1, sites.size(), random);
  const auto fit = fitShares(sites, shares, lattice).value();
  Circles moved = sites;
  for (Circle& c : moved) c = {c.x + 0.375, c.y - 0.625, c.r};
  Circles wrapped = sites;
  for (std::size_t i = 0; i < wrapped.size(); i += 3) wrapped[i].x += 2;
  const auto byMoved = fitShares(moved, shares, lattice).value();
  const auto byWrapped = fitShares(wrapped, shares, lattice).value();
  const auto byOther = fitShares(sites, shares, Lattice{{1, 0}, {3.25, 1}}).value();
  for (std::size_t i = 0; i < sites.size(); ++i) {
    EXPECT_NEAR(byMoved.weights[i], fit.weights[i], 1e-8);
    EXPECT_NEAR(byWrapped.weights[i], fit.weights[i], 1e-8);
    EXPECT_NEAR(byOther.weights[i], fit.weights[i], 1e-8);
  }
}

TEST(PeriodicAreaFit, MovesSitesToTheCentroidsOfTheirCellsAndKeepsTheAreas) {
  const Lattice lattice = {{1, 0}, {0.25, 1}};
  Random random(13);
  Circles sites = sitesIn(lattice, 40, random);
  sites[7].x += 5;
  const std::vector<double> shares = sharesOver(1, sites.size(), random);
  const auto still = fitShares(sites, shares, lattice);
  const auto relaxed = fitShares(sites, shares, lattice, 40);
  ASSERT_TRUE(still && relaxed);
  const auto distanceFromCentroids = [](const PeriodicAreaFit& fit) {
    double sum = 0;
    for (CircleIndex i = 0; i < fit.periodic.circleCount; ++i) {
      const Point p = centroid(outline(fit.periodic.diagram, i));
      const Circle& c = fit.periodic.diagram.circles[static_cast<std::size_t>(i)];
      sum += std::hypot(p.x - c.x, p.y - c.y);
    }
    return sum;
  };
  EXPECT_LT(distanceFromCentroids(*relaxed), 0.1 * distanceFromCentroids(*still));
  const auto& circles = relaxed->periodic.diagram.circles;
  const Circles given(circles.begin(), circles.begin() + 40);
  expectFits(relaxed, given, shares, lattice);
}

TEST(PeriodicAreaFit, StartsFromTheRadii) {
  const Lattice lattice = {{1, 0}, {0.25, 1}};
  Random random(17);
  Circles sites = sitesIn(lattice, 60, random);
  const std::vector<double> shares = sharesOver(1, sites.size(), random);
  const auto fit = fitShares(sites, shares, lattice).value();
  for (std::size_t i = 0; i < sites.size(); ++i) sites[i].r = fit.weights[i] - 3;
  const auto again = fitShares(sites, shares, lattice).value();
  EXPECT_LE(again.steps, 1);
}

// Other refusals are those of a fit in a region.
TEST(PeriodicAreaFit, RefusesImpossibleFits) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Lattice box = {{2, 0}, {0, 1}};
  const Circles sites = {{0, 0, 0}, {1, 0.5, 0}};
  struct Case {
    Circles sites;
    std::vector<double> areas;
    Lattice lattice;
    ErrorCode code;
    CircleIndex blamed = kNone;
  };
  const std::vector<Case> cases = {{sites, {1, 2}, box, ErrorCode::badInput},
                                   {sites, {2, 0}, box, ErrorCode::badInput, 1},
                                   {{{0.5, 0.25, 0}, {0.5, 0.25, 3}}, {1, 1}, box, ErrorCode::badInput, 1},
                                   {{{0.5, 0.25, 0}, {4.5, -0.75, 3}}, {1, 1}, box, ErrorCode::badInput, 1},
                                   {{{0, 0, 0}, {nan, 0, 0}}, {1, 1}, box, ErrorCode::nonFinite, 1},
                                   {sites, {1, 1}, {{2, 0}, {4, 0}}, ErrorCode::badOption},
                                   {sites, {1, 1}, {{2, 0}, {0, nan}}, ErrorCode::badOption}};
  for (const auto& [circles, areas, lattice, code, blamed] : cases) {
    const auto fit = fitAreas(circles, areas, lattice);
    ASSERT_FALSE(fit);
    EXPECT_EQ(fit.error().code, code) << fit.error().message;
    EXPECT_EQ(fit.error().circle, blamed) << fit.error().message;
  }
  const auto stopped =
      fitAreas(Circles{{0, 0, 0}, {1, 0.5, 0}, {0.3, 0.2, 0}}, std::vector{1.5, 0.3, 0.2}, box, {.maxSteps = 1});
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::notConverged);
}

// The scale of the coordinates is a power of two, so everything is the same but for it.
TEST(PeriodicAreaFit, DoesNotDependOnScale) {
  const Lattice lattice = {{1, 0}, {0.25, 1}};
  Random random(19);
  const Circles sites = sitesIn(lattice, 12, random);
  const std::vector<double> shares = sharesOver(1, sites.size(), random);
  const auto fit = fitShares(sites, shares, lattice).value();
  for (const double scale : {0x1p-40, 0x1p40, 0x1p90}) {
    SCOPED_TRACE(scale);
    Circles scaled = sites;
    for (Circle& c : scaled) c = {scale * c.x, scale * c.y, 0};
    const auto large = fitShares(scaled, shares, Lattice{{scale, 0}, {0.25 * scale, scale}}).value();
    for (std::size_t i = 0; i < sites.size(); ++i) EXPECT_NEAR(large.weights[i] / scale, fit.weights[i], 1e-8);
  }
}

}  // namespace
}  // namespace circle_voronoi
