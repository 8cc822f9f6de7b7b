// SPDX-License-Identifier: GPL-3.0-or-later
// Cells in convex polygons whose corners and sides lie on vertices and edges of the diagram, against counting.
//
// CIRCLE_VORONOI_CONVEX_TRIALS sets the number of inputs of each family.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "circle_voronoi/cells.h"
#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/comparison.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/queries.h"
#include "circle_voronoi/region.h"
#include "random.h"
#include "regions.h"
#include "report.h"

namespace circle_voronoi {
namespace convex_bounds_test {
namespace {

using Circles = std::vector<Circle>;
using Corners = std::vector<Point>;

/// The number of inputs of each family.
int trialCount() {
  const char* text = std::getenv("CIRCLE_VORONOI_CONVEX_TRIALS");
  return text == nullptr ? 60 : std::atoi(text);
}

ConvexPolygon polygonOf(const Corners& corners) { return ConvexPolygon::from(corners).value(); }

double lengthBetween(Point p, Point q) { return std::hypot(q.x - p.x, q.y - p.y); }

/// Statistics of the grid points in a polygon: for each circle the share of the points that are nearest to it and
/// within a distance, and the point farthest from all circles.
struct Count {
  std::vector<double> shares;
  double farthest = -1e300;
  double step = 0;  ///< no point of the polygon is farther from one of the grid
};

Count count(const Circles& circles, const ConvexPolygon& polygon, double maxDistance, int rows) {
  Count result;
  result.shares.assign(circles.size(), 0);
  const auto corners = polygon.corners();
  double total = 0;
  // A fan of triangles, each with points at the centers of equal small triangles.
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    const Point a = corners[0];
    const Vector u = {(corners[k].x - a.x) / rows, (corners[k].y - a.y) / rows};
    const Vector v = {(corners[k + 1].x - a.x) / rows, (corners[k + 1].y - a.y) / rows};
    const double weight = std::abs(u.x * v.y - u.y * v.x) / 2;
    result.step = std::max({result.step, std::hypot(u.x, u.y), std::hypot(v.x, v.y)});
    for (int i = 0; i < rows; ++i) {
      for (int j = 0; i + j < rows; ++j) {
        for (int upper = 0; upper < (i + j + 1 < rows ? 2 : 1); ++upper) {
          const double s = i + (1 + upper) / 3.0;
          const double t = j + (1 + upper) / 3.0;
          const Point p = {a.x + s * u.x + t * v.x, a.y + s * u.y + t * v.y};
          std::size_t nearest = 0;
          double least = 1e300;
          for (std::size_t c = 0; c < circles.size(); ++c) {
            const double distance = lengthBetween({circles[c].x, circles[c].y}, p) - circles[c].r;
            if (distance < least) {
              least = distance;
              nearest = c;
            }
          }
          total += weight;
          if (least <= maxDistance) result.shares[nearest] += weight;
          result.farthest = std::max(result.farthest, least);
        }
      }
    }
  }
  for (double& share : result.shares) share /= total;
  return result;
}

void print(const Circles& circles, const ConvexPolygon& polygon) {
  std::string text;
  char line[160];
  for (const Circle& c : circles) {
    std::snprintf(line, sizeof line, "{%.17g, %.17g, %.17g}, ", c.x, c.y, c.r);
    text += line;
  }
  text += "\nin ";
  for (const Point& p : polygon.corners()) {
    std::snprintf(line, sizeof line, "{%.17g, %.17g}, ", p.x, p.y);
    text += line;
  }
  ADD_FAILURE() << text;
}

/// Expects right areas and discs for circles in a polygon. Returns whether it is.
bool expectRight(const Circles& circles, const ConvexPolygon& polygon, int rows = 90) {
  const auto computed = compute(circles);
  if (!computed) return true;
  const Diagram& diagram = *computed;
  const double whole = polygon.area();
  double size = 0;
  for (const Point& p : polygon.corners()) size = std::max({size, std::abs(p.x), std::abs(p.y)});
  const double extent = lengthBetween(polygon.corners()[0], polygon.corners()[1]) +
                        lengthBetween(polygon.corners()[1], polygon.corners()[2]);
  double farthest = 0;
  for (const Circle& c : circles) farthest = std::max(farthest, lengthBetween({c.x, c.y}, polygon.corners()[0]) + c.r);
  // Tolerance for the rounding of coordinates.
  const double rounding = 1e-12 * whole + 1e-14 * extent * std::max(size, farthest);
  // A point of the grid next to a border may be counted for either side.
  const double coarse = 0.03 * whole + 3 * rounding;
  const Count all = count(circles, polygon, 1e300, rows);
  const double maxDistance = std::max(all.farthest / 2, 1e-3 * extent);
  const Count near = count(circles, polygon, maxDistance, rows);
  bool isRight = true;
  const auto expect = [&](bool isTrue, const char* what, std::size_t i, double is, double should) {
    if (isTrue) return;
    ADD_FAILURE() << what << " of " << i << ": " << is << ", not " << should << " of " << whole;
    isRight = false;
  };
  double sum = 0;
  double nearSum = 0;
  double nearCount = 0;
  for (std::size_t i = 0; i < circles.size(); ++i) {
    const auto index = static_cast<std::int32_t>(i);
    const Outline cell = outline(diagram, index, polygon);
    const double part = area(cell);
    sum += part;
    expect(part >= -rounding, "area", i, part, 0);
    expect(std::abs(part - all.shares[i] * whole) <= coarse, "area", i, part, all.shares[i] * whole);
    const Outline cut = clippedBufferOutline(diagram, index, polygon, maxDistance);
    const double nearPart = area(cut);
    nearSum += nearPart;
    nearCount += near.shares[i] * whole;
    expect(nearPart >= -rounding && nearPart <= part + 3 * rounding, "area within a distance", i, nearPart, part);
    expect(std::abs(nearPart - near.shares[i] * whole) <= coarse, "area within a distance", i, nearPart,
           near.shares[i] * whole);
    for (const Outline* one : {&cell, &cut}) {
      for (const auto& loop : *one) {
        for (std::size_t k = 0; k < loop.size(); ++k) {
          expect(loop[k].curve.end == loop[(k + 1) % loop.size()].curve.start, "a gap in the outline", i, 0, 0);
        }
      }
    }
  }
  for (const auto distance : {std::optional<double>(), std::optional(maxDistance)}) {
    const auto judged = outlines(diagram, polygon, distance);
    if (!judged) ADD_FAILURE() << judged.error().message;
    isRight = isRight && judged;
  }
  expect(std::abs(sum - whole) <= rounding, "sum of areas", 0, sum, whole);
  expect(std::abs(nearSum - nearCount) <= coarse, "sum of areas within a distance", 0, nearSum, nearCount);
  const auto disc = largestEmptyDiscCenteredIn(diagram, polygon);
  const double slack = 1e-9 * (extent + size);
  expect(disc && disc->disc.r >= all.farthest - slack && disc->disc.r <= all.farthest + all.step, "largest disc", 0,
         disc ? disc->disc.r : 0, all.farthest);
  if (!isRight) print(circles, polygon);
  return isRight;
}

/// Triples of whole numbers a^2 + b^2 = c^2, in all directions.
Vector pythagorean(Random& random, int& hypotenuse) {
  constexpr std::array<std::array<int, 3>, 7> kTriples = {
      {{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {7, 24, 25}, {20, 21, 29}, {0, 1, 1}, {1, 0, 1}}};
  const auto& [a, b, c] = kTriples[random.below(kTriples.size())];
  hypotenuse = c;
  const double x = random.below(2) == 0 ? a : -a;
  const double y = random.below(2) == 0 ? b : -b;
  return random.below(2) == 0 ? Vector{x, y} : Vector{y, x};
}

/// Circles with whole numbers that touch one disc around (0, 0).
Circles aroundOneDisc(Random& random) {
  const int count = 3 + static_cast<int>(random.below(10));
  const int radius = 1 + static_cast<int>(random.below(60));
  Circles circles;
  for (int k = 0; k < count; ++k) {
    int hypotenuse = 1;
    const Vector v = pythagorean(random, hypotenuse);
    const int factor = radius / hypotenuse + 1 + static_cast<int>(random.below(4));
    circles.push_back({factor * v.x, factor * v.y, static_cast<double>(factor * hypotenuse - radius)});
  }
  return circles;
}

Circles onGrid(Random& random, bool isEqual) {
  Circles circles;
  const int count = 2 + static_cast<int>(random.below(11));
  const double radius = random.below(2) == 0 ? 0 : 0.25;
  for (int k = 0; k < count; ++k) {
    circles.push_back({static_cast<double>(random.below(7)), static_cast<double>(random.below(7)),
                       isEqual ? radius : static_cast<double>(random.below(4)) / 4});
  }
  return circles;
}

Circles anywhere(Random& random) {
  Circles circles;
  const int count = 2 + static_cast<int>(random.below(11));
  for (int k = 0; k < count; ++k) circles.push_back({random.uniform(0, 6), random.uniform(0, 6), random.uniform(0, 1)});
  return circles;
}

Circles circlesOf(Random& random) {
  switch (random.below(4)) {
    case 0:
      return aroundOneDisc(random);
    case 1:
      return onGrid(random, true);
    case 2:
      return onGrid(random, false);
    default:
      return anywhere(random);
  }
}

/// A contact with the diagram: a vertex, a point of an edge, and the direction of the edge there.
struct Touch {
  Point point;
  Vector along;
};

std::optional<Touch> touchOf(const Diagram& diagram, Random& random, bool isVertex) {
  if (diagram.edges.empty()) return std::nullopt;
  const auto edge = static_cast<std::int32_t>(random.below(diagram.edges.size()));
  const EdgeCurve curve = edgeCurve(diagram, edge);
  const double from = std::max(curve.from, 0.1);
  const double to = std::max(std::min(curve.to, 10.0), from);
  const double s = isVertex && !curve.startsAtInfinity() ? curve.from
                   : isVertex && !curve.endsAtInfinity() ? curve.to
                                                         : from + random.uniform(0, 1) * (to - from);
  if (!(s > 1e-6 && s < 1e6)) return std::nullopt;
  const Point p = pointAt(curve.bisector, s * (1 - 1e-6));
  const Point q = pointAt(curve.bisector, s * (1 + 1e-6));
  Vector along = {q.x - p.x, q.y - p.y};
  // Along a straight edge the side follows it to the bit, where numbers allow it.
  if (curve.isStraight()) along = curve.bisector.across;
  const double size = std::hypot(along.x, along.y);
  if (!(size > 0)) return std::nullopt;
  Touch touch = {pointAt(curve.bisector, s), {along.x / size, along.y / size}};
  if (isVertex && !curve.startsAtInfinity()) touch.point = curve.start;
  if (isVertex && curve.startsAtInfinity() && !curve.endsAtInfinity()) touch.point = curve.end;
  return touch;
}

std::optional<ConvexPolygon> ordered(Corners corners) {
  if (auto polygon = ConvexPolygon::from(corners)) return *polygon;
  std::ranges::reverse(corners);
  if (auto polygon = ConvexPolygon::from(corners)) return *polygon;
  return std::nullopt;
}

enum class Contact { cornerAtVertex, cornerOnEdge, sideAlongEdge, sideThroughVertex, sideTangent };

std::optional<ConvexPolygon> polygonAt(const Touch& touch, Contact kind, double size, Random& random) {
  const auto& [p, along] = touch;
  const auto step = [&](double scale) {
    // Quarters of whole numbers half of the time.
    const double x = random.uniform(-1, 1) * scale;
    const double y = random.uniform(-1, 1) * scale;
    return random.below(2) == 0 ? Vector{x, y} : Vector{std::round(4 * x) / 4, std::round(4 * y) / 4};
  };
  const Vector u = step(size);
  const Vector v = step(size);
  const auto at = [&](Vector w, double factor = 1) { return Point{p.x + factor * w.x, p.y + factor * w.y}; };
  const Vector line = {along.x * size, along.y * size};
  switch (kind) {
    case Contact::cornerAtVertex:
    case Contact::cornerOnEdge:
      return random.below(2) == 0 ? ordered({p, at(u), at(v)})
                                  : ordered({p, at(u), {p.x + u.x + v.x, p.y + u.y + v.y}, at(v)});
    case Contact::sideAlongEdge:
      return ordered({at(line, -random.uniform(0, 1)), at(line, random.uniform(0.1, 1)), at(u)});
    case Contact::sideThroughVertex:
      return ordered({at(u, -1), at(u), at(v)});
    case Contact::sideTangent:
      return ordered({at(line, -1), at(line), at(u)});
  }
  return std::nullopt;
}

TEST(ConvexBoundsFixture, CirclesWhoseVerticesAndEdgesMeetTheBounds) {
  struct Input {
    const char* what;
    Circles circles;
    Corners corners;
  };
  const std::vector<Input> inputs = {
      {"a corner where three circles with whole numbers touch a disc",
       {{-78, -104, 89}, {126, 32, 89}, {60, -25, 24}},
       {{0, 0}, {68, -148}, {148, -88}}},
      {"a corner where four circles touch a disc",
       {{66, 112, 124}, {100, -240, 254}, {240, -100, 254}, {168, -99, 189}},
       {{0, -70}, {35.3, -17.6887358482}, {0, 0}}},
      {"a corner at a computed vertex of equal circles",
       {{-1.2469796037174674, -1.5636629649360594, 0.5},
        {-0.44504186791262917, -1.9498558243636472, 0.5},
        {1.8019377358048387, -0.86776748823511502, 0.5}},
       {{0, 0}, {2.75, 4}, {1, 2.5}}},
      {"corners at vertices of points",
       {{2.8524783578565245, 1.7988141566511384, 0},
        {0.074535261823752919, 3.0815385103318431, 0},
        {2.9029702836826612, 3.2152136908776723, 0},
        {2.174503533233723, 3.0583487895023627, 0}},
       {{1.1090889966844617, 1.6726283296341318},
        {2.6727750445118703, 2.5143199723779221},
        {1.1942078980591633, 9.3806552394240477}}},
      {"points whose vertices lie beside the bounds",
       {{1.0999594640626102, 1.2261226166591841, 0},
        {0.26988561122882726, 1.4536334140381124, 0},
        {1.1758275016447741, 1.5076070019980379, 0},
        {1.0928834940810701, 0.068326223786083773, 0}},
       {{0.7229710652950061, 1.4786981869816183},
        {0.49608219696253453, 0.65089344421087014},
        {3.8708011405155376, 0.63026856570225787}}},
      {"circles of which two nearly touch from inside, far from the others",
       {{377.00000000000023, -372.99999999999977, 1.0000000000002274},
        {0, 0, 0},
        {375.00000000000045, -374.99999999999977, 0.50000000000022737},
        {376, -374, 0}},
       {{0, -400}, {376.40545499427736, -374.82212166094331}, {375.17787833905646, -373.59454500572264}}},
      {"a side along an edge", {{3, 0, .5}, {2, 0, .5}}, {{2, -.25}, {2.5, -1}, {2.5, .5}}},
      {"a side along an edge, beside a corner on the line of centers",
       {{3, 0, .5}, {2, 0, .5}},
       {{2, 0}, {2.5, -1}, {2.5, 1}}},
      {"a disc that touches three points and a side",
       {{0, 1, 0}, {2, 2, 0}, {1, 0, 0}},
       {{1, .5}, {1.25, 1.5}, {.5, -.5}}},
      {"a corner on an edge", {{2, 0, 0}, {1, 1, .2}, {2, 2, .2}}, {{1.25, .75}, {2.5, .5}, {1, 2}}},
      {"corners on the diagonal of a grid",
       {{1, 2, .75}, {0, 0, .25}, {2, 1, .75}},
       {{.5, .5}, {2.5, 1}, {1.25, 1.25}}},
      {"a corner at the center of three circles",
       {{2, 0, .5}, {0, 2, .5}, {-2, 0, .5}},
       {{0, 0}, {0, 2.5}, {-.75, .25}}},
      {"circles that nearly touch from inside",
       {{6.187499999996362, -6, 0.046875}, {6.156249999998181, -5.9999999999956026, 0.015625000001818989}},
       {{6.15, -6.1}, {6.17, -6.1}, {6.15, -6}}},
      {"a region beside circles that nearly touch from inside",
       {{6.187499999996362, -6, 0.046875}, {6.156249999998181, -5.9999999999956026, 0.015625000001818989}},
       {{6.1501, -6.0772}, {6.1744, -6.0772}, {6.1501, -6.0529}}},
  };
  for (const auto& [what, circles, corners] : inputs) {
    SCOPED_TRACE(what);
    Corners ordered = corners;
    if (!ConvexPolygon::from(ordered)) std::ranges::reverse(ordered);
    expectRight(circles, polygonOf(ordered), 300);
  }
}

TEST(ConvexBoundsFixture, LargestDiscsWithTheirCenterInATriangle) {
  const auto radiusOf = [](const Circles& circles, const Corners& corners) {
    return largestEmptyDiscCenteredIn(compute(circles).value(), polygonOf(corners))->disc.r;
  };
  EXPECT_NEAR(radiusOf({{0, 1, 0}, {2, 2, 0}, {1, 0, 0}}, {{1.25, 1.5}, {.5, -.5}, {1, .5}}), 5 / (3 * std::sqrt(2)),
              1e-14);
  EXPECT_NEAR(
      radiusOf({{6.187499999996362, -6, 0.046875}, {6.156249999998181, -5.9999999999956026, 0.015625000001818989}},
               {{6.15, -6.1}, {6.17, -6.1}, {6.15, -6}}),
      0.0599250468, 1e-9);
}

TEST(ConvexBoundsFixture, ACellThatTouchesASideFromOutsideHasNoArea) {
  const Diagram diagram = compute(Circles{{3, 0, .5}, {2, 0, .5}}).value();
  const ConvexPolygon triangle = polygonOf({{2, -.25}, {2.5, -1}, {2.5, .5}});
  EXPECT_NEAR(area(outline(diagram, 0, triangle)), 0, 1e-40);
  EXPECT_NEAR(area(clippedBufferOutline(diagram, 0, triangle, .5)), 0, 1e-40);
}

/// A grid of circles, of which few are in the middle.
Diagram gridDiagram() {
  Circles circles;
  for (int x = 0; x < 5; ++x) {
    for (int y = 0; y < 5; ++y)
      circles.push_back({static_cast<double>(x), static_cast<double>(y), 0.1 * ((x + y) % 3)});
  }
  return compute(circles).value();
}

TEST(ConvexBoundsJudge, AcceptsCorrectDiagrams) {
  const auto cells = outlines(gridDiagram(), test::regionOf(Box{0.5, 0.5, 3.5, 3.25}));
  ASSERT_TRUE(cells);
  double sum = 0;
  for (const Outline& cell : *cells) sum += area(cell);
  EXPECT_NEAR(sum, 8.25, 1e-13);
  EXPECT_TRUE(outlines(gridDiagram(), test::regionOf(Box{0.5, 0.5, 3.5, 3.25}), 0.2));
}

TEST(ConvexBoundsJudge, RefusesCorruptedDiagrams) {
  const ConvexPolygon region = test::regionOf(Box{0.5, 0.5, 3.5, 3.25});
  const auto isRefused = [&](auto corrupt) {
    Diagram diagram = gridDiagram();
    corrupt(diagram);
    const auto cells = outlines(diagram, region);
    return !cells && cells.error().code == ErrorCode::badInput;
  };
  // The circle in the middle.
  constexpr std::size_t kMiddle = 12;
  EXPECT_TRUE(isRefused([](Diagram& d) { d.links.firstSide[kMiddle] = d.links.firstSide[kMiddle + 1]; }));
  EXPECT_TRUE(isRefused([](Diagram& d) { d.links.firstSide[kMiddle] = Diagram::twin(d.links.firstSide[kMiddle]); }));
  EXPECT_TRUE(isRefused([](Diagram& d) { d.links.firstSide[kMiddle] = kNone; }));
}

class ConvexBounds : public testing::TestWithParam<std::pair<const char*, Contact>> {};

TEST_P(ConvexBounds, AreasAndDiscsAreRight) {
  const auto [name, kind] = GetParam();
  Random random(test::seedOr(1) + static_cast<std::uint64_t>(kind) * 1000003);
  int wrong = 0;
  int tried = 0;
  for (int trial = 0; trial < trialCount() && wrong < 5;) {
    const Circles circles = circlesOf(random);
    const auto diagram = compute(circles);
    if (!diagram) continue;
    const bool isVertex = kind == Contact::cornerAtVertex || kind == Contact::sideThroughVertex;
    const auto touch = touchOf(*diagram, random, isVertex);
    if (!touch || std::hypot(touch->point.x, touch->point.y) > 1e4) continue;
    double size = 0;
    for (const Circle& c : circles) size = std::max({size, std::abs(c.x), std::abs(c.y)});
    const auto polygon = polygonAt(*touch, kind, std::max(size, 1.0), random);
    if (!polygon || polygon->area() < 1e-3 * size * size) continue;
    ++trial;
    ++tried;
    if (!expectRight(circles, *polygon)) ++wrong;
  }
  if (std::getenv("CIRCLE_VORONOI_CONVEX_TRIALS") != nullptr) std::printf("%s: %d wrong of %d\n", name, wrong, tried);
}

INSTANTIATE_TEST_SUITE_P(Kinds, ConvexBounds,
                         testing::Values(std::pair{"cornerAtVertex", Contact::cornerAtVertex},
                                         std::pair{"cornerOnEdge", Contact::cornerOnEdge},
                                         std::pair{"sideAlongEdge", Contact::sideAlongEdge},
                                         std::pair{"sideThroughVertex", Contact::sideThroughVertex},
                                         std::pair{"sideTangent", Contact::sideTangent}),
                         [](const auto& instance) { return std::string(instance.param.first); });

}  // namespace
}  // namespace convex_bounds_test
}  // namespace circle_voronoi
