// SPDX-License-Identifier: GPL-3.0-or-later
// Circles that repeat with two periods, compared with the diagram of many copies.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <ranges>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "at.h"
#include "circle_voronoi/cells.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/compute_periodic.h"
#include "circle_voronoi/periodic_diagram.h"
#include "circle_voronoi/periodic_queries.h"
#include "random.h"
#include "regions.h"
#include "report.h"

namespace circle_voronoi {
namespace {

using Circles = std::vector<Circle>;

Options withWeights(bool weights, Metric metric = Metric::circles) {
  Options options;
  options.metric = metric;
  options.weights = weights;
  return options;
}

/// The cells of the given circles: the neighbors of each, counter-clockwise and starting with the smallest rotation.
using Neighbors = std::vector<std::tuple<std::int32_t, std::int32_t, std::int32_t>>;

Neighbors rotated(Neighbors neighbors) {
  if (neighbors.empty()) return neighbors;
  Neighbors best = neighbors;
  for (std::size_t k = 0; k < neighbors.size(); ++k) {
    std::ranges::rotate(neighbors, neighbors.begin() + 1);
    best = std::min(best, neighbors);
  }
  return best;
}

Neighbors neighborsOf(const PeriodicDiagram& periodic, CircleIndex circle) {
  Neighbors result;
  for (const auto& [j, shift] : neighbors(periodic, circle)) result.emplace_back(j, shift[0], shift[1]);
  return rotated(std::move(result));
}

/// The same neighbors, with shifts relative to the positions of the diagram's circles.
Neighbors placedNeighborsOf(const PeriodicDiagram& periodic, CircleIndex circle) {
  Neighbors result;
  for (const CircleIndex other : neighbors(periodic.diagram, circle)) {
    const auto [j, shift] = periodic.imageFrom(periodic.circleOf[at(other)], other);
    result.emplace_back(j, shift[0], shift[1]);
  }
  return rotated(std::move(result));
}

/// A basis of the same lattice: a = m[0] a' + m[1] b', b = m[2] a' + m[3] b', with determinant 1 or -1.
using BasisChange = std::array<std::int32_t, 4>;

Lattice changed(const Lattice& nice, const BasisChange& m) {
  const auto sum = [&](double k, double l) { return Vector{k * nice.a.x + l * nice.b.x, k * nice.a.y + l * nice.b.y}; };
  return {sum(m[0], m[1]), sum(m[2], m[3])};
}

/// A random lattice with periods that are nearly as short as possible, and another basis of the lattice.
struct RandomLattice {
  Lattice nice;
  BasisChange change = {1, 0, 0, 1};

