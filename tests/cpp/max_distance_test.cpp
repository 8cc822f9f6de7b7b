// SPDX-License-Identifier: GPL-3.0-or-later
// Cells cut at a maximum distance from their circles, against the union of the grown circles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "circle_voronoi/cells.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/export.h"
#include "circle_voronoi_families/families.h"
#include "diagrams.h"
#include "lines.h"
#include "random.h"
#include "regions.h"
#include "report.h"
#include "rings.h"
#include "tie_inputs.h"

namespace circle_voronoi {
namespace {

using Circles = std::vector<Circle>;
using Loop = std::vector<OutlinePiece>;

constexpr double kPi = std::numbers::pi;

using test::diagramOf;

/// The area of the union of circles grown by a distance, by Green's theorem: of each the arcs that no other covers.
double unionArea(const Circles& given, double more) {
  Circles circles = given;
  for (Circle& c : circles) c.r += more;
  double sum = 0;
  for (std::size_t i = 0; i < circles.size(); ++i) {
    const auto& [x, y, r] = circles[i];
    if (!(r > 0)) continue;
    struct Cover {
      double from;
      double to;
    };
    std::vector<Cover> covers;
    bool isCovered = false;
    const auto cover = [&](double from, double to) {
      if (from < -kPi) {
        covers.push_back({from + 2 * kPi, kPi});
        from = -kPi;
      }
      if (to > kPi) {
        covers.push_back({-kPi, to - 2 * kPi});
        to = kPi;
      }
      covers.push_back({from, to});
    };
    for (std::size_t j = 0; j < circles.size() && !isCovered; ++j) {
      if (j == i || !(circles[j].r > 0)) continue;
      const double dx = circles[j].x - x;
      const double dy = circles[j].y - y;
      const double d = std::hypot(dx, dy);
      const double less = given[i].r - given[j].r;
      if (d >= r + circles[j].r || d <= less) {
        isCovered = d == 0 && less == 0 && j < i;
        continue;
      }
      if (d <= -less) {
        isCovered = true;
        continue;
      }
      const double half = std::acos(std::clamp((d + less / d * (r + circles[j].r)) / (2 * r), -1.0, 1.0));
      const double middle = std::atan2(dy, dx);
      cover(middle - half, middle + half);
    }
    if (isCovered) continue;
    std::ranges::sort(covers, {}, &Cover::from);
    covers.push_back({kPi, kPi});
    double at = -kPi;
    for (const Cover& next : covers) {
      // x dy - y dx along the arc from `at` to where the next cover begins.
      if (next.from > at) {
        sum += r *
               (r * (next.from - at) + x * (std::sin(next.from) - std::sin(at)) -
                y * (std::cos(next.from) - std::cos(at))) /
               2;
      }
      at = std::max(at, next.to);
    }
  }
  return sum;
}

double extentOf(const Circles& circles) {
  double extent = 0;
  for (const Circle& c : circles) {
    extent = std::max({extent, std::abs(c.x - circles[0].x) + c.r, std::abs(c.y - circles[0].y) + c.r});
  }
  return extent;
}

std::int32_t nearestOf(const Diagram& diagram, Point p) {
  std::int32_t nearest = 0;
  for (std::int32_t i = 1; i < static_cast<std::int32_t>(diagram.circles.size()); ++i) {
    if (distanceFrom(diagram, i, p) < distanceFrom(diagram, nearest, p)) nearest = i;
  }
  return nearest;
}

std::vector<Point> pointsOf(const OutlinePiece& piece, double tolerance) {
  if (!piece.isOnCircle()) return polyline(piece.curve, tolerance);
  const Point p = piece.curve.start;
  const Point q = piece.curve.end;
  const double half = std::hypot(q.x - p.x, q.y - p.y) / 2;
  const double toCenter = std::sqrt(std::max(piece.r * piece.r - half * half, 0.0));
  const Point center = {(p.x + q.x) / 2 - toCenter * (q.y - p.y) / (2 * half),
                        (p.y + q.y) / 2 + toCenter * (q.x - p.x) / (2 * half)};
  const double from = std::atan2(p.y - center.y, p.x - center.x);
  const double turn = 2 * std::asin(std::min(half / piece.r, 1.0));
  std::vector<Point> points = {p};
  for (int k = 1; k < 200; ++k) {
    const double angle = from + turn * k / 200;
    points.push_back({center.x + piece.r * std::cos(angle), center.y + piece.r * std::sin(angle)});
  }
  points.push_back(q);
  return points;
}

/// The winding number of a loop around a point.
int windings(const Outline& outline, Point p, double tolerance) {
  int count = 0;
  for (const Loop& loop : outline) {
    for (const OutlinePiece& piece : loop) {
      const auto points = pointsOf(piece, tolerance);
      for (std::size_t k = 1; k < points.size(); ++k) {
        const Point a = points[k - 1];
        const Point b = points[k];
        if ((a.y <= p.y) == (b.y <= p.y)) continue;
        const double side = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
        if ((side > 0) == (b.y > a.y)) count += b.y > a.y ? 1 : -1;
      }
    }
  }
  return count;
}

/// Loops close to the bit, arcs are on their circle, and pieces of sides within the distance.
void expectSound(const Diagram& diagram, std::int32_t circle, const Outline& outline, double maxDistance,
                 double rounding) {
  const Circle& c = diagram.circles[static_cast<std::size_t>(circle)];
  for (const Loop& loop : outline) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const OutlinePiece& piece = loop[k];
      ASSERT_EQ(piece.curve.end, loop[(k + 1) % loop.size()].curve.start) << "cell " << circle << " piece " << k;
      if (piece.isOnCircle()) {
        ASSERT_EQ(piece.r, c.r + maxDistance);
        ASSERT_EQ(piece.side, kNone);
        ASSERT_EQ(piece.neighbor, kNone);
      }
      for (const Point& p : {piece.curve.start, piece.curve.end}) {
        ASSERT_LE(distanceFrom(diagram, circle, p), maxDistance + rounding) << "cell " << circle << " piece " << k;
      }
    }
  }
}

