// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/fit_areas.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "cell_measure.h"
#include "circle_voronoi/cells.h"
#include "circle_voronoi/certify.h"
#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/compute.h"
#include "fits.h"
#include "random.h"
#include "region_shapes.h"
#include "rings.h"
#include "spring.h"
#include "spring_system.h"

namespace circle_voronoi {
namespace {

using test::fitShares;
using test::sharesOver;

Region boxRegion(const Box& box) { return Region::from(box).value(); }
Region unitSquare() { return boxRegion({0, 0, 1, 1}); }

std::vector<Circle> randomSites(std::size_t count, Random& random) {
  std::vector<Circle> sites;
  for (std::size_t i = 0; i < count; ++i) sites.push_back({random.unit(), random.unit(), 0});
  return sites;
}

/// Expects that the areas of a fit equal the areas in its certified diagram and the requested areas.
void expectFits(const Result<AreaFit>& fit, const std::vector<Circle>& sites, const std::vector<double>& shares,
                const Region& region) {
  ASSERT_TRUE(fit) << fit.error().message;
  EXPECT_EQ(*std::ranges::min_element(fit->weights), 0);
  EXPECT_TRUE(certify(fit->diagram).value().certified());
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  for (std::size_t i = 0; i < sites.size(); ++i) {
    EXPECT_EQ(fit->diagram.circles[i].x, sites[i].x);
    EXPECT_EQ(fit->diagram.circles[i].r, fit->weights[i]);
    const double target = shares[i] / sum * region.area();
    EXPECT_NEAR(fit->areas[i], target, 1e-9 * target) << "site " << i;
  }
  EXPECT_LE(fit->error, 1e-9);
}

/// The integral of 1 / |u_left - u_right| along an arc by the midpoint rule over its parameter.
double stiffnessByQuadrature(const EdgeCurve& arc) {
  constexpr int kPieces = 20000;
  const double step = std::log(arc.to / arc.from) / kPieces;
  const auto unitFrom = [](Point focus, Point p) {
    const double length = std::hypot(p.x - focus.x, p.y - focus.y);
    return Vector{(p.x - focus.x) / length, (p.y - focus.y) / length};
  };
  double sum = 0;
  for (int k = 0; k < kPieces; ++k) {
    const double s = arc.from * std::exp((k + 0.5) * step);
    const Point before = pointAt(arc.bisector, arc.from * std::exp(k * step));
    const Point after = pointAt(arc.bisector, arc.from * std::exp((k + 1) * step));
    const Point p = pointAt(arc.bisector, s);
    const Vector u = unitFrom(arc.bisector.left, p);
    const Vector v = unitFrom(arc.bisector.right, p);
    sum += std::hypot(after.x - before.x, after.y - before.y) / std::hypot(u.x - v.x, u.y - v.y);
  }
  return sum;
}

TEST(AreaFitSprings, HaveTheStiffnessOfTheIntegralByQuadrature) {
  for (const double radius : {0.0, 0.3, 0.9, 0.999, -0.5}) {
    EdgeCurve arc;
    arc.bisector = bisector({0, 0, 0.5 + radius}, {1, 0, 0.5});
    for (const auto& [from, to] : {std::pair{0.5, 3.0}, {1.0, 1.001}, {2.0, 9.0}, {0.1, 0.2}}) {
      arc.from = from;
      arc.to = to;
      const double expected = stiffnessByQuadrature(arc);
      EXPECT_NEAR(stiffness(arc), expected, 1e-6 * expected) << radius << ' ' << from;
    }
  }
}

// Curved, straight, clipped and nearly hidden: the springs are the derivatives of the areas by each weight.
void expectSpringsAreDerivatives(Metric metric) {
  Random random(7);
  Options options;
  options.metric = metric;
  options.weights = true;
  const Region region = unitSquare();
  for (int trial = 0; trial < 30; ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    std::vector<Circle> circles = randomSites(2 + random.below(12), random);
    if (trial % 3 > 0) {
      for (Circle& c : circles) c.r = random.uniform(0, trial % 3 == 1 ? 0.05 : 0.2);
    }
    const Diagram diagram = compute(circles, options).value();
    if (!diagram.hidden.empty()) continue;
    const CellMeasure cells = measureCells(diagram, region);
    constexpr double kStep = 1e-6;
    std::vector<Circle> grown = circles;
    std::vector<Circle> shrunken = circles;
    const std::size_t chosen = random.below(circles.size());
    for (std::size_t i = 0; i < circles.size(); ++i) {
      // Radii are not negative, and only their differences count.
      grown[i].r += 1 + (i == chosen ? kStep : 0);
      shrunken[i].r += 1 - (i == chosen ? kStep : 0);
    }
    const Diagram more = compute(grown, options).value();
    const Diagram less = compute(shrunken, options).value();
    if (!more.hidden.empty() || !less.hidden.empty()) continue;
    const std::vector<double> up = measureCells(more, region).areas;
    const std::vector<double> down = measureCells(less, region).areas;
    test::expectDerivatives(cells.springs, chosen, up, down, kStep);
  }
}

TEST(AreaFitSprings, AreTheDerivativeOfTheAreas) {
  expectSpringsAreDerivatives(Metric::circles);
  expectSpringsAreDerivatives(Metric::power);
}

TEST(AreaFitSprings, AreSolvedInEachComponentByItself) {
  const std::vector<Spring> springs = {{0, 2, 1}, {2, 4, 3}, {1, 3, 2}};
  SpringSystem system(6, springs);
  EXPECT_EQ(system.components(), 3U);
  EXPECT_EQ(system.componentOf(), (std::vector<std::size_t>{0, 1, 0, 1, 0, 2}));
  const std::vector<double> x =
      system.solve(std::vector<double>{1, 3, 2}, std::vector<double>{1, 4, 2, -4, -3, 0}, std::vector<double>(6, 1));
  // The forces belong to x = (4/3, 1, 1/3, -1, -2/3... ), up to a constant in each component.
  ASSERT_EQ(x.size(), 6U);
  EXPECT_NEAR(x[0] - x[2], 1, 1e-14);
  EXPECT_NEAR(x[2] - x[4], 1, 1e-14);
  EXPECT_NEAR(x[1] - x[3], 2, 1e-14);
  EXPECT_NEAR(x[0] + x[2] + x[4], 0, 1e-14);
  EXPECT_EQ(x[5], 0);
}

// The border of two sites is a branch of a hyperbola, and its area up to the middle has a closed form.
TEST(AreaFit, OfTwoSitesIsTheClosedForm) {
  const std::vector<Circle> sites = {{0.25, 0.5, 0}, {0.75, 0.5, 0}};
  const double a = 0.125;
  const double b = std::sqrt(0.25 * 0.25 - a * a);
  // The integral of a sqrt(1 + y^2 / b^2) over |y| < 1/2, right of the middle.
  const double v = 0.5 / b;
  const double beyond = a * b * (v * std::sqrt(1 + v * v) + std::asinh(v));
  const auto fit = fitAreas(sites, std::vector{0.5 + beyond, 0.5 - beyond}, unitSquare()).value();
  EXPECT_NEAR(fit.weights[0], 2 * a, 1e-9);
  EXPECT_EQ(fit.weights[1], 0);
}

void expectAreasOverDecades(Metric metric) {
  for (const double decades : {0.0, 1.0, 2.0}) {
    for (const std::size_t count : {1U, 2U, 3U, 10U, 300U}) {
      SCOPED_TRACE(std::to_string(count) + " sites over " + std::to_string(decades) + " decades");
      Random random(count);
      const std::vector<Circle> sites = randomSites(count, random);
      const std::vector<double> shares = sharesOver(decades, count, random);
      expectFits(fitShares(sites, shares, unitSquare(), 0, metric), sites, shares, unitSquare());
    }
  }
}

TEST(AreaFit, ReachesAreasOverDecadesAmongRandomSites) { expectAreasOverDecades(Metric::circles); }
TEST(PowerAreaFit, ReachesAreasOverDecadesAmongRandomSites) { expectAreasOverDecades(Metric::power); }

// Weights are doubles. A cell that is a millionth of its neighbor is a sliver behind it, whose area the last bits of
// the weights decide: the fit ends there, and no weight can be better.
TEST(AreaFit, GoesAsFarAsTheLastBitsOfWeights) {
  Random random(300);
  const std::vector<Circle> sites = randomSites(300, random);
  const std::vector<double> shares = sharesOver(6, sites.size(), random);
  const auto fit = fitShares(sites, shares, unitSquare()).value();
  EXPECT_GT(fit.error, 1e-9);
  EXPECT_LT(fit.error, 0.1);
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  const CellMeasure cells = measureCells(fit.diagram, unitSquare());
  std::vector<double> stiffness(sites.size(), 0);
  for (const Spring& spring : cells.springs) {
    stiffness[static_cast<std::size_t>(spring.left)] += spring.stiffness;
    stiffness[static_cast<std::size_t>(spring.right)] += spring.stiffness;
  }
  const double lastBit = 0x1p-52 * *std::ranges::max_element(fit.weights);
  for (std::size_t i = 0; i < sites.size(); ++i) {
    EXPECT_NEAR(fit.areas[i], shares[i] / sum, std::max(1e-9 * shares[i] / sum, stiffness[i] * lastBit)) << i;
  }
}

void expectAreasWhereverTheSitesLie(Metric metric) {
  struct Family {
    std::string name;
    std::function<Circle(int, Random&)> site;
  };
  const std::vector<Family> families = {
      {"clusters",
       [](int i, Random& r) {
         return Circle{0.2 * (i % 5) + 1e-3 * r.unit(), 0.1 + 0.2 * (i % 4) + 1e-3 * r.unit(), 0};
       }},
      {"grid",
       [](int i, Random&) {
         return Circle{0.05 + 0.1 * (i % 10), 0.05 + 0.1 * (i / 10), 0};
       }},
      {"collinear",
       [](int, Random& r) {
         return Circle{r.unit(), 0.5, 0};
       }},
      {"one corner",
       [](int, Random& r) {
         return Circle{0.01 * r.unit(), 0.01 * r.unit(), 0};
       }},
      {"outside",
       [](int, Random& r) {
         return Circle{3 + r.unit(), 2 + r.unit(), 0};
       }},

  };
  for (const auto& [name, site] : families) {
    SCOPED_TRACE(name);
    Random random(11);
    std::vector<Circle> sites;
    for (int i = 0; i < 100; ++i) sites.push_back(site(i, random));
    const std::vector<double> shares = sharesOver(1, sites.size(), random);
    expectFits(fitShares(sites, shares, unitSquare(), 0, metric), sites, shares, unitSquare());
  }
}

TEST(AreaFit, ReachesAreasWhereverTheSitesLie) { expectAreasWhereverTheSitesLie(Metric::circles); }
TEST(PowerAreaFit, ReachesAreasWhereverTheSitesLie) { expectAreasWhereverTheSitesLie(Metric::power); }

// Many of the sites lie between the teeth, and parts of their cells in the region are slivers, which a step loses
// easily.
void expectAreasInACombAmongManySites(Metric metric) {
  struct Trial {
    std::uint64_t seed;
    double decades;
  };
  const Region region = test::regionFrom({test::combRing({0, 0, 1, 1}, 12)});
  for (const auto& [seed, decades] : {Trial{13, 0}, {34, 0}, {9, 1}, {20, 1}}) {
    SCOPED_TRACE("seed " + std::to_string(seed) + " over " + std::to_string(decades) + " decades");
    Random random(seed);
    const std::vector<Circle> sites = randomSites(500, random);
    const std::vector<double> shares = sharesOver(decades, sites.size(), random);
    expectFits(fitShares(sites, shares, region, 0, metric), sites, shares, region);
  }
}

TEST(AreaFit, ReachesAreasInACombAmongManySites) { expectAreasInACombAmongManySites(Metric::circles); }
TEST(PowerAreaFit, ReachesAreasInACombAmongManySites) { expectAreasInACombAmongManySites(Metric::power); }

void expectAreasInRegionsOfSeveralPieces(Metric metric) {
  std::mt19937_64 shapes(41);
  const Region::Ring left = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const Region::Ring hole = {{0.2, 0.2}, {0.8, 0.2}, {0.8, 0.8}, {0.2, 0.8}};
  const Region::Ring island = {{0.4, 0.4}, {0.6, 0.4}, {0.6, 0.6}, {0.4, 0.6}};
  const Region::Ring right = {{3, 0}, {4, 0}, {4, 1}, {3, 1}};
  const std::vector<std::pair<std::string, Region>> regions = {
      {"two squares far apart, one with a hole", Region::fromRings(std::vector{left, right, hole}).value()},
      {"a frame around an island", Region::fromRings(std::vector{left, hole, island}).value()},
      {"a comb", test::regionFrom({test::combRing({0, 0, 1, 1}, 12)})},
      {"a spiral", test::regionFrom({test::spiralRing({0, 0, 1, 1}, 4)})},
      {"a coast and a star", Region::fromRings(std::vector{test::coastRing(shapes, {0.5, 0.5}, 0.4, 500),
                                                           test::starRing(shapes, {3, 0.5}, 0.2, 0.4, 30)})
                                 .value()}};
  for (const auto& [name, region] : regions) {
    const Box box = region.bounds();
    for (const bool areInOneHalf : {false, true}) {
      SCOPED_TRACE(name + (areInOneHalf ? ", sites in the left half" : ""));
      Random random(51);
      std::vector<Circle> sites;
      const double width = (box.maxX - box.minX) * (areInOneHalf ? 0.5 : 1);
      for (int i = 0; i < 60; ++i) {
        sites.push_back({box.minX + width * random.unit(), box.minY + (box.maxY - box.minY) * random.unit(), 0});
      }
      const std::vector<double> shares = sharesOver(1, sites.size(), random);
      expectFits(fitShares(sites, shares, region, 0, metric), sites, shares, region);
    }
  }
}

TEST(AreaFit, ReachesAreasInRegionsOfSeveralPiecesAndWithHoles) {
  expectAreasInRegionsOfSeveralPieces(Metric::circles);
}
TEST(PowerAreaFit, ReachesAreasInRegionsOfSeveralPiecesAndWithHoles) {
  expectAreasInRegionsOfSeveralPieces(Metric::power);
}

/// The dual function at a list of weights, by quadrature on a grid in the unit square.
double dualValue(const std::vector<Circle>& sites, const std::vector<double>& weights,
                 const std::vector<double>& targets) {
  constexpr int kCells = 60;
  double value = std::inner_product(weights.begin(), weights.end(), targets.begin(), 0.0);
  for (int row = 0; row < kCells; ++row) {
    for (int column = 0; column < kCells; ++column) {
      double least = 1e9;
      for (std::size_t i = 0; i < sites.size(); ++i) {
        const double d = std::hypot((column + 0.5) / kCells - sites[i].x, (row + 0.5) / kCells - sites[i].y);
        least = std::min(least, d - weights[i]);
      }
      value += least / kCells / kCells;
    }
  }
  return value;
}

TEST(AreaFit, MaximizesTheDualFunction) {
  Random random(3);
  const std::vector<Circle> sites = randomSites(8, random);
  const std::vector<double> shares = sharesOver(1, sites.size(), random);
  const auto fit = fitShares(sites, shares, unitSquare()).value();
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  std::vector<double> targets;
  for (const double share : shares) targets.push_back(share / sum);
  const double best = dualValue(sites, fit.weights, targets);
  for (int trial = 0; trial < 1000; ++trial) {
    std::vector<double> weights = fit.weights;
    for (double& weight : weights) weight += random.uniform(-0.1, 0.1);
    EXPECT_LT(dualValue(sites, weights, targets), best) << "trial " << trial;
  }
}

TEST(AreaFit, DoesNotDependOnScaleDirectionOrOrder) {
  Random random(5);
  const std::vector<Circle> sites = randomSites(50, random);
  const std::vector<double> shares = sharesOver(2, sites.size(), random);
  const auto fit = fitShares(sites, shares, unitSquare()).value();

  std::vector<Circle> scaled;
  for (const Circle& site : sites) scaled.push_back({0x1p90 * site.x, 0x1p90 * site.y, 0});
  const auto large = fitShares(scaled, shares, boxRegion({0, 0, 0x1p90, 0x1p90})).value();

  std::vector<Circle> turned;
  for (const Circle& site : sites) turned.push_back({-site.y, site.x, 0});
  const auto sideways = fitShares(turned, shares, boxRegion({-1, 0, 0, 1})).value();

  std::vector<Circle> backwards(sites.rbegin(), sites.rend());
  const auto reverse = fitShares(backwards, {shares.rbegin(), shares.rend()}, unitSquare()).value();

  for (std::size_t i = 0; i < sites.size(); ++i) {
    EXPECT_NEAR(large.weights[i] / 0x1p90, fit.weights[i], 1e-8);
    EXPECT_NEAR(sideways.weights[i], fit.weights[i], 1e-8);
    EXPECT_NEAR(reverse.weights[sites.size() - 1 - i], fit.weights[i], 1e-8);
  }
}

// The border of a power diagram lies where half the difference of the weights moves it, over the distance.
TEST(PowerAreaFit, OfTwoSitesIsTheClosedForm) {
  const std::vector<Circle> sites = {{0.25, 0.5, 0}, {0.75, 0.5, 0}};
  AreaFitOptions options;
  options.metric = Metric::power;
  const auto fit = fitAreas(sites, std::vector{0.75, 0.25}, unitSquare(), options).value();
  EXPECT_NEAR(fit.weights[0], 0.25, 1e-9);
  EXPECT_EQ(fit.weights[1], 0);
  EXPECT_EQ(fit.diagram.metric, Metric::power);
  EXPECT_TRUE(fit.diagram.weights);
}

// The largest cell has 10^4 times the area of the smallest.
TEST(PowerAreaFit, ReachesAreasOverFourDecades) {
  Random random(21);
  const std::vector<Circle> sites = randomSites(500, random);
  const std::vector<double> shares = sharesOver(4, sites.size(), random);
  expectFits(fitShares(sites, shares, unitSquare(), 0, Metric::power), sites, shares, unitSquare());
}

TEST(AreaFit, RefusesTheMetricWithoutWeights) {
  AreaFitOptions options;
  options.metric = Metric::centers;
  const auto fit = fitAreas(std::vector<Circle>{{0, 0, 0}}, std::vector{1.0}, unitSquare(), options);
  ASSERT_FALSE(fit);
  EXPECT_EQ(fit.error().code, ErrorCode::badOption);
}

TEST(AreaFit, StartsFromTheRadii) {
  Random random(9);
  std::vector<Circle> sites = randomSites(200, random);
  const std::vector<double> shares = sharesOver(2, sites.size(), random);
  const auto fit = fitShares(sites, shares, unitSquare()).value();
  for (std::size_t i = 0; i < sites.size(); ++i) sites[i].r = fit.weights[i];
  const auto again = fitShares(sites, shares, unitSquare()).value();
  EXPECT_EQ(again.steps, 0);
  EXPECT_EQ(again.weights, fit.weights);

  sites[17].x += 0.1 / std::sqrt(200.0);
  const auto moved = fitShares(sites, shares, unitSquare());
  expectFits(moved, sites, shares, unitSquare());
  EXPECT_LT(moved->steps, fit.steps);

  // Radii that hide cells, or are negative, are a start as well.
  for (Circle& site : sites) site.r = -random.unit();
  expectFits(fitShares(sites, shares, unitSquare()), sites, shares, unitSquare());
}

/// The root mean square of the distances between sites and the centers of mass of their cells.
double distanceFromCentroids(const AreaFit& fit, const Region& region) {
  const std::vector<Point> centroids = ClippedDiagram::from(fit.diagram, region).value().centroids();
  double sum = 0;
  for (std::size_t i = 0; i < centroids.size(); ++i) {
    const Circle& site = fit.diagram.circles[i];
    sum +=
        (site.x - centroids[i].x) * (site.x - centroids[i].x) + (site.y - centroids[i].y) * (site.y - centroids[i].y);
  }
  return std::sqrt(sum / static_cast<double>(centroids.size()));
}

TEST(AreaFit, MovesSitesToTheCentroidsOfTheirCellsAndKeepsTheAreas) {
  Random random(31);
  const Region hall = test::regionFrom({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0.3, 0.4}, {0.6, 0.4}, {0.6, 0.7}}});
  const std::vector<Circle> sites = randomSites(60, random);
  const std::vector<double> shares = sharesOver(1.5, 60, random);
  AreaFitOptions options;
  options.shares = true;
  const AreaFit still = fitAreas(sites, shares, hall, options).value();
  options.relax = 40;
  int told = 0;
  options.onStep = [&](const AreaFitStep& step) {
    EXPECT_GE(step.step, told);
    told = step.step;
  };
  const Result<AreaFit> relaxed = fitAreas(sites, shares, hall, options);
  ASSERT_TRUE(relaxed) << relaxed.error().message;
  expectFits(relaxed, relaxed->diagram.circles, shares, hall);
  EXPECT_EQ(told, relaxed->steps);
  EXPECT_LT(distanceFromCentroids(*relaxed, hall), 0.1 * distanceFromCentroids(still, hall));