  Lattice given() const { return changed(nice, change); }
};

/// Rounded, so that all sums in these tests are exact.
double onGrid(double x) { return std::round(x * 0x1p20) / 0x1p20; }

RandomLattice randomLattice(Random& random, double longest) {
  RandomLattice result;
  const double ratio = random.below(3) == 0 ? random.uniform(1, longest) : random.uniform(1, 2);
  const double angle = random.uniform(1.0 / 6, 1.0 / 3);
  const double turn = random.below(2) == 0 ? 0 : random.unit();
  const Vector a = directionAt(turn);
  const Vector b = directionAt(turn + angle);
  result.nice = {{onGrid(a.x), onGrid(a.y)}, {onGrid(ratio * b.x), onGrid(ratio * b.y)}};
  switch (random.below(5)) {
    case 0:
      result.nice = {{1, 0}, {0, 1}};
      break;
    case 1:
      result.nice = {{1, 0}, {0.5, onGrid(std::sqrt(3) / 2)}};
      break;
    default:
      break;
  }
  // Products of shears and reflections.
  auto& m = result.change;
  for (std::size_t steps = random.below(4); steps > 0; --steps) {
    const auto times = static_cast<std::int32_t>(random.below(9)) - 4;
    m = {m[2], m[3], m[0] + times * m[2], m[1] + times * m[3]};
  }
  return result;
}

Circles randomCircles(Random& random, const Lattice& nice, bool isOnGrid) {
  const std::size_t most = random.below(3) == 0 ? 200 : 8;
  const std::size_t count = 1 + random.below(most);
  const double spacing = std::sqrt(test::boxArea(nice) / static_cast<double>(count));
  const std::size_t sizes = random.below(6);
  const double base = std::array{0.0, 0.3, 0.45, 2.0, 5.0, 20.0}[random.below(6)] * spacing;
  const double steps = std::array{2.0, 3.0, 4.0, 8.0}[random.below(4)];
  const bool isSpread = random.below(4) == 0;
  Circles circles;
  for (std::size_t i = 0; i < count; ++i) {
    double u = random.unit();
    double v = random.unit();
    if (isOnGrid) {
      u = std::floor(u * steps) / 8;
      v = std::floor(v * steps) / 8;
    }
    if (isSpread) {
      u += static_cast<double>(random.below(7)) - 3;
      v += static_cast<double>(random.below(7)) - 3;
    }
    double r = base;
    if (sizes == 1) r = random.uniform(0, base);
    if (sizes == 2) r = base + random.uniform(0, spacing / 2);
    if (sizes == 3) r = i % 3 == 0 ? base + spacing / 2 : base;
    if (sizes == 4) r = i == 0 ? base + random.uniform(0, 2) : base;
    if (isOnGrid) r = std::floor(r * 8) / 8;
    circles.push_back({onGrid(u * nice.a.x + v * nice.b.x), onGrid(u * nice.a.y + v * nice.b.y), r});
  }
  return circles;
}

/// The cells in the middle of the diagram of a block of copies, all of whose coordinates are exact.
class Block {
 public:
  Block(const PeriodicDiagram& periodic, const RandomLattice& lattice) : count_(at(periodic.circleCount)) {
    const auto& [a, b] = lattice.nice;
    const auto& given = periodic.diagram.circles;
    Circles circles(given.begin(), given.begin() + periodic.circleCount);
    // A block of 7 by 7 boxes, longer where one period is shorter, around circles that are spread over two.
    const auto reach = [](const Vector& u, const Vector& v) {
      const double ratio = std::sqrt((u.x * u.x + u.y * u.y) / (v.x * v.x + v.y * v.y));
      return static_cast<std::int32_t>(std::ceil(3 * std::max(1.0, ratio)));
    };
    for (std::size_t i = 0; i < count_; ++i) images_.emplace_back(i, 0, 0);
    for (std::size_t i = 0; i < count_; ++i) {
      for (std::int32_t k = -reach(b, a); k <= reach(b, a); ++k) {
        for (std::int32_t l = -reach(a, b); l <= reach(a, b); ++l) {
          if (k == 0 && l == 0) continue;
          circles.push_back({given[i].x + k * a.x + l * b.x, given[i].y + k * a.y + l * b.y, given[i].r});
          images_.emplace_back(i, k, l);
        }
      }
    }
    diagram_ = compute(circles, withWeights(periodic.diagram.weights, periodic.diagram.metric)).value();
  }

  Neighbors neighborsOf(CircleIndex circle) const {
    Neighbors result;
    for (const CircleIndex other : neighbors(diagram_, circle)) result.push_back(images_[at(other)]);
    return rotated(std::move(result));
  }

  std::map<std::int32_t, double> hiders() const {
    std::map<std::int32_t, double> result;
    for (const auto& [circle, by] : diagram_.hidden) {
      if (at(circle) < count_) result[circle] = diagram_.circles[at(by)].r;
    }
    return result;
  }

  const Diagram& diagram() const { return diagram_; }