/// Returns the sum of the areas of all cells cut at a distance, and expects that they are sound.
double sumOfAreas(const Diagram& diagram, double d, double rounding) {
  double sum = 0;
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(diagram.circles.size()); ++i) {
    const Outline cut = outlineWithin(diagram, i, d);
    EXPECT_LE(cut.size(), 1U);
    expectSound(diagram, i, cut, d, rounding);
    sum += area(cut);
  }
  return sum;
}

TEST(MaxDistance, OfOneCircleIsADisc) {
  const Circles circles = {{3, 4, 2}};
  const Diagram diagram = diagramOf(circles);
  const Outline disc = outlineWithin(diagram, 0, 1);
  ASSERT_EQ(disc.size(), 1U);
  EXPECT_NEAR(area(disc), 9 * kPi, 1e-14 * 9 * kPi);
  EXPECT_NEAR(perimeter(disc), 6 * kPi, 1e-14 * 6 * kPi);
  EXPECT_NEAR(centroid(disc).x, 3, 1e-15);
  EXPECT_NEAR(centroid(disc).y, 4, 1e-15);
  EXPECT_NEAR(area(outlineWithin(diagram, 0, -1)), kPi, 1e-14);
  EXPECT_TRUE(outlineWithin(diagram, 0, -2).empty());
  EXPECT_TRUE(outlineWithin(diagram, 0, -3).empty());
}

// The circle passes through corners of the region, exactly.
TEST(MaxDistance, ARegionWithItsCornersOnTheCircleIsWhole) {
  const Diagram diagram = diagramOf(Circles{{0, 0, 0}});
  for (const auto& [x, y, reach] : {std::array{3.0, 4.0, 5.0}, std::array{5.0, 12.0, 13.0}, std::array{8.0, 15.0, 17.0},
                                    std::array{7.0, 24.0, 25.0}, std::array{20.0, 21.0, 29.0},
                                    std::array{33.0, 56.0, 65.0}, std::array{16.0, 63.0, 65.0}}) {
    const Outline box = outlineWithin(diagram, 0, test::regionOf(Box{-x, -y, x, y}), reach);
    ASSERT_EQ(box.size(), 1U);
    EXPECT_EQ(box[0].size(), 4U) << reach;
    EXPECT_EQ(area(box), 4 * x * y);
    EXPECT_EQ(perimeter(box), 4 * (x + y));
    const Region triangle = test::regionOf(Region::Ring{{0, 0}, {x, y}, {-y, x}});
    const Outline half = outlineWithin(diagram, 0, triangle, reach);
    ASSERT_EQ(half.size(), 1U);
    const auto isLong = [](const OutlinePiece& piece) { return arcLength(piece.curve) > 1e-13; };
    EXPECT_EQ(std::ranges::count_if(half[0], isLong), 3) << reach;
    EXPECT_NEAR(area(half), reach * reach / 2, 1e-12);
  }
}