  // Once is what two fits do.
  options = {};
  options.shares = true;
  options.relax = 1;
  const AreaFit once = fitAreas(sites, shares, hall, options).value();
  options.relax = 0;
  options.tolerance = 1e-3;
  const AreaFit first = fitAreas(sites, shares, hall, options).value();
  const std::vector<Point> centroids = ClippedDiagram::from(first.diagram, hall).value().centroids();
  std::vector<Circle> moved;
  for (std::size_t i = 0; i < centroids.size(); ++i) {
    moved.push_back({centroids[i].x, centroids[i].y, first.weights[i]});
  }
  options.tolerance = 1e-9;
  const AreaFit second = fitAreas(moved, shares, hall, options).value();
  EXPECT_EQ(once.weights, second.weights);
  EXPECT_EQ(once.areas, second.areas);
  EXPECT_EQ(once.steps, first.steps + second.steps);
}

TEST(AreaFit, RefusesImpossibleFits) {
  const std::vector<Circle> sites = {{0.2, 0.2, 0}, {0.7, 0.4, 0}, {0.2, 0.2, 0}};
  struct Case {
    std::size_t count;
    std::vector<double> areas;
    AreaFitOptions options;
    std::optional<CircleIndex> blamed;  ///< nothing: the fit is possible
  };
  const std::vector<Case> cases = {{3, {0.2, 0.3, 0.5}, {}, 2},
                                   {2, {0.5, 0}, {}, 1},
                                   {2, {-1, 2}, {}, 0},
                                   {2, {0.5, INFINITY}, {}, 1},
                                   {2, {0.5}, {}, kNone},
                                   {1, {0.1, 0.2, 0.7}, {}, kNone},
                                   {0, {}, {}, kNone},
                                   {2, {0.5, 1}, {}, kNone},
                                   // The sum may be off by half the tolerance.
                                   {2, {0.5, 0.504}, {.tolerance = 0x1p-7}, kNone},
                                   {2, {0.5, 0.496}, {.tolerance = 0x1p-7}, kNone},
                                   {2, {0.5, 0.503}, {.tolerance = 0x1p-7}, {}},
                                   {2, {0.5, 0.5}, {.tolerance = 0}, kNone},
                                   {2, {0.5, 0.5}, {.maxSteps = 0}, kNone},
                                   {2, {0.5, 0.5}, {.relax = -1}, kNone}};
  for (const auto& [count, areas, options, blamed] : cases) {
    const auto fit = fitAreas(std::span(sites).first(count), areas, unitSquare(), options);
    ASSERT_EQ(fit.ok(), !blamed) << testing::PrintToString(areas);
    if (blamed) {
      EXPECT_EQ(fit.error().circle, *blamed) << fit.error().message;
    }
  }
}