 private:
  std::size_t count_;
  Neighbors images_;
  Diagram diagram_;
};

/// Converts shifts from the given basis to the nice basis.
Neighbors inNiceBasis(const Neighbors& neighbors, const BasisChange& m) {
  Neighbors result;
  for (const auto& [j, k, l] : neighbors) result.emplace_back(j, k * m[0] + l * m[2], k * m[1] + l * m[3]);
  return rotated(std::move(result));
}

std::map<std::int32_t, double> hidersOf(const PeriodicDiagram& periodic) {
  std::map<std::int32_t, double> result;
  for (const auto& [circle, by] : periodic.diagram.hidden) {
    if (circle < periodic.circleCount) result[circle] = periodic.diagram.circles[at(by)].r;
  }
  return result;
}

double sumOfAreas(const PeriodicDiagram& periodic) {
  double sum = 0;
  for (CircleIndex i = 0; i < periodic.circleCount; ++i) sum += cellArea(periodic.diagram, i);
  return sum;
}

int trials() {
  const char* value = std::getenv("CIRCLE_VORONOI_PERIODIC_TRIALS");
  return value == nullptr ? 40 : std::atoi(value);
}

/// A circle without a power cell has several circles beside it, any of which may be named.
void expectSameHiders(const std::map<std::int32_t, double>& a, const std::map<std::int32_t, double>& b, Metric metric) {
  if (metric == Metric::power)
    EXPECT_TRUE(std::ranges::equal(std::views::keys(a), std::views::keys(b)));
  else
    EXPECT_EQ(a, b);
}

void expectCellsOfABlock(Metric metric) {
  Random random(test::seedOr(46));
  for (int trial = 0; trial < trials(); ++trial) {
    const RandomLattice lattice = randomLattice(random, 20);
    Circles circles = randomCircles(random, lattice.nice, random.below(3) == 0);
    const bool hasWeights = random.below(4) == 0;
    if (hasWeights && metric == Metric::power) {
      for (Circle& c : circles) c.r = onGrid((random.below(2) == 0 ? 1 : -1) * c.r);
    }
    SCOPED_TRACE("trial " + std::to_string(trial) + "\n" + test::describe(circles));
    const PeriodicDiagram periodic = computePeriodic(circles, lattice.given(), withWeights(hasWeights, metric)).value();
    ASSERT_EQ(periodic.lattice, lattice.given());
    const Block block(periodic, lattice);
    expectSameHiders(hidersOf(periodic), block.hiders(), metric);
    for (CircleIndex i = 0; i < periodic.circleCount; ++i) {
      ASSERT_EQ(inNiceBasis(placedNeighborsOf(periodic, i), lattice.change), block.neighborsOf(i)) << i;
      const double scale = test::boxArea(lattice.nice);
      EXPECT_NEAR(cellArea(periodic.diagram, i), cellArea(block.diagram(), i), 1e-10 * scale) << i;
    }
    EXPECT_NEAR(sumOfAreas(periodic) / test::boxArea(lattice.nice), 1, 1e-12);
  }
}

TEST(Periodic, CellsAreThoseInTheMiddleOfABlockOfImages) { expectCellsOfABlock(Metric::circles); }
TEST(Periodic, PowerCellsAreThoseInTheMiddleOfABlockOfImages) { expectCellsOfABlock(Metric::power); }
TEST(Periodic, CellsOfCentersAreThoseInTheMiddleOfABlockOfImages) { expectCellsOfABlock(Metric::centers); }

/// Expects that the cells of the given circles have equal areas and fill the box.
void expectWhole(const Circles& circles, const Lattice& lattice, Metric metric) {
  SCOPED_TRACE(test::describe(circles));
  const PeriodicDiagram periodic = computePeriodic(circles, lattice, withWeights(false, metric)).value();
  EXPECT_TRUE(checkPeriodic(periodic));
  EXPECT_NEAR(sumOfAreas(periodic) / test::boxArea(periodic.lattice), 1, 1e-12);
  for (CircleIndex i = 0; i < periodic.circleCount; ++i) {
    EXPECT_EQ(periodic.circleOf[at(i)], i);
    EXPECT_NEAR(cellArea(periodic.diagram, i) / test::boxArea(periodic.lattice), 1.0 / periodic.circleCount, 1e-12);
  }
}

TEST(Periodic, LatticesOfTangentCirclesHaveEqualCells) {
  for (const Metric metric : {Metric::circles, Metric::power, Metric::centers}) {
    for (const double side : {1.0, 0.1, 3e-17, 7e26}) {
      const Lattice square = {{side, 0}, {0, side}};
      const Lattice hexagonal = {{side, 0}, {side / 2, std::sqrt(3) / 2 * side}};
      const Lattice rectangle = {{side, 0}, {0, std::sqrt(3) * side}};
      for (const double r : {0.0, 0.5 * side, 0.9 * side, 30 * side}) {
        const double half = 0.5 * side;
        expectWhole({{0.2 * side, 0.7 * side, r}}, square, metric);
        expectWhole({{0, 0, r}, {half, half, r}}, square, metric);
        expectWhole({{0, 0, r / 2}, {half, 0, r / 2}, {0, half, r / 2}, {half, half, r / 2}}, square, metric);
        expectWhole({{0, 0, r}}, hexagonal, metric);
        expectWhole({{0, 0, r}, {side / 2, std::sqrt(3) / 2 * side, r}}, rectangle, metric);
      }
    }
  }
}

TEST(Periodic, OneCircleIsItsOnlyNeighbor) {
  const PeriodicDiagram periodic = computePeriodic(Circles{{3, 4, 1}}, {{2, 0}, {1, 1.8}}).value();
  const Neighbors expected = {{0, -1, 0}, {0, 0, -1}, {0, 1, -1}, {0, 1, 0}, {0, 0, 1}, {0, -1, 1}};
  EXPECT_EQ(neighborsOf(periodic, 0), rotated(expected));
}

void expectSameWhereverTheyAre(Metric metric) {
  Random random(test::seedOr(47));
  for (int trial = 0; trial < trials() / 2; ++trial) {
    const RandomLattice lattice = randomLattice(random, 20);
    const Circles circles = randomCircles(random, lattice.nice, true);
    const auto& [a, b] = lattice.nice;
    const double u = std::floor(random.uniform(-64, 64)) / 16;
    const double v = std::floor(random.uniform(-64, 64)) / 16;
    Circles moved = circles;
    for (Circle& c : moved) c = {c.x + u * a.x + v * b.x, c.y + u * a.y + v * b.y, c.r};
    SCOPED_TRACE("trial " + std::to_string(trial) + "\n" + test::describe(circles));
    const Options options = withWeights(false, metric);
    const PeriodicDiagram first = computePeriodic(circles, lattice.nice, options).value();
    const PeriodicDiagram second = computePeriodic(moved, lattice.nice, options).value();
    const PeriodicDiagram third = computePeriodic(circles, lattice.given(), options).value();
    for (CircleIndex i = 0; i < first.circleCount; ++i) {
      ASSERT_EQ(neighborsOf(first, i), neighborsOf(second, i)) << i;
      ASSERT_EQ(neighborsOf(first, i), inNiceBasis(neighborsOf(third, i), lattice.change)) << i;
    }
    expectSameHiders(hidersOf(first), hidersOf(second), metric);
    expectSameHiders(hidersOf(first), hidersOf(third), metric);
  }
}

TEST(Periodic, MovingAllCirclesByAFractionOfAPeriodChangesNoNeighbors) {
  expectSameWhereverTheyAre(Metric::circles);
  expectSameWhereverTheyAre(Metric::power);
}

TEST(Periodic, PeriodsMayDifferAThousandfoldAndBeStronglySheared) {
  Random random(test::seedOr(48));
  for (int trial = 0; trial < trials() / 2; ++trial) {
    const double ratio = random.logUniform(0, 3);
    const Lattice nice = {{1, 0}, {random.uniform(-0.5, 0.5), ratio}};
    const double shear = std::round(random.logUniform(0, 5));
    const Lattice lattice = random.below(2) == 0 ? nice : Lattice{{1, 0}, {nice.b.x + shear, ratio}};
    Circles circles;
    const double size = random.below(2) == 0 ? 0 : random.logUniform(-2, 3);
    for (std::size_t count = 1 + random.below(50); count > 0; --count) {
      const double u = random.unit();
      const double v = random.unit();
      circles.push_back({u * lattice.a.x + v * lattice.b.x, v * lattice.b.y, size * random.uniform(0.9, 1)});
    }
    SCOPED_TRACE("trial " + std::to_string(trial) + "\n" + test::describe(circles));
    const PeriodicDiagram periodic = computePeriodic(circles, lattice).value();
    EXPECT_NEAR(sumOfAreas(periodic) / ratio, 1, 1e-12 * std::max(1.0, shear / 100));
    // Circles keep their places as seen from the given ones.
    for (std::size_t i = 0; i < circles.size(); ++i) {
      const auto [k, l] = periodic.shiftOf[i];
      const auto& [a, b] = periodic.lattice;
      EXPECT_NEAR(periodic.diagram.circles[i].x, circles[i].x + k * a.x + l * b.x, 1e-8);
      EXPECT_NEAR(periodic.diagram.circles[i].y, circles[i].y + k * a.y + l * b.y, 1e-8);
    }
  }
}

TEST(Periodic, CirclesInTheBoxStayWhereTheyAre) {
  Random random(test::seedOr(49));
  const Lattice lattice = {{1, 0}, {0.5, 1}};  // the box of Lees and Edwards, whose circles lie in a rectangle
  Circles circles;
  for (int i = 0; i < 50; ++i) circles.push_back({onGrid(random.unit()), onGrid(random.unit()), 0.01});
  const PeriodicDiagram periodic = computePeriodic(circles, lattice).value();
  for (std::size_t i = 0; i < circles.size(); ++i) {
    EXPECT_EQ(periodic.diagram.circles[i], circles[i]);
    EXPECT_EQ(periodic.shiftOf[i], (Shift{0, 0}));
  }
}

TEST(Periodic, AnImageMayHideACircle) {
  // Circle 0 reaches across the side of the box.
  const PeriodicDiagram periodic =
      computePeriodic(Circles{{0.05, 0.5, 0.3}, {0.95, 0.5, 0.1}}, {{1, 0}, {0, 1}}).value();
  ASSERT_FALSE(periodic.diagram.hasCell(1));
  ASSERT_EQ(periodic.diagram.hidden.front().circle, 1);
  const auto [hider, shift] = periodic.imageFrom(1, periodic.diagram.hidden.front().by);
  EXPECT_EQ(hider, 0);
  EXPECT_EQ(shift, (Shift{1, 0}));
}

TEST(Periodic, OfCirclesAtOnePlaceTheFirstIsVisible) {
  // Four points at the corners of the box, which are one point, and two equal points inside.
  for (const Circles& corners : {Circles{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.5, 0.5, 0}},
                                 Circles{{1, 1, 0.5}, {1, 0, 0.5}, {0, 1, 0.5}, {0, 0, 0.5}, {0.5, 0.5, 0.5}}}) {
    const PeriodicDiagram periodic = computePeriodic(corners, {{1, 0}, {0, 1}}).value();
    EXPECT_TRUE(periodic.diagram.hasCell(0));
    for (const CircleIndex i : {1, 2, 3}) EXPECT_FALSE(periodic.diagram.hasCell(i));
    EXPECT_NEAR(cellArea(periodic.diagram, 0), 0.5, 1e-12);
  }
}

TEST(Periodic, CirclesMayBeLargerThanTheBox) {
  Random random(test::seedOr(50));
  Circles circles;
  for (int i = 0; i < 30; ++i) circles.push_back({random.unit(), random.unit(), 0.05 * random.unit()});
  Circles larger = circles;
  for (Circle& c : larger) c.r += 1000;
  const PeriodicDiagram first = computePeriodic(circles, {{1, 0}, {0, 1}}).value();
  const PeriodicDiagram second = computePeriodic(larger, {{1, 0}, {0, 1}}).value();
  for (CircleIndex i = 0; i < 30; ++i) EXPECT_EQ(neighborsOf(first, i), neighborsOf(second, i)) << i;
}

TEST(Periodic, NoCirclesAreAnEmptyDiagram) {
  const PeriodicDiagram periodic = computePeriodic({}, {{1, 0}, {0, 1}}).value();
  EXPECT_EQ(periodic.circleCount, 0);
  EXPECT_TRUE(checkPeriodic(periodic));
}

TEST(Periodic, PeriodsThatSpanNoBoxAreAnError) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Lattice& lattice :
       {Lattice{{0, 0}, {0, 1}}, Lattice{{1, 2}, {2, 4}}, Lattice{{1, 0}, {-3, 0}}, Lattice{{1, 0}, {0, 0}},
        Lattice{{nan, 0}, {0, 1}}, Lattice{{1, 0}, {0, kInfinite}}, Lattice{{1, 0}, {0, 1e29}},
        Lattice{{0.1, 0.3}, {0.7, 2.1}}, Lattice{{1, 0}, {1e20, 1}}}) {
    for (const Circles& circles : {Circles{}, Circles{{0.5, 0.5, 0.1}}}) {
      const auto computed = computePeriodic(circles, lattice);
      ASSERT_FALSE(computed);
      EXPECT_EQ(computed.error().code, ErrorCode::badOption);
    }
  }
}