TEST(MaxDistance, OfTwoEqualCirclesIsTwoDiscsCutAlongALine) {
  const Circles circles = {{0, 0, 1}, {4, 0, 1}};
  const Diagram diagram = diagramOf(circles);
  const double segment = 9 * std::acos(2 / 3.0) - 2 * std::sqrt(5);
  for (const std::int32_t i : {0, 1}) {
    const Outline apart = outlineWithin(diagram, i, 0.5);
    EXPECT_NEAR(area(apart), 2.25 * kPi, 1e-14 * 8);
    // They touch, in a point of both.
    EXPECT_NEAR(area(outlineWithin(diagram, i, 1)), 4 * kPi, 1e-13);
    const Outline cut = outlineWithin(diagram, i, 2);
    EXPECT_NEAR(area(cut), 9 * kPi - segment, 1e-13);
    EXPECT_NEAR(perimeter(cut), 6 * kPi - 6 * std::acos(2 / 3.0) + 2 * std::sqrt(5), 1e-13);
    EXPECT_EQ(std::ranges::count(cut.at(0), 1 - i, &OutlinePiece::neighbor), 1);
  }
}

TEST(MaxDistance, AreasAddUpToThatOfTheUnionOfTheGrownCircles) {
  const std::uint64_t seed = test::seedOr(1);
  for (const FamilyInfo& family : families()) {
    for (std::uint64_t trial = 0; trial < 4; ++trial) {
      Random random(seed * 1'000'003 + trial);
      const Circles circles = generate(family.family, 1 + random.below(60), random.next());
      SCOPED_TRACE(std::string(family.name) + ", trial " + std::to_string(trial));
      const Diagram diagram = diagramOf(circles);
      const double extent = extentOf(circles);
      const double d = (extent > 0 ? extent : 1) * (trial == 0 ? 0 : random.logUniform(-4, 1));
      // Cells between circles that touch inside but for rounding are narrower than the rounding of their vertices.
      // Arcs that cross at an angle of 1e-8 end within 1e-8 of where they should.
      const double rounding = family.family == Family::nestedTangent ? 1e-7
                              : family.family == Family::barelyOut   ? 1e-6
                                                                     : 1e-8;
      const double sum = sumOfAreas(diagram, d, 1e-7 * (extent + d));
      EXPECT_NEAR(sum, unionArea(circles, d), rounding * (extent + d) * (extent + d)) << d;
      if (HasFailure()) FAIL() << test::describe(circles);
    }
  }
}

