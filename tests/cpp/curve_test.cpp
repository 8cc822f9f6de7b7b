// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "chord.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi_families/families.h"
#include "random.h"
#include "regions.h"
#include "vectors.h"

namespace circle_voronoi {
namespace {

double distanceBetween(Point p, Point q) { return length({p.x - q.x, p.y - q.y}); }

/// The difference of a point's distances from both circles, relative to the largest number involved.
double residual(const Circle& left, const Circle& right, Point p) {
  const double scale = std::max({std::abs(left.x), std::abs(left.y), left.r, std::abs(right.x), std::abs(right.y),
                                 right.r, std::abs(p.x), std::abs(p.y)});
  return std::abs(distance(Metric::circles, left, p) - distance(Metric::circles, right, p)) / scale;
}

struct Pair {
  Circle left;
  Circle right;
};

enum class Kind { ordinary, equalRadii, nearlyEqualRadii, hugeRatio, nearlyHidden };
constexpr Kind kKinds[] = {Kind::ordinary, Kind::equalRadii, Kind::nearlyEqualRadii, Kind::hugeRatio,
                           Kind::nearlyHidden};

Pair randomPair(Kind kind, Random& random) {
  Pair pair{{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1)}, {}};
  const double gap = random.logUniform(-6, 1);
  double r = random.uniform(0, 1);
  double d = pair.left.r + r + gap;
  switch (kind) {
    case Kind::ordinary:
      break;
    case Kind::equalRadii:
      r = pair.left.r;
      d = 2 * r + gap;
      break;
    case Kind::nearlyEqualRadii:
      r = pair.left.r + 1e-12;
      break;
    case Kind::hugeRatio:
      r = pair.left.r * 1e6;
      d = pair.left.r + r + gap;
      break;
    case Kind::nearlyHidden:
      r = pair.left.r / 3;
      d = pair.left.r - r + random.logUniform(-12, -2);
      break;
  }
  const Vector direction = random.direction();
  pair.right = {pair.left.x + d * direction.x, pair.left.y + d * direction.y, r};
  if (random.unit() < 0.5) std::swap(pair.left, pair.right);
  return pair;
}

EdgeCurve arcOf(const Bisector& bisector, double from, double to) {
  EdgeCurve curve;
  curve.bisector = bisector;
  curve.from = from;
  curve.to = to;
  curve.start = pointAt(bisector, from);
  curve.end = pointAt(bisector, to);
  return curve;
}

EdgeCurve randomArc(const Bisector& bisector, Random& random) {
  const double s = random.logUniform(-3, 3);
  return arcOf(bisector, s, s * random.logUniform(0, 4));
}

/// The distance of a point from an arc on one side of the apex, by a search around each of many points that is nearer
/// than those next to it.
double distanceFromSide(const Bisector& bisector, double from, double to, Point p) {
  constexpr int kCount = 256;
  const double step = std::pow(to / from, 1.0 / kCount);
  const auto at = [&](double s) { return distanceBetween(p, pointAt(bisector, s)); };
  std::vector<double> distances;
  for (int i = 0; i <= kCount; ++i) distances.push_back(at(from * std::pow(step, i)));
  double best = *std::ranges::min_element(distances);
  for (std::size_t i = 0; i <= kCount; ++i) {
    if ((i > 0 && distances[i - 1] < distances[i]) || (i < kCount && distances[i + 1] < distances[i])) continue;
    double low = from * std::pow(step, std::max(static_cast<double>(i) - 1, 0.0));
    double high = std::min(to, from * std::pow(step, static_cast<double>(i) + 1));
    for (int k = 0; k < 80; ++k) {
      const double first = low + (high - low) / 3;
      const double second = high - (high - low) / 3;
      best = std::min({best, at(first), at(second)});
      (at(first) < at(second) ? high : low) = at(first) < at(second) ? second : first;
    }
  }
  return best;
}

/// Two minima lie next to each other at the tip of a needle: each side is searched on its own.
double distanceFromArc(const EdgeCurve& curve, Point p) {
  const double apex = std::clamp(1.0, curve.from, curve.to);
  return std::min(distanceFromSide(curve.bisector, curve.from, apex, p),
                  distanceFromSide(curve.bisector, apex, curve.to, p));
}

Point pointOf(const CubicBezier& cubic, double u) {
  const double v = 1 - u;
  const double weights[] = {v * v * v, 3 * v * v * u, 3 * v * u * u, u * u * u};
  const Point points[] = {cubic.start, cubic.control1, cubic.control2, cubic.end};
  Point sum;
  for (int i = 0; i < 4; ++i) {
    sum.x += weights[i] * points[i].x;
    sum.y += weights[i] * points[i].y;
  }
  return sum;
}

TEST(Curve, PointsOfABranchAndOfItsBezierCurveSatisfyBothDistanceEquations) {
  Random random(1);
  for (int trial = 0; trial < 20000; ++trial) {
    const auto [left, right] = randomPair(kKinds[trial % 5], random);
    const EdgeCurve arc = randomArc(bisector(left, right), random);
    const RationalBezier bezier = rationalBezier(arc);
    for (int i = 0; i <= 10; ++i) {
      const Point p = pointAt(bezier, i / 10.0);
      ASSERT_LE(residual(left, right, p), 1e-12) << "trial " << trial << " at " << i;
      ASSERT_LE(residual(left, right, pointAt(arc.bisector, arc.from + (arc.to - arc.from) * i / 10)), 1e-12);
    }
  }
}

TEST(Curve, HasTheFociAndTheDifferenceOfTheRadii) {
  const Bisector b = bisector({1, 2, 5}, {11, 2, 1});
  EXPECT_EQ(b.left, (Point{1, 2}));
  EXPECT_EQ(b.right, (Point{11, 2}));
  EXPECT_EQ(2 * b.a, 4);
  EXPECT_EQ(b.a * b.a + b.b * b.b, 25);
  EXPECT_EQ(pointAt(b, 1), (Point{8, 2}));  // midway across the gap of 4
  EXPECT_LT(pointAt(b, 0.5).y, pointAt(b, 2).y);
}

TEST(Curve, HasItsLeftCircleOnTheLeft) {
  Random random(2);
  for (int trial = 0; trial < 1000; ++trial) {
    const auto [left, right] = randomPair(kKinds[trial % 4], random);
    const Bisector b = bisector(left, right);
    const double s = random.logUniform(-1, 1);
    const Point p = pointAt(b, s);
    const Point q = pointAt(b, s * 1.01);
    const Vector toLeft = {left.x - p.x, left.y - p.y};
    EXPECT_GT(cross({q.x - p.x, q.y - p.y}, toLeft), 0) << trial;
  }
}

TEST(Curve, FindsTheParameterOfAPoint) {
  Random random(3);
  for (int trial = 0; trial < 20000; ++trial) {
    const auto [left, right] = randomPair(kKinds[trial % 5], random);
    const Bisector b = bisector(left, right);
    const Point p = pointAt(b, random.logUniform(-8, 8));
    const Point q = pointAt(b, parameterAt(b, p));
    const double scale = std::max({distanceBetween(p, b.left), distanceBetween(p, b.right), 1.0});
    ASSERT_LE(distanceBetween(p, q), 1e-12 * scale) << trial;
  }
}

TEST(Curve, EndsInItsVerticesAndStaysOnBothDistanceEquations) {
  for (const FamilyInfo& family : families()) {
    SCOPED_TRACE(family.name);
    const auto circles = generate(family.family, 150, 4);
    const auto diagram = compute(circles);
    ASSERT_TRUE(diagram);
    const auto& edges = diagram.value().edges;
    const auto& vertices = diagram.value().vertices;
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const EdgeCurve curve = edgeCurve(diagram.value(), static_cast<std::int32_t>(e));
      ASSERT_LE(curve.from, curve.to);
      ASSERT_EQ(curve.startsAtInfinity(), edges[e].start == kNone);
      ASSERT_EQ(curve.endsAtInfinity(), edges[e].end == kNone);
      if (!curve.isBounded()) continue;
      const Vertex& start = vertices[static_cast<std::size_t>(edges[e].start)];
      ASSERT_EQ(curve.start, (Point{start.x, start.y}));
      const RationalBezier bezier = rationalBezier(curve);
      for (const double u : {0.0, 0.01, 0.3, 0.5, 0.9, 1.0}) {
        ASSERT_LE(residual(circles[static_cast<std::size_t>(edges[e].left)],
                           circles[static_cast<std::size_t>(edges[e].right)], pointAt(bezier, u)),
                  1e-12)
            << "edge " << e << " at " << u;
      }
    }
  }
}