TEST(Periodic, BoxesThatAreTooSmallAreAnError) {
  const auto computed = computePeriodic(Circles{{0, 0, 0}}, {{1e-20, 0}, {0, 1e-20}});
  ASSERT_FALSE(computed);
  EXPECT_EQ(computed.error().code, ErrorCode::coordinateTooSmall);
}

TEST(Periodic, ErrorsNameTheGivenCircle) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto invalid = computePeriodic(Circles{{0, 0, 1}, {nan, 0, 1}}, {});
  ASSERT_FALSE(invalid);
  EXPECT_EQ(invalid.error().code, ErrorCode::nonFinite);
  EXPECT_EQ(invalid.error().circle, 1);
  const auto far = computePeriodic(Circles{{3.7e28, 0, 1}, {0, 0, 1}}, {{7.5e28, 0}, {0, 7.5e28}});
  ASSERT_FALSE(far);
  EXPECT_EQ(far.error().code, ErrorCode::coordinateTooLarge);
  EXPECT_NE(far.error().circle, kNone);
  const auto oblique = computePeriodic(Circles{{0.1, 0.1, 0}, {5e9, 0.5, 0}}, {{1, 0}, {1e10, 1}});
  ASSERT_FALSE(oblique);
  EXPECT_EQ(oblique.error().code, ErrorCode::badOption);
}