TEST(MaxDistance, APointIsInTheOutlineOfItsNearestCircleAlone) {
  const std::uint64_t seed = test::seedOr(1);
  for (const FamilyInfo& family : families()) {
    Random random(seed * 1'000'003 + 7);
    const Circles circles = generate(family.family, 1 + random.below(20), random.next());
    SCOPED_TRACE(std::string(family.name));
    const Diagram diagram = diagramOf(circles);
    const double extent = extentOf(circles) > 0 ? extentOf(circles) : 1;
    const double d = extent * random.logUniform(-2, 0);
    const Box box = {circles[0].x - extent / 2, circles[0].y - extent / 3, circles[0].x + extent / 2,
                     circles[0].y + extent};
    std::vector<Outline> free;
    std::vector<Outline> boxed;
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(circles.size()); ++i) {
      free.push_back(outlineWithin(diagram, i, d));
      boxed.push_back(outlineWithin(diagram, i, test::regionOf(box), d));
    }
    for (int k = 0; k < 60; ++k) {
      // Half of the points lie near the boundary of a grown circle.
      const Circle& c = circles[random.below(circles.size())];
      const double angle = random.uniform(0, 2 * kPi);
      const double reach = k % 2 == 0 ? (c.r + d) * random.uniform(0.9, 1.1) : extent * random.unit();
      const Point p = {c.x + reach * std::cos(angle), c.y + reach * std::sin(angle)};
      const std::int32_t nearest = nearestOf(diagram, p);
      const double margin = 1e-4 * (extent + c.r + d);
      if (std::abs(distanceFrom(diagram, nearest, p) - d) < margin) continue;
      bool isOnBorder = false;
      for (std::int32_t i = 0; i < static_cast<std::int32_t>(circles.size()); ++i) {
        isOnBorder = isOnBorder ||
                     (i != nearest && distanceFrom(diagram, i, p) < distanceFrom(diagram, nearest, p) + 2 * margin);
      }
      if (isOnBorder) continue;
      const bool isNear = distanceFrom(diagram, nearest, p) < d;
      const Region region = test::regionOf(box);
      for (std::int32_t i = 0; i < static_cast<std::int32_t>(circles.size()); ++i) {
        const auto at = static_cast<std::size_t>(i);
        EXPECT_EQ(windings(free[at], p, margin / 10), i == nearest && isNear ? 1 : 0) << i;
        if (std::min({p.x - box.minX, p.y - box.minY, box.maxX - p.x, box.maxY - p.y}) < margin && region.contains(p)) {
          continue;
        }
        EXPECT_EQ(windings(boxed[at], p, margin / 10), i == nearest && isNear && region.contains(p) ? 1 : 0) << i;
      }
    }
    if (HasFailure()) FAIL() << test::describe(circles) << d;
  }
}

// Grids and packings, at distances that end in vertices and where circles touch.
TEST(MaxDistance, OfTiesAddsUpToTheUnion) {
  const std::uint64_t seed = test::seedOr(1);
  for (const test::TieKind& kind : test::tieKinds()) {
    for (std::uint64_t trial = 0; trial < 4; ++trial) {
      Random random(seed * 1'000'003 + trial);
      const Circles circles = kind.make(2 + random.below(40), random);
      SCOPED_TRACE(std::string(kind.name) + ", trial " + std::to_string(trial));
      const Diagram diagram = diagramOf(circles);
      const double extent = extentOf(circles);
      std::vector<double> distances = {0, 0.5, 1, extent};
      for (std::size_t v = 0; v < diagram.vertices.size(); v += 3) distances.push_back(diagram.vertices[v].r);
      for (const double d : distances) {
        if (!(std::abs(d) < 1e6)) continue;
        const double size = extent + std::abs(d);
        EXPECT_NEAR(sumOfAreas(diagram, d, 1e-7 * size), unionArea(circles, d), 1e-7 * size * size) << d;
      }
      if (HasFailure()) FAIL() << test::describe(circles);
    }
  }
}

TEST(MaxDistance, BothSidesOfAnEdgeAreCutInTheSamePoints) {
  const Circles circles = generate(Family::logUniform, 200, 3);
  const Diagram diagram = diagramOf(circles);
  std::size_t cut = 0;
  for (std::int32_t i = 0; i < 200; ++i) {
    for (const Loop& loop : outlineWithin(diagram, i, 0.3)) {
      for (const OutlinePiece& piece : loop) {
        if (piece.side == kNone) continue;
        const Outline across = outlineWithin(diagram, piece.neighbor, 0.3);
        const auto back = std::ranges::find(across.at(0), piece.side ^ 1, &OutlinePiece::side);
        ASSERT_NE(back, across.at(0).end());
        EXPECT_EQ(back->curve.start, piece.curve.end);
        EXPECT_EQ(back->curve.end, piece.curve.start);
        cut += piece.curve.from != sideCurve(diagram, piece.side).from ? 1 : 0;
      }
    }
  }
  EXPECT_GT(cut, 50U);
}

// In the diagram of the centers, a cell is cut at that distance from its center.
TEST(MaxDistance, OfTheCentersIsCutAroundThese) {
  const Circles circles = {{0, 0, 1}, {4, 0, 0.5}};
  const Diagram diagram = compute(circles, {.metric = Metric::centers}).value();
  const double segment = 9 * std::acos(2 / 3.0) - 2 * std::sqrt(5);
  EXPECT_NEAR(area(outlineWithin(diagram, 0, 3)), 9 * kPi - segment, 1e-13);
  EXPECT_NEAR(area(outlineWithin(diagram, 1, 3)), 9 * kPi - segment, 1e-13);
}

