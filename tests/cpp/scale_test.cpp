// SPDX-License-Identifier: GPL-3.0-or-later
// Circles a power of two times as large have the same diagram and geometry, bit for bit, times that power: from the
// smallest to the largest inputs that `compute` takes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "circle_voronoi/cells.h"
#include "circle_voronoi/clearest_path.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/export.h"
#include "circle_voronoi/finder.h"
#include "circle_voronoi/hull.h"
#include "circle_voronoi/merged.h"
#include "circle_voronoi/queries.h"
#include "circle_voronoi_families/families.h"
#include "regions.h"
#include "rounded.h"

namespace circle_voronoi {
namespace {

/// Numbers with few bits, of which the smallest doubles keep them all.
std::vector<Circle> coarse(std::vector<Circle> circles, double size) {
  const auto round = [&](double x) { return std::nearbyint(x / size * 0x1p12) * 0x1p-12; };
  for (auto& [x, y, r] : circles) {
    x = round(x);
    y = round(y);
    r = round(r);
  }
  return circles;
}

/// Results of the geometry, with their dimension: 0 for a number, 1 for a length, 2 for an area.
struct MeasuresOfCells {
  std::vector<double> numbers;
  std::vector<int> dimensions;

  void add(int dimension, double number) {
    numbers.push_back(number);
    dimensions.push_back(dimension);
  }
  void add(Point p) {
    add(1, p.x);
    add(1, p.y);
  }
  void add(const EmptyDisc& disc) {
    add(Point{disc.disc.x, disc.disc.y});
    add(1, disc.disc.r);
    for (const std::int32_t circle : disc.circles) add(0, circle);
  }
};

void measureCurves(const Diagram& diagram, const Box& box, double tolerance, MeasuresOfCells& all) {
  const Region region = Region::from(box).value();
  const ClippedDiagram clipped = ClippedDiagram::from(diagram, region).value();
  for (std::int32_t e = 0; e < static_cast<std::int32_t>(diagram.edges.size()); ++e) {
    const EdgeCurve curve = edgeCurve(diagram, e);
    all.add(0, curve.from);
    all.add(0, curve.to);
    all.add(pointAt(curve.bisector, 3));
    for (const EdgeCurve& piece : clipped.edgeParts(e)) {
      all.add(piece.start);
      all.add(piece.end);
      all.add(1, arcLength(piece));
      all.add(rationalBezier(piece).control);
      for (const Point& p : polyline(piece, tolerance)) all.add(p);
      for (const CubicBezier& cubic : cubicBeziers(piece, tolerance)) all.add(cubic.control1);
    }
  }
}

void measureCells(const Diagram& diagram, const Box& box, MeasuresOfCells& all) {
  const Finder finder(diagram);
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(diagram.circles.size()); ++i) {
    const Outline parts = outline(diagram, i, test::regionOf(box));
    for (const auto& loop : parts) {
      for (const OutlinePiece& piece : loop) all.add(piece.curve.start);
    }
    all.add(2, area(parts));
    all.add(1, perimeter(parts));
    all.add(centroid(parts));
    for (const double share : {0.1, 0.4, 0.45, 0.8}) {
      const Point p = {box.minX + share * (box.maxX - box.minX), box.minY + share * share * (box.maxY - box.minY)};
      all.add(0, contains(diagram, i, p));
      all.add(0, finder.find(p, i));
    }
  }
}

void measureQueries(const Diagram& diagram, const Box& box, MeasuresOfCells& all) {
  const auto& circles = diagram.circles;
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(circles.size()); ++i) {
    const Outline disc = outlineWithin(diagram, i, (box.maxX - box.minX) / 8);
    all.add(2, area(disc));
    all.add(1, perimeter(disc));
    all.add(centroid(disc));
  }
  const Hull outer = convexHull(diagram);
  all.add(1, outer.length);
  all.add(2, outer.area);
  for (const HullArc& arc : outer.arcs) {
    all.add(arc.start);
    all.add(0, arc.angle);
  }
  if (const auto pair = closestPair(diagram)) all.add(1, pair->gap);
  all.add(*largestEmptyDiscCenteredIn(diagram, test::regionOf(box)));
  all.add(*largestEmptyDiscCenteredInHull(diagram));
  all.add(**largestEmptyDiscInside(diagram, test::regionOf(box)));
  const ClearestPath path = clearestPath(diagram, {box.minX, box.minY}, {box.maxX, box.maxY / 2});
  all.add(1, path.clearance);
  for (const std::int32_t edge : path.edges) all.add(0, edge);
  if (path.entry) all.add(*path.entry);
  const MergedDiagram merged = mergeVertices(diagram);
  for (const Edge& edge : merged.edges) all.add(0, edge.start);
  const Box around = exportBox(circles);
  all.add(Point{around.minX, around.maxY});
}

MeasuresOfCells measure(const std::vector<Circle>& circles, Metric metric, const Box& box, double scale) {
  const Diagram diagram = compute(circles, {.metric = metric}).value();
  MeasuresOfCells all;
  measureCurves(diagram, box, 1e-4 * scale, all);
  measureCells(diagram, box, all);
  if (metric == Metric::circles) measureQueries(diagram, box, all);
  return all;
}

class Scale : public testing::TestWithParam<int> {};