TEST(Periodic, ExceptionsOfCallbacksPassThrough) {
  Options options;
  options.progress = [](Stage, double) { throw std::out_of_range("mine"); };
  EXPECT_THROW((void)computePeriodic(Circles{{0, 0, 1}}, {}, options), std::out_of_range);
  Options observed;
  observed.observer = [](const TraceEvent&) { throw std::out_of_range("mine"); };
  EXPECT_THROW((void)computePeriodic(Circles{{0, 0, 1}, {0.5, 0.5, 0.2}}, {}, observed), std::out_of_range);
}

/// The smallest distance of p from an image of a circle, by trying shifts around a guess.
double distanceTo(const PeriodicDiagram& periodic, const RandomLattice& lattice, CircleIndex circle, Point p) {
  const auto& [a, b] = lattice.nice;
  const Circle& c = periodic.diagram.circles[at(circle)];
  const double turn = a.x * b.y - a.y * b.x;
  const double u = std::round(((p.x - c.x) * b.y - (p.y - c.y) * b.x) / turn);
  const double v = std::round((a.x * (p.y - c.y) - a.y * (p.x - c.x)) / turn);
  double best = std::numeric_limits<double>::infinity();
  for (double k = u - 5; k <= u + 5; ++k) {
    for (double l = v - 5; l <= v + 5; ++l) {
      best = std::min(best, std::hypot(p.x - c.x - k * a.x - l * b.x, p.y - c.y - k * a.y - l * b.y) - c.r);
    }
  }
  return best;
}