TEST(Curve, ReversedRunsThroughTheSamePoints) {
  Random random(5);
  for (int trial = 0; trial < 100; ++trial) {
    const auto [left, right] = randomPair(kKinds[trial % 5], random);
    const EdgeCurve arc = randomArc(bisector(left, right), random);
    const EdgeCurve back = reversed(arc);
    EXPECT_EQ(back.start, arc.end);
    const double scale = distanceBetween(arc.start, arc.end) + 10;
    EXPECT_LE(distanceBetween(pointAt(back.bisector, back.to), arc.start), 1e-12 * scale);
    EXPECT_LE(distanceBetween(pointAt(back.bisector, 1 / arc.to), arc.end), 1e-12 * scale);
  }
}

TEST(Curve, CubicsAndPolylinesKeepTheTolerance) {
  Random random(6);
  for (int trial = 0; trial < 150; ++trial) {
    SCOPED_TRACE(trial);
    const auto [left, right] = randomPair(kKinds[trial % 5], random);
    const EdgeCurve arc = randomArc(bisector(left, right), random);
    const double size = distanceBetween(arc.start, arc.end);
    const double tolerance = size * random.logUniform(-5, -1);
    const double allowed = tolerance + 1e-12 * size;

    const auto cubics = cubicBeziers(arc, tolerance);
    ASSERT_EQ(cubics.front().start, arc.start);
    ASSERT_EQ(cubics.back().end, arc.end);
    for (std::size_t i = 0; i < cubics.size(); ++i) {
      if (i > 0) {
        ASSERT_EQ(cubics[i].start, cubics[i - 1].end);
      }
      for (const double u : {0.1, 0.2113, 0.5, 0.7887, 0.9}) {
        ASSERT_LE(distanceFromArc(arc, pointOf(cubics[i], u)), allowed);
      }
    }
    const auto points = polyline(arc, tolerance);
    ASSERT_EQ(points.front(), arc.start);
    ASSERT_EQ(points.back(), arc.end);
    for (std::size_t i = 1; i < points.size(); ++i) {
      for (const double u : {0.3, 0.5, 0.7}) {
        const Point p = {points[i - 1].x + u * (points[i].x - points[i - 1].x),
                         points[i - 1].y + u * (points[i].y - points[i - 1].y)};
        ASSERT_LE(distanceFromArc(arc, p), allowed);
      }
    }
    EXPECT_LE(cubics.size(), points.size() - 1);
    EXPECT_EQ(isNearChord(arc, tolerance), points.size() == 2);
  }
}