TEST_P(Scale, GeometryIsTheSameAtEverySize) {
  const int exponent = GetParam();
  const double scale = std::ldexp(1.0, exponent);
  for (const Family family : {Family::uniform, Family::intersecting, Family::hidden, Family::oneHuge, Family::rows,
                              Family::gridTangent, Family::collinear, Family::logUniform}) {
    SCOPED_TRACE(familyName(family));
    const auto some = generate(family, 20, 3);
    double size = 0;
    for (const auto& [x, y, r] : some) size = std::max({size, std::abs(x), std::abs(y), r});
    const auto circles = coarse(some, size);
    const Box box = {-0.25, -0.5, 1, 0.75};
    auto scaled = circles;
    for (auto& [x, y, r] : scaled) {
      x *= scale;
      y *= scale;
      r *= scale;
    }
    const Box scaledBox = {box.minX * scale, box.minY * scale, box.maxX * scale, box.maxY * scale};
    for (const Metric metric : {Metric::circles, Metric::centers, Metric::power}) {
      SCOPED_TRACE(static_cast<int>(metric));
      const MeasuresOfCells expected = measure(circles, metric, box, 1);
      const MeasuresOfCells found = measure(scaled, metric, scaledBox, scale);
      ASSERT_EQ(found.numbers.size(), expected.numbers.size());
      for (std::size_t k = 0; k < found.numbers.size(); ++k) {
        ASSERT_TRUE(std::isfinite(expected.numbers[k]) || expected.dimensions[k] == 0);
        ASSERT_EQ(found.numbers[k], std::ldexp(expected.numbers[k], exponent * expected.dimensions[k]))
            << k << " of dimension " << expected.dimensions[k];
      }
    }
  }
}

// The largest number is 1, so that it is at the limits of inputs.
INSTANTIATE_TEST_SUITE_P(Exponents, Scale, testing::Values(-56, -30, 30, 60, 96));

/// At this scale numbers have just as many bits as the circles need.
TEST(Scale, SmallestNumbersAreRoundedOnly) {
  const double scale = 0x1p-84;
  auto circles = coarse(generate(Family::intersecting, 20, 3), 64);
  circles.push_back({0x1p84, 0x1p84, 0});  // an input of small numbers alone is an error
  auto scaled = circles;
  for (auto& [x, y, r] : scaled) {
    x *= scale;
    y *= scale;
    r *= scale;
  }
  const Box box = {-0.25, -0.5, 1, 0.75};
  const Box scaledBox = {-0.25 * scale, -0.5 * scale, scale, 0.75 * scale};
  const Diagram diagram = compute(circles).value();
  const Diagram scaledDiagram = compute(scaled).value();
  for (std::int32_t i = 0; i < 20; ++i) {
    const Outline parts = outline(diagram, i, test::regionOf(box));
    const Outline scaledParts = outline(scaledDiagram, i, test::regionOf(scaledBox));
    ASSERT_EQ(scaledParts.size(), parts.size());
    // Twelve bits and a few pieces.
    EXPECT_NEAR(perimeter(scaledParts) / scale, perimeter(parts), 0.02);
    EXPECT_NEAR(centroid(scaledParts).x / scale, centroid(parts).x, 0.02);
  }
  const EmptyDisc disc = **largestEmptyDiscInside(diagram, test::regionOf(box));
  const EmptyDisc scaledDisc = **largestEmptyDiscInside(scaledDiagram, test::regionOf(scaledBox));
  EXPECT_NEAR(scaledDisc.disc.r / scale, disc.disc.r, 0.01);
}

/// Areas fill a box of ordinary size around circles that cannot be told apart, and the other way round.
TEST(Scale, CellsFillTheBoxWhateverLiesBetweenTheirSizes) {
  for (const double small : {1.0, 1e-10, 1e-17, 1e-22, 1e-28}) {
    for (const double large : {1.0, 1e-15, 1e10, 1e28}) {
      if (small >= large && small != 1) continue;
      SCOPED_TRACE(testing::Message() << small << " in " << large);
      const std::vector<std::vector<Circle>> inputs = {
          {{0, 0, 0}, {small, 0, 0}, {0, large, 0}},
          {{0, 0, 0.25 * small}, {small, 0, 0.5 * small}, {0, large, 0.1 * large}},
          {{0, 0, 0}, {small, small, 0.5 * small}, {0.5 * large, large, 0}, {-large, 0.25 * large, 0.5 * large}}};
      for (const auto& circles : inputs) {
        const auto computed = compute(circles);
        ASSERT_TRUE(computed);
        const Diagram& diagram = computed.value();
        for (const double size : {small, large, std::sqrt(small) * std::sqrt(large)}) {
          const Box box = {rounded(-1.5 * size), rounded(-1.25 * size), rounded(1.75 * size), rounded(2 * size)};
          if (!(box.minX < box.maxX && box.minY < box.maxY)) continue;
          double sum = 0;
          for (std::int32_t i = 0; i < static_cast<std::int32_t>(circles.size()); ++i) {
            const Outline parts = outline(diagram, i, test::regionOf(box));
            for (const auto& loop : parts) {
              for (const auto& piece : loop) {
                for (const Point& p : polyline(piece.curve, 1e-3 * size)) {
                  ASSERT_TRUE(p.x >= box.minX - 1e-12 * size && p.x <= box.maxX + 1e-12 * size) << p.x;
                  ASSERT_TRUE(p.y >= box.minY - 1e-12 * size && p.y <= box.maxY + 1e-12 * size) << p.y;
                }
              }
            }
            sum += area(parts) / (box.maxX - box.minX) / (box.maxY - box.minY);
          }
          EXPECT_NEAR(sum, 1, 1e-9) << "box of " << size;
        }
      }
    }
  }
}

}  // namespace
}  // namespace circle_voronoi
