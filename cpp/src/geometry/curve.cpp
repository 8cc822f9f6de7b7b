// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/curve.h"

#include <algorithm>
#include <cmath>

#include "edge_curve.h"
#include "parameter_at_distance.h"
#include "scale.h"
#include "two_part.h"

namespace circle_voronoi {
namespace {

/// Finite parameters stay above this limit, because 0 stands for infinity. No edge reaches it: vertices lie within
/// 2^876 of circles (three_touch_disc.h), whose centers are 2^-96 apart, so parameters lie between 2^-974 and 2^974.
constexpr double kSmallestParameter = 1e-300;
constexpr double kLargestParameter = 1e300;
/// Keeps b above zero where two circles touch from inside up to rounding: the branch is then a folded ray.
constexpr double kSmallestB = 0x1p-50;
/// The largest distance of a circle from touching another one from inside, as a share, where it is computed with twice
/// the digits.
constexpr double kNearlyInside = 0x1p-16;
/// Parameters with a larger quotient belong to two points.
constexpr double kFarApart = 0x1p10;

/// e^t for t = arsinh(sine).
double exponentialOf(double sine) {
  const double size = std::abs(sine);
  const double s = size < 1e100 ? size + std::sqrt(size * size + 1) : 2 * size;
  return std::clamp(sine < 0 ? 1 / s : s, kSmallestParameter, kLargestParameter);
}

/// The parameter s >= 1 at which the distance is apex + c rise, rise = cosh t - 1.
double parameterAtRise(double rise) { return exponentialOf(std::sqrt(rise) * std::sqrt(rise + 2)); }

/// Returns whether rounding of a point hides on which side of the axis it lies, as far out on a narrow branch.
bool isSideHidden(const Bisector& bisector, Point p) {
  const Vector toPoint = vectorTo(bisector.origin, p);
  return std::abs(dot(toPoint, bisector.across)) <= kRounding * lengthOf(toPoint);
}

/// Sets the parameters of the ends that are not at infinity.
void setParameters(EdgeCurve& curve, bool hasStart, bool hasEnd) {
  if (hasStart) curve.from = parameterAt(curve.bisector, curve.start);
  if (hasEnd) curve.to = parameterAt(curve.bisector, curve.end);
  // Two ends far from each other in the wrong order: one end is on the other side of the axis.
  if (curve.from > kFarApart * curve.to) {
    if (curve.to < 1 && isSideHidden(curve.bisector, curve.end)) {
      curve.to = 1 / curve.to;
    } else if (curve.from > 1 && isSideHidden(curve.bisector, curve.start)) {
      curve.from = 1 / curve.from;
    }
  }
  // The order of the ends is certified: where the parameters contradict it, the edge has length zero up to rounding.
  if (curve.from > curve.to) curve.from = curve.to = std::sqrt(curve.from) * std::sqrt(curve.to);
}

}  // namespace

Bisector bisector(const Circle& left, const Circle& right, Metric metric, bool weights) {
  const bool isCurved = metric == Metric::circles;
  const double difference = isCurved ? left.r - right.r : 0;
  const bool originIsLeft = difference <= 0;
  const Circle& origin = originIsLeft ? left : right;
  const Vector toOther = between(origin, originIsLeft ? right : left);
  const double d = length(toOther);
  const double size = std::abs(difference);
  // The difference of d and size has few digits where one circle is nearly inside the other. The difference of their
  // squares has all digits.
  const bool isNearlyInside = isCurved && d - size < kNearlyInside * d;
  const double square = isNearlyInside ? tangentSquare(left, right).square.value : (d - size) * (d + size);

  Bisector result;
  result.left = {left.x, left.y};
  result.right = {right.x, right.y};
  result.a = difference / 2;
  result.b = std::max(std::sqrt(std::max(square, 0.0)), d * kSmallestB) / 2;
  result.origin = {origin.x, origin.y};
  result.along = {toOther.x / d, toOther.y / d};
  result.across = originIsLeft ? Vector{-result.along.y, result.along.x} : Vector{result.along.y, -result.along.x};
  result.apex = (isNearlyInside ? std::max(square, 0.0) / (d + size) : d - size) / 2;
  if (metric == Metric::power) {
    // Below 2^290: the radii are below 2^97, and the centers 2^-96 apart.
    result.apex += (left.r - right.r) * ((weights ? 1 : left.r + right.r) / (2 * d));
  }
  return result;
}

Point pointAt(const Bisector& bisector, double s) {
  const double along = bisector.apex - std::abs(bisector.a) * ((s - 1) / s * (s - 1) / 2);
  const double across = bisector.b * (s - 1 / s) / 2;
  return {bisector.origin.x + (along * bisector.along.x + across * bisector.across.x),
          bisector.origin.y + (along * bisector.along.y + across * bisector.across.y)};
}

double parameterAt(const Bisector& bisector, Point p) {
  const Vector toPoint = vectorTo(bisector.origin, p);
  const double sine = dot(toPoint, bisector.across) / bisector.b;
  if (bisector.a == 0) return exponentialOf(sine);
  // Both the point's height b sinh t and its distance apex + c (cosh t - 1) determine t, and t is more accurate by the
  // value that changes faster. On a narrow branch this is the distance, and b and the height may be wrong by any
  // factor. So the larger of the two estimates of |sinh t| decides.
  const double c = bisector.apex + std::abs(bisector.a);
  const double rise = std::max((lengthOf(toPoint) - bisector.apex) / c, 0.0);
  const double size = std::max(std::abs(sine), std::sqrt(rise) * std::sqrt(rise + 2));
  const bool isSteep = c * size > bisector.b * lengthOf({size, 1});
  if (!isSteep) return exponentialOf(sine);
  return sine < 0 ? 1 / parameterAtRise(rise) : parameterAtRise(rise);
}

// On a hyperbola the distance is apex + c (cosh t - 1), on a line the hypotenuse of its apex and b sinh t.
double parameterAtDistance(const Bisector& bisector, double distance) {
  const double apex = std::abs(bisector.apex);
  if (bisector.a != 0) return parameterAtRise((distance - apex) / (apex + std::abs(bisector.a)));
  return exponentialOf(std::sqrt(distance - apex) * (std::sqrt(distance + apex) / bisector.b));
}

namespace {

EdgeCurve curveBetween(const Diagram& diagram, const Edge& edge) {
  const auto& [left, right, start, end] = edge;
  const auto& circles = diagram.circles;
  EdgeCurve curve;
  curve.bisector = bisector(circles[static_cast<std::size_t>(left)], circles[static_cast<std::size_t>(right)],
                            diagram.metric, diagram.weights);
  const auto vertexAt = [&](VertexIndex v) {
    const Vertex& vertex = diagram.vertices[static_cast<std::size_t>(v)];
    return Point{vertex.x, vertex.y};
  };
  if (start != kNone) curve.start = vertexAt(start);
  if (end != kNone) curve.end = vertexAt(end);
  setParameters(curve, start != kNone, end != kNone);
  return curve;
}

}  // namespace

EdgeCurve edgeCurve(const Diagram& diagram, EdgeIndex edge) {
  return curveBetween(diagram, diagram.edges[static_cast<std::size_t>(edge)]);
}

EdgeCurve orderedCurve(const Diagram& diagram, EdgeIndex edge) {
  const auto& [left, right, start, end] = diagram.edges[static_cast<std::size_t>(edge)];
  return isOrdered(diagram, edge) ? edgeCurve(diagram, edge) : curveBetween(diagram, {right, left, end, start});
}

EdgeCurve sideCurve(const Diagram& diagram, SideIndex side) {
  const EdgeCurve curve = edgeCurve(diagram, Diagram::edgeOf(side));
  return side % 2 == 0 ? curve : reversed(curve);
}

EdgeCurve reversed(const EdgeCurve& curve) {
  EdgeCurve result = curve;
  std::swap(result.bisector.left, result.bisector.right);
  result.bisector.a = -curve.bisector.a;
  result.bisector.across = {-curve.bisector.across.x, -curve.bisector.across.y};
  result.from = curve.endsAtInfinity() ? 0 : 1 / curve.to;
  result.to = curve.startsAtInfinity() ? kInfinite : 1 / curve.from;
  std::swap(result.start, result.end);
  return result;
}

EdgeCurve segment(Point start, Point end) {
  const Vector chord = vectorTo(start, end);
  EdgeCurve curve;
  Bisector& line = curve.bisector;
  const double size = lengthOf(chord);  // vertices may lie far apart (scale.h)
  line.across = {chord.x / size, chord.y / size};
  line.along = {line.across.y, -line.across.x};
  line.b = line.apex = size / 2;
  const Point middle = {start.x + chord.x / 2, start.y + chord.y / 2};
  const double half = size / 2;
  line.left = line.origin = {middle.x - half * line.along.x, middle.y - half * line.along.y};
  line.right = {middle.x + half * line.along.x, middle.y + half * line.along.y};
  curve.from = exponentialOf(-1);
  curve.to = exponentialOf(1);
  curve.start = start;
  curve.end = end;
  return curve;
}

}  // namespace circle_voronoi