// Polygons within the tolerance, one for each cell, and nothing of the diagram beyond the distance.
/// Returns the discs in which the cells of a power diagram are kept.
Circles discsWithin(const Diagram& diagram, double d) {
  Circles discs = diagram.circles;
  for (Circle& c : discs) {
    // Radii and distances may cancel.
    const long double r = c.r;
    const long double more = d;
    c.r = static_cast<double>(std::sqrt(std::max((diagram.weights ? r : r * r) + more * std::abs(more), 0.0L)));
  }
  return discs;
}

/// Expects of a power diagram that cells cut at a distance make up the union of the discs.
void expectUnion(const Diagram& diagram, double d) {
  const Circles discs = discsWithin(diagram, d);
  const double size = extentOf(discs) + 1e-30;
  double sum = 0;
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(discs.size()); ++i) {
    const Outline cut = outlineWithin(diagram, i, d);
    EXPECT_LE(cut.size(), 1U);
    for (const Loop& loop : cut) {
      for (std::size_t k = 0; k < loop.size(); ++k) {
        EXPECT_EQ(loop[k].curve.end, loop[(k + 1) % loop.size()].curve.start) << "cell " << i << " piece " << k;
        const Circle& c = discs[static_cast<std::size_t>(i)];
        if (loop[k].isOnCircle()) {
          EXPECT_NEAR(loop[k].r, c.r, 1e-14 * c.r);
        }
        const Point p = loop[k].curve.start;
        EXPECT_LE(std::hypot(p.x - c.x, p.y - c.y), c.r + 1e-7 * size) << "cell " << i << " piece " << k;
      }
    }
    EXPECT_GE(area(cut), -1e-12 * size * size);
    sum += area(cut);
  }
  EXPECT_NEAR(sum, unionArea(discs, 0), 1e-7 * size * size) << d;
}

TEST(MaxDistance, OfPowerDiagramsAddsUpToTheUnionOfTheDiscs) {
  const std::uint64_t seed = test::seedOr(1);
  for (const FamilyInfo& family : families()) {
    for (std::uint64_t trial = 0; trial < 4; ++trial) {
      Random random(seed * 1'000'003 + trial);
      const Circles circles = generate(family.family, 1 + random.below(60), random.next());
      SCOPED_TRACE(std::string(family.name) + ", trial " + std::to_string(trial));
      const Diagram diagram = compute(circles, {.metric = Metric::power}).value();
      const double extent = extentOf(circles) > 0 ? extentOf(circles) : 1;
      for (const double d : {0.0, extent * random.logUniform(-4, 1), -extent * random.logUniform(-4, 0)}) {
        expectUnion(diagram, d);
      }
      if (HasFailure()) FAIL() << test::describe(circles);
    }
  }
}

// Weights of any sign, whose discs pass through vertices, through which all rims pass, and touch one another.
TEST(MaxDistance, OfTiesInPowerDiagramsAddsUpToTheUnionOfTheDiscs) {
  const std::uint64_t seed = test::seedOr(1);
  for (const test::TieKind& kind : test::tieKinds()) {
    for (std::uint64_t trial = 0; trial < 6; ++trial) {
      Random random(seed * 1'000'003 + trial);
      Circles circles = kind.make(2 + random.below(40), random);
      SCOPED_TRACE(std::string(kind.name) + ", trial " + std::to_string(trial));
      const bool weights = trial % 2 == 1;
      for (Circle& c : circles) c.r = weights ? c.r * (static_cast<double>(random.below(9)) - 4) : c.r;
      const Diagram diagram = compute(circles, {.metric = Metric::power, .weights = weights}).value();
      std::vector<double> distances = {-5, 0, 0.5, 1, 4, extentOf(circles)};
      for (std::size_t v = 0; v < diagram.vertices.size(); v += 3) distances.push_back(diagram.vertices[v].r);
      for (const double d : distances) {
        if (std::abs(d) < 1e6) expectUnion(diagram, d);
      }
      if (HasFailure()) FAIL() << test::describe(circles);
    }
  }
}