TEST(Curve, FewPiecesReachATightTolerance) {
  const EdgeCurve arc = arcOf(bisector({0, 0, 1}, {4, 0, 0}), 0.2, 5);
  EXPECT_EQ(cubicBeziers(arc, 2e-2).size(), 1U);
  EXPECT_LE(cubicBeziers(arc, 1e-6).size(), 5U);
  EXPECT_LE(cubicBeziers(arc, 1e-9).size(), 15U);
  const EdgeCurve straight = arcOf(bisector({0, 0, 1}, {4, 0, 1}), 1e-3, 1e6);
  EXPECT_EQ(cubicBeziers(straight, 1e-9).size(), 1U);
  EXPECT_EQ(polyline(straight, 1e-9).size(), 2U);
  // All of a branch but its bend is nearly straight.
  const EdgeCurve far = arcOf(bisector({0, 0, 1}, {4, 0, 0}), 1e-12, 1e12);
  EXPECT_LE(cubicBeziers(far, 1e-3).size(), 6U);
}

TEST(Curve, ANeedleIsFollowedToItsTip) {
  // The small circle touches the large one from inside but for a millionth.
  const EdgeCurve curve = arcOf(bisector({0, 0, 10}, {6.000001, 0, 4}), 0.02, 2);
  const Point tip = pointAt(curve.bisector, 1);
  for (const double tolerance : {0.1, 0.01, 1e-3}) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Point& p : polyline(curve, tolerance)) nearest = std::min(nearest, distanceBetween(p, tip));
    EXPECT_LT(nearest, 2 * tolerance);
    double drawn = std::numeric_limits<double>::infinity();
    for (const CubicBezier& cubic : cubicBeziers(curve, tolerance)) {
      for (int k = 0; k <= 16; ++k) drawn = std::min(drawn, distanceBetween(pointOf(cubic, k / 16.0), tip));
    }
    EXPECT_LT(drawn, 2 * tolerance);
  }
}