double leastDistance(const PeriodicDiagram& periodic, const RandomLattice& lattice, Point p) {
  double best = std::numeric_limits<double>::infinity();
  for (CircleIndex i = 0; i < periodic.circleCount; ++i) best = std::min(best, distanceTo(periodic, lattice, i, p));
  return best;
}

TEST(Periodic, TheFinderKnowsTheNearestImageOfAnyPoint) {
  Random random(test::seedOr(52));
  for (int trial = 0; trial < 20; ++trial) {
    const RandomLattice lattice = randomLattice(random, 4);
    const Circles circles = randomCircles(random, lattice.nice, false);
    SCOPED_TRACE("trial " + std::to_string(trial) + "\n" + test::describe(circles));
    const PeriodicDiagram periodic = computePeriodic(circles, lattice.given()).value();
    const PeriodicFinder finder(periodic);
    for (int i = 0; i < 20; ++i) {
      const double reach = random.below(2) == 0 ? 2 : 1000;
      const Point p = {random.uniform(-reach, reach), random.uniform(-reach, reach)};
      const auto [found, shift] = finder.find(p).value();
      ASSERT_NE(found, kNone);
      // The shift counts from where the circle was given.
      const auto& [a, b] = periodic.lattice;
      const Circle& c = circles[at(found)];
      const double distance =
          std::hypot(p.x - c.x - shift[0] * a.x - shift[1] * b.x, p.y - c.y - shift[0] * a.y - shift[1] * b.y) - c.r;
      EXPECT_NEAR(distance, leastDistance(periodic, lattice, p), 1e-9);
    }
  }
  const PeriodicDiagram empty = *computePeriodic({}, {});
  EXPECT_EQ(PeriodicFinder(empty).find({0, 0}).value().circle, kNone);
}

TEST(Periodic, TheFinderRefusesPointsTooManyPeriodsAway) {
  // Long and short given periods of a lattice whose shortest periods are 1.
  for (const Lattice& lattice : {Lattice{{1, 0}, {0, 1}}, Lattice{{1, 0}, {1000, 1}}}) {
    const PeriodicDiagram periodic = computePeriodic(Circles{{0.25, 0.25, 0.1}, {0.75, 0.75, 0.1}}, lattice).value();
    const PeriodicFinder finder(periodic);
    const auto far = finder.find({0x1p30 - 0.75, 0.25});
    ASSERT_TRUE(far);
    EXPECT_EQ(far.value(), (CircleImage{0, {(1 << 30) - 1, 0}}));
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    for (const Point p : {Point{0x1p30 + 0.25, 0.25}, Point{-0x1p30 + 0.25, 0.25}, Point{0.25, 0x1p31}, Point{1e300, 0},
                          Point{0x1p32 + 0.25, 0.25}, Point{kInfinite, 0}, Point{0, std::nan("")}}) {
      const auto found = finder.find(p);
      ASSERT_FALSE(found) << p.x << ", " << p.y;
      EXPECT_EQ(found.error().code, ErrorCode::badInput);
    }
  }
}

TEST(Periodic, TheContactTableOfASquareLattice) {
  // Discs of radius 0.4 at the corners of unit squares. The box has two discs.
  const PeriodicDiagram periodic = computePeriodic(Circles{{0, 0, 0.4}, {1, 0, 0.4}}, {{2, 0}, {0, 1}}).value();
  const ContactTable table = contactTable(periodic);
  ASSERT_EQ(table.areas.size(), 2u);
  for (const CircleIndex i : {0, 1}) {
    EXPECT_NEAR(table.areas[at(i)], 1, 1e-12);
    EXPECT_NEAR(table.packingFractions[at(i)], std::numbers::pi * 0.16, 1e-12);
    double length = 0;
    std::map<std::tuple<int, int, int>, double> gaps;
    for (const Contact& contact : table.contacts) {
      if (contact.circle != i) continue;
      length += contact.length;
      if (contact.length > 0.5) {
        EXPECT_NEAR(contact.gap, 0.2, 1e-12);
        gaps[{contact.neighbor.circle, contact.neighbor.shift[0], contact.neighbor.shift[1]}] = contact.gap;
      }
    }
    EXPECT_NEAR(length, 4, 1e-12);
    const int side = i == 0 ? -1 : 1;
    EXPECT_TRUE(gaps.contains({i, 0, 1}) && gaps.contains({i, 0, -1}) && gaps.contains({1 - i, 0, 0}) &&
                gaps.contains({1 - i, side, 0}));
    EXPECT_EQ(gaps.size(), 4u);
  }
}