// The tangents from a point to a circle are as long as the root of its power.
TEST(MaxDistance, OfAPowerDiagramIsTheLengthOfTangents) {
  const Diagram one = compute(Circles{{3, 4, 5}}, {.metric = Metric::power}).value();
  EXPECT_NEAR(area(outlineWithin(one, 0, 12)), 169 * kPi, 1e-12);
  EXPECT_NEAR(area(outlineWithin(one, 0, -4)), 9 * kPi, 1e-13);
  EXPECT_TRUE(outlineWithin(one, 0, -5).empty());
  const Diagram negative = compute(Circles{{0, 0, -9}, {9, 0, 0}}, {.metric = Metric::power, .weights = true}).value();
  EXPECT_TRUE(outlineWithin(negative, 0, 3).empty());
  EXPECT_NEAR(area(outlineWithin(negative, 0, 5)), 16 * kPi, 1e-13);
}

// A cell without its center: the disc of the inner circle lies outside its cell, touches it, or meets it.
TEST(MaxDistance, OfAPowerDiagramMayLeaveNothingOfACellWithoutItsCenter) {
  const Diagram diagram = compute(Circles{{0, 0, 25}, {1, 0, 4}}, {.metric = Metric::power, .weights = true}).value();
  for (std::int32_t i : {0, 1}) ASSERT_TRUE(diagram.hasCell(i));
  // The bisector is x = 11.
  EXPECT_TRUE(outlineWithin(diagram, 1, 0).empty());
  EXPECT_TRUE(outlineWithin(diagram, 1, std::sqrt(96) - 1e-9).empty());
  EXPECT_FALSE(outlineWithin(diagram, 1, std::sqrt(96) + 1e-9).empty());
  EXPECT_NEAR(area(outlineWithin(diagram, 0, 5)), 50 * kPi, 1e-12);
}

TEST(MaxDistance, OfEqualWeightsIsThatOfTheCenters) {
  const std::uint64_t seed = test::seedOr(1);
  Random random(seed);
  for (int round = 0; round < 20; ++round) {
    Circles circles;
    for (int k = 0; k < 30; ++k) circles.push_back({random.uniform(-9, 9), random.uniform(-9, 9), 1.5});
    const Diagram power = compute(circles, {.metric = Metric::power}).value();
    const Diagram centers = compute(circles, {.metric = Metric::centers}).value();
    for (std::int32_t i = 0; i < 30; ++i) {
      EXPECT_NEAR(area(outlineWithin(power, i, 2)), area(outlineWithin(centers, i, 2.5)), 1e-12) << "seed " << seed;
      EXPECT_NEAR(area(outlineWithin(power, i, -0.9)), area(outlineWithin(centers, i, 1.2)), 1e-12) << "seed " << seed;
    }
  }
}

// Weights may be smaller than their roots, or negative.
TEST(MaxDistance, TheBoxHasRoomForTheDiscsOfAPowerDiagram) {
  const Circles circles = {{0, 0, -9}, {20, 0, 0.25}};
  const Diagram diagram = compute(circles, {.metric = Metric::power, .weights = true}).value();
  for (const double d : {0.0, 5.0, 9.0}) {
    const Box box = exportBox(diagram, d);
    for (const Circle& disc : discsWithin(diagram, d)) {
      EXPECT_LT(box.minX, disc.x - disc.r);
      EXPECT_LT(box.minY, disc.y - disc.r);
      EXPECT_GT(box.maxX, disc.x + disc.r);
      EXPECT_GT(box.maxY, disc.y + disc.r);
    }
  }
}