TEST(Curve, ANeedleThinnerThanRoundingRunsFromVertexToVertex) {
  // The point touches the large circle from inside but for a share of its radius; both vertices of their edge lie far
  // beyond it, on either side of the needle.
  for (const double scale : {0x1p-53, 1.0, 0x1p90}) {
    for (const double share : {0x1p-40, 0x1p-50, 0x1p-90, 0x1p-150, 0x1p-186}) {
      if (share * scale < kCoordinateStep) continue;
      SCOPED_TRACE(testing::Message() << "scale " << scale << ", share " << share);
      const std::vector<Circle> circles = {{-share * scale, 0, scale}, {scale, 0, 0}, {scale, scale, 0.01 * scale}};
      const Diagram diagram = compute(circles).value();
      const Box box = {-1.1 * scale, -0.3 * scale, 1.1 * scale, 1.1 * scale};
      int needles = 0;
      for (std::int32_t e = 0; e < static_cast<std::int32_t>(diagram.edges.size()); ++e) {
        const auto& [left, right, start, end] = diagram.edges[static_cast<std::size_t>(e)];
        const EdgeCurve curve = edgeCurve(diagram, e);
        if (left + right == 1 && curve.isBounded()) {
          ++needles;
          EXPECT_LT(curve.from, 1);
          EXPECT_GT(curve.to, 1);
          // The width of a needle is known to the square root of rounding only.
          for (const auto& [s, vertex] : {std::pair(curve.from, curve.start), std::pair(curve.to, curve.end)}) {
            EXPECT_LE(distanceBetween(pointAt(curve.bisector, s), vertex), 1e-8 * std::abs(vertex.x));
          }
        }
        for (const EdgeCurve& piece : edgePartsIn(diagram, e, test::regionOf(box))) {
          for (const Point p : polyline(piece, 1e-3 * scale)) {
            EXPECT_GE(std::min({p.x - box.minX, p.y - box.minY, box.maxX - p.x, box.maxY - p.y}), -1e-2 * scale);
          }
        }
      }
      EXPECT_EQ(needles, 1);
    }
  }
}

TEST(Curve, AnArcWithoutLengthIsOnePiece) {
  const EdgeCurve arc = arcOf(bisector({0, 0, 1}, {4, 0, 0}), 2, 2);
  EXPECT_EQ(cubicBeziers(arc, 0).size(), 1U);
  EXPECT_EQ(polyline(arc, 0).size(), 2U);
  EXPECT_EQ(arcLength(arc), 0);
  EXPECT_EQ(rationalBezier(arc).weight, 1);
}

/// The length of a branch between two values of t = log s in one direction from its apex, by Gauss's rule of order 30
/// on intervals that grow with the distance from the complex zeros of the speed, which are b / c and more from the real
/// line.
long double lengthByQuadrature(const Bisector& bisector, long double from, long double to) {
  const long double a = std::abs(bisector.a);
  const long double b = bisector.b;
  const auto speed = [&](long double t) { return std::hypot(a * std::sinh(t), b * std::cosh(t)); };
  long double sum = 0;
  while (from < to) {
    const long double width = std::min((from + b / std::hypot(a, b)) / 2, 0.5L);
    const long double next = std::min(to, from + width);
    sum += boost::math::quadrature::gauss<long double, 30>::integrate(speed, from, next);
    from = next;
  }
  return sum;
}

long double lengthByQuadrature(const EdgeCurve& arc) {
  const long double from = std::log(static_cast<long double>(arc.from));
  const long double to = std::log(static_cast<long double>(arc.to));
  if (from >= 0) return lengthByQuadrature(arc.bisector, from, to);
  if (to <= 0) return lengthByQuadrature(arc.bisector, -to, -from);
  return lengthByQuadrature(arc.bisector, 0, -from) + lengthByQuadrature(arc.bisector, 0, to);
}

TEST(Curve, LengthIsThatOfALongQuadrature) {
  Random random(7);
  for (int trial = 0; trial < 3000; ++trial) {
    SCOPED_TRACE(trial);
    // From a straight line to two circles that touch from inside but for rounding.
    const double d = random.logUniform(-3, 3);
    const double lean = trial % 3 == 0 ? random.unit() : 1 - random.logUniform(-15, 0);
    const double small = trial % 2 == 0 ? 0 : random.logUniform(-3, 3);
    const Bisector branch = bisector({0, 0, small}, {d, 0, small + lean * d});
    const double from = trial % 5 == 0 ? 1 : random.logUniform(-30, 30);
    const double step = trial % 7 == 0 ? random.logUniform(-12, 0) : random.logUniform(0, 30);
    const EdgeCurve arc = arcOf(branch, from, from * (1 + step));
    const long double expected = lengthByQuadrature(arc);
    const double scale = static_cast<double>(expected) + d + length({arc.start.x, arc.start.y});
    const double error = static_cast<double>(std::abs(arcLength(arc) - expected)) / scale;
    ASSERT_LE(error, 4e-15) << "from " << arc.from << " to " << arc.to << ", a " << branch.a << ", b " << branch.b;
    ASSERT_GE(arcLength(arc), distanceBetween(arc.start, arc.end));
  }
}

TEST(Curve, SegmentIsStraight) {
  const EdgeCurve curve = segment({1, 2}, {4, 6});
  EXPECT_TRUE(curve.isStraight());
  EXPECT_EQ(arcLength(curve), 5);
  EXPECT_NEAR(pointAt(curve.bisector, 1).x, 2.5, 1e-15);
  EXPECT_NEAR(pointAt(curve.bisector, curve.from).y, 2, 1e-15);
  EXPECT_NEAR(pointAt(curve.bisector, curve.to).x, 4, 1e-15);
}

}  // namespace
}  // namespace circle_voronoi