TEST(Periodic, TheContactTableHasEachContactTwiceAndSharesUpToOne) {
  Random random(test::seedOr(53));
  for (int trial = 0; trial < 20; ++trial) {
    const RandomLattice lattice = randomLattice(random, 4);
    const Circles circles = randomCircles(random, lattice.nice, trial % 3 == 0);
    SCOPED_TRACE("trial " + std::to_string(trial) + "\n" + test::describe(circles));
    const PeriodicDiagram periodic = computePeriodic(circles, lattice.given()).value();
    const ContactTable table = contactTable(periodic);
    using Key = std::tuple<int, int, int, int>;
    std::map<Key, const Contact*> contacts;
    for (const Contact& contact : table.contacts) {
      const auto& [j, shift] = contact.neighbor;
      EXPECT_TRUE(contacts.emplace(Key{contact.circle, j, shift[0], shift[1]}, &contact).second);
    }
    for (const auto& [key, contact] : contacts) {
      const auto& [i, j, k, l] = key;
      const auto twin = contacts.find({j, i, -k, -l});
      ASSERT_NE(twin, contacts.end());
      EXPECT_NEAR(twin->second->length, contact->length, 1e-9);
      EXPECT_NEAR(twin->second->gap, contact->gap, 1e-9);
    }
    double covered = 0;
    for (std::size_t i = 0; i < circles.size(); ++i) {
      EXPECT_GE(table.packingFractions[i], 0);
      EXPECT_LE(table.packingFractions[i], 1);
      covered += table.packingFractions[i] * table.areas[i];
    }
    EXPECT_NEAR(std::accumulate(table.areas.begin(), table.areas.end(), 0.0) / test::boxArea(lattice.nice), 1, 1e-12);
    // Against the share of random points that lie in a circle.
    int hits = 0;
    constexpr int kPoints = 400;
    for (int n = 0; n < kPoints; ++n) {
      const auto& [a, b] = lattice.nice;
      const double u = random.unit();
      const double v = random.unit();
      const Point p = {u * a.x + v * b.x, u * a.y + v * b.y};
      hits += leastDistance(periodic, lattice, p) < 0 ? 1 : 0;
    }
    EXPECT_NEAR(covered / test::boxArea(lattice.nice), static_cast<double>(hits) / kPoints, 0.12);
  }
}

/// Images of 13 circles, one of which is hidden.
PeriodicDiagram someImages(Metric metric) {
  Random random(51);
  Circles circles;
  for (int i = 0; i < 12; ++i) circles.push_back({random.unit(), random.unit(), 0.05 * random.unit()});
  circles.push_back({circles[0].x, circles[0].y, 0});
  circles[0].r = 0.05;
  return *computePeriodic(circles, {{1, 0}, {0.2, 1}}, withWeights(false, metric));
}

using Corruption = std::pair<const char*, std::function<void(PeriodicDiagram&)>>;

void expectRefused(const std::vector<Corruption>& corruptions, ErrorCode code) {
  for (const Metric metric : {Metric::circles, Metric::power}) {
    SCOPED_TRACE(metricName(metric));
    const PeriodicDiagram whole = someImages(metric);
    ASSERT_TRUE(checkPeriodic(whole));
    for (const auto& [what, corrupt] : corruptions) {
      SCOPED_TRACE(what);
      PeriodicDiagram periodic = whole;
      corrupt(periodic);
      const auto checked = checkPeriodic(periodic);
      ASSERT_FALSE(checked);
      EXPECT_EQ(checked.error().code, code) << checked.error().message;
    }
  }
}

/// The first edge of the cell of circle 0.
EdgeIndex firstEdge(const PeriodicDiagram& p) { return Diagram::edgeOf(p.diagram.sides(0).front()); }