TEST(AreaFit, SaysWhatItReachedWhereItEndsTooEarly) {
  Random random(13);
  std::vector<Circle> sites = randomSites(200, random);
  std::vector<double> shares = sharesOver(1, sites.size(), random);
  const Region region = unitSquare();
  AreaFitOptions options;
  options.shares = true;
  options.maxSteps = 1;
  std::vector<double> weights;
  options.onStep = [&](const AreaFitStep& step) { weights.assign(step.weights.begin(), step.weights.end()); };
  const auto reached = [&](const std::string& start) {
    const auto fit = fitAreas(sites, shares, region, options);
    EXPECT_FALSE(fit);
    if (fit) return 0.0;
    EXPECT_EQ(fit.error().code, ErrorCode::notConverged);
    EXPECT_EQ(fit.error().message.substr(0, start.size()), start);
    // The number is that of the last weights in the region alone.
    std::vector<Circle> circles = sites;
    for (std::size_t i = 0; i < circles.size(); ++i) circles[i].r = weights[i];
    const std::vector<double> areas = measureCells(compute(circles).value(), region).areas;
    const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
    double error = 0;
    for (std::size_t i = 0; i < areas.size(); ++i) error = std::max(error, std::abs(areas[i] * sum / shares[i] - 1));
    EXPECT_NEAR(std::stod(fit.error().message.substr(start.size())), error, 0.05 * error);
    return error;
  };
  const double first = reached("The fit stopped after 1 step: the largest relative error of an area is ");
  options.maxSteps = 8;
  const double later = reached("The fit stopped after 8 steps: the largest relative error of an area is ");
  EXPECT_LT(later, first);
  // The fit goes on from there.
  for (std::size_t i = 0; i < sites.size(); ++i) sites[i].r = weights[i];
  options.maxSteps = AreaFitOptions{}.maxSteps;
  EXPECT_TRUE(fitAreas(sites, shares, region, options));
  // Sites far outside, where the first steps fit the background.
  sites.clear();
  for (int i = 0; i < 100; ++i) sites.push_back({3 + random.unit(), 2 + random.unit(), 0});
  shares.assign(sites.size(), 1);
  options.maxSteps = 3;
  EXPECT_GT(reached("The fit stopped after 3 steps: the largest relative error of an area is "), 0.1);
}

TEST(AreaFit, TellsEachStepAndStopsWhereTheCallerThrows) {
  const std::vector<Circle> sites = {{0.2, 0.2, 0}, {0.7, 0.4, 0}};
  std::vector<double> errors;
  AreaFitOptions options;
  options.onStep = [&](const AreaFitStep& step) {
    EXPECT_EQ(step.step, static_cast<int>(errors.size()));
    EXPECT_EQ(step.weights.size(), 2U);
    errors.push_back(step.error);
  };
  const auto fit = fitAreas(sites, std::vector{0.8, 0.2}, unitSquare(), options).value();
  EXPECT_EQ(errors.size(), static_cast<std::size_t>(fit.steps) + 1);
  EXPECT_EQ(errors.back(), fit.error);

  options.onStep = [](const AreaFitStep&) { throw std::runtime_error("enough"); };
  EXPECT_THROW((void)fitAreas(sites, std::vector{0.8, 0.2}, unitSquare(), options), std::runtime_error);
}

}  // namespace
}  // namespace circle_voronoi