TEST(MaxDistance, FilesHaveTheCutCells) {
  const Circles circles = generate(Family::intersecting, 60, 2);
  const Diagram diagram = diagramOf(circles);
  const double d = 0.2;
  const double tolerance = 1e-3;
  ExportOptions options;
  options.maxDistance = d;
  options.tolerance = tolerance;
  std::ostringstream geojson;
  EXPECT_TRUE(writeGeoJson(geojson, diagram, options));
  const auto features = nlohmann::json::parse(geojson.str())["features"];
  ASSERT_EQ(features.size(), circles.size());
  for (std::int32_t i = 0; i < 60; ++i) {
    const Circle& c = circles[static_cast<std::size_t>(i)];
    const Outline exact = outlineWithin(diagram, i, test::regionOf(exportBox(circles, d)), d);
    const auto& feature = features[static_cast<std::size_t>(i)];
    EXPECT_NEAR(feature["properties"]["area"].get<double>(), area(exact), 1e-12);
    ASSERT_EQ(feature["geometry"].is_null(), exact.empty()) << i;
    if (exact.empty()) continue;
    const auto& ring = feature["geometry"]["coordinates"][0];
    EXPECT_NEAR(test::areaOf(ring), area(exact), tolerance * perimeter(exact));
    for (const auto& p : ring) {
      EXPECT_LE(std::hypot(p[0].get<double>() - c.x, p[1].get<double>() - c.y), c.r + d + tolerance);
    }
  }
  std::ostringstream obj;
  EXPECT_TRUE(writeObj(obj, diagram, options));
  std::size_t points = 0;
  for (const std::string& line : test::linesOf(obj.str())) {
    if (!line.starts_with("v ")) continue;
    std::istringstream numbers(line.substr(2));
    Point p;
    numbers >> p.x >> p.y;
    EXPECT_LE(distanceFrom(diagram, nearestOf(diagram, p), p), d + tolerance);
    ++points;
  }
  EXPECT_GT(points, 100U);

  std::ostringstream svg;
  EXPECT_TRUE(writeSvg(svg, diagram, options));
  const std::string drawing = svg.str();
  const auto count = [&](const std::string& what) {
    std::size_t found = 0;
    for (std::size_t at = drawing.find(what); at != std::string::npos; at = drawing.find(what, at + 1)) ++found;
    return found;
  };
  EXPECT_GT(count(" 0 0 1 "), 60U);
  const auto isNear = [&](const Vertex& vertex) { return vertex.r <= d; };
  EXPECT_EQ(count("data-vertex="), static_cast<std::size_t>(std::ranges::count_if(diagram.vertices, isNear)));
}

// A coordinate may have few digits left for a circle; between two points that are next to each other there is none.
TEST(MaxDistance, FilesEndWhereCirclesAreHardlySeenFromTheOrigin) {
  ExportOptions options;
  options.maxDistance = 0;
  for (const double radius : {0.3, 1.0, 3.3, 5.0, 40.0, 3000.0}) {
    const Diagram diagram = diagramOf(Circles{{1000000000000000.125, 1000000000000000.125, radius}});
    for (const double tolerance : {1e-9, 1e-5, 1.0}) {
      options.tolerance = tolerance * radius;
      std::ostringstream out;
      EXPECT_TRUE(writeWkt(out, diagram, options));
      // An area that rounding of its points can produce counts as none.
      EXPECT_TRUE(out.str().starts_with(radius > 10 ? "POLYGON ((" : "POLYGON EMPTY")) << radius;
      EXPECT_LT(out.str().size(), 20'000'000U) << radius;
    }
  }
}

// By default the box has room for the whole drawing.
TEST(MaxDistance, TheBoxGrowsWithIt) {
  const Circles circles = {{0, 0, 1}, {9, 0, 0}};
  EXPECT_EQ(exportBox(circles, 1).minX, exportBox(Circles{{0, 0, 2}, {9, 0, 1}}).minX);
  EXPECT_EQ(exportBox(circles, 1).maxX, exportBox(Circles{{0, 0, 2}, {9, 0, 1}}).maxX);
  EXPECT_EQ(exportBox(circles, -0.5).maxY, exportBox(circles).maxY);
  // Also far from the origin, where a twentieth may be less than rounding leaves.
  for (const Circles& far : {Circles{{1e17, 1e17, 0}}, Circles{{1e20, 5, 1}}, Circles{{-1e17, 0, 1}, {-1e17, 9, 2}}}) {
    const Box box = exportBox(far);
    EXPECT_LT(box.minX, far[0].x);
    EXPECT_GT(box.maxX, far[0].x);
    EXPECT_TRUE(Region::from(box).ok());
  }
}

}  // namespace
}  // namespace circle_voronoi