TEST(CheckPeriodic, RefusesEachCorruption) {
  const auto withAnotherNeighbor = [](PeriodicDiagram& p) {
    Edge& edge = p.diagram.edges[at(firstEdge(p))];
    CircleIndex& other = edge.left == 0 ? edge.right : edge.left;
    other = other == 1 ? 2 : 1;
  };
  const auto withAnotherShift = [](PeriodicDiagram& p) {
    // All images of one circle, so that borders have twins: where the circles lie tells.
    for (std::size_t m = at(p.circleCount); m < p.circleOf.size(); ++m) {
      if (p.circleOf[m] == 3) p.shiftOf[m][0] += 1;
    }
  };
  const auto withAVertexElsewhere = [](PeriodicDiagram& p) {
    // One beside a given cell and an image: its own image, where the areas would make up for it, stays.
    const auto isGiven = [&](CircleIndex i) { return i < p.circleCount; };
    const auto isAcross = [&](const auto& triple) {
      return std::ranges::any_of(triple, isGiven) && !std::ranges::all_of(triple, isGiven);
    };
    const auto& triples = p.diagram.vertexCircles;
    const auto found = std::ranges::find_if(triples, isAcross);
    ASSERT_NE(found, triples.end());
    p.diagram.vertices[static_cast<std::size_t>(found - triples.begin())].x += 0.01;
  };
  const auto withAVertexOfOtherCircles = [](PeriodicDiagram& p) {
    auto& triple = p.diagram.vertexCircles[at(p.diagram.originOf(p.diagram.sides(0).front()))];
    std::swap(triple[0], triple[1]);
  };
  expectRefused(
      {{"a border with another neighbor", withAnotherNeighbor},
       {"a missing border", [](auto& p) { p.diagram.edges.erase(p.diagram.edges.begin() + firstEdge(p)); }},
       {"a border without an end", [](auto& p) { p.diagram.edges[at(firstEdge(p))].end = kNone; }},
       {"a shift of another image", withAnotherShift},
       {"another period", [](auto& p) { p.lattice.b.y += 0.001; }},
       {"another radius", [](auto& p) { p.diagram.circles.back().r += 0.001; }},
       {"a vertex of other circles", withAVertexOfOtherCircles},
       {"a vertex elsewhere", withAVertexElsewhere},
       {"a hidden circle that hides", [](auto& p) { p.diagram.hidden.front().by = p.diagram.hidden.front().circle; }},
       {"a hidden circle too few", [](auto& p) { p.diagram.hidden.clear(); }}},
      ErrorCode::notCertified);
}

TEST(CheckPeriodic, RefusesIndicesOutOfRange) {
  expectRefused({{"no circle", [](auto& p) { p.circleOf.pop_back(); }},
                 {"no shift", [](auto& p) { p.shiftOf.pop_back(); }},
                 {"an image of an image", [](auto& p) { p.circleOf.back() = p.circleCount; }},
                 {"a given circle of another", [](auto& p) { p.circleOf.front() = 1; }},
                 {"more given circles", [](auto& p) { p.circleCount = 1'000'000; }},
                 {"left", [](auto& p) { p.diagram.edges.back().left = -1; }},
                 {"right", [](auto& p) { p.diagram.edges.back().right = 1'000'000; }},
                 {"start", [](auto& p) { p.diagram.edges.back().start = 1'000'000; }},
                 {"end", [](auto& p) { p.diagram.edges.back().end = -2; }},
                 {"circle of a vertex", [](auto& p) { p.diagram.vertexCircles.back()[2] = 1'000'000; }},
                 {"hidden circle", [](auto& p) { p.diagram.hidden.back().circle = -1; }},
                 {"hider", [](auto& p) { p.diagram.hidden.back().by = 1'000'000; }}},
                ErrorCode::badInput);
}

// The periods are nearly parallel, and their cross product cancels nearly all digits.
TEST(Periodic, StrongShearLeavesTheSumOfTheAreasRight) {
  Random random(61);
  for (const double shear : {1e3, 1e6, 1e8, 1e9}) {
    for (int trial = 0; trial < 20; ++trial) {
      SCOPED_TRACE(std::to_string(shear) + ", trial " + std::to_string(trial));
      const Vector a = directionAt(random.unit());
      const Vector b = {random.uniform(0.5, 2) * -a.y, random.uniform(0.5, 2) * a.x};
      const double times = std::round(shear * random.uniform(0.5, 1));
      const Lattice sheared = {{a.x + times * b.x, a.y + times * b.y}, b};
      Circles circles;
      for (std::size_t i = 0; i <= random.below(6); ++i) circles.push_back({random.unit(), random.unit(), 0.1});
      const PeriodicDiagram periodic = computePeriodic(circles, sheared).value();
      // The rounding of the periods moves the sides of the box.
      EXPECT_NEAR(sumOfAreas(periodic), test::boxArea({a, b}), 8 * shear * 0x1p-50 * shear + 1e-12);
    }
  }
}

}  // namespace
}  // namespace circle_voronoi
