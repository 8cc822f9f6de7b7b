// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/curve.h"

#include <algorithm>
#include <cmath>

#include "vectors.h"

namespace circle_voronoi {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
/// Finite parameters keep away from what stands for infinity.
constexpr double kSmallestParameter = 1e-300;
constexpr double kLargestParameter = 1e300;
/// Keeps b above zero where two circles touch from inside up to rounding: the branch is then a folded ray.
constexpr double kSmallestB = 0x1p-50;

/// e^t for t = arsinh(sine).
double exponentialOf(double sine) {
  const double size = std::abs(sine);
  const double s = size < 1e100 ? size + std::sqrt(size * size + 1) : 2 * size;
  return std::clamp(sine < 0 ? 1 / s : s, kSmallestParameter, kLargestParameter);
}

}  // namespace

Bisector bisector(const Circle& left, const Circle& right, Metric metric) {
  const bool isCurved = metric == Metric::circles;
  const double difference = isCurved ? left.r - right.r : 0;
  const bool originIsLeft = difference <= 0;
  const Circle& origin = originIsLeft ? left : right;
  const Vector toOther = between(origin, originIsLeft ? right : left);
  const double d = length(toOther);
  const double size = std::abs(difference);

  Bisector result;
  result.left = {left.x, left.y};
  result.right = {right.x, right.y};
  result.a = difference / 2;
  // Not c^2 - a^2, which cancels for a circle almost inside the other.
  result.b = std::max(std::sqrt(std::max((d - size) * (d + size), 0.0)), d * kSmallestB) / 2;
  result.origin = {origin.x, origin.y};
  result.along = {toOther.x / d, toOther.y / d};
  result.across = originIsLeft ? Vector{-result.along.y, result.along.x} : Vector{result.along.y, -result.along.x};
  result.apex = (d - size) / 2;
  if (metric == Metric::power) result.apex += (left.r - right.r) * ((left.r + right.r) / (2 * d));
  return result;
}

Point pointAt(const Bisector& bisector, double s) {
  const double along = bisector.apex - std::abs(bisector.a) * ((s - 1) / s * (s - 1) / 2);
  const double across = bisector.b * (s - 1 / s) / 2;
  return {bisector.origin.x + (along * bisector.along.x + across * bisector.across.x),
          bisector.origin.y + (along * bisector.along.y + across * bisector.across.y)};
}

double parameterAt(const Bisector& bisector, Point p) {
  const Vector toPoint = {p.x - bisector.origin.x, p.y - bisector.origin.y};
  const double sine = dot(toPoint, bisector.across) / bisector.b;
  const double c = bisector.apex + std::abs(bisector.a);
  // The point's height b sinh t and its distance apex + c (cosh t - 1) both tell t; rounding shows less in the one that
  // changes faster. Of a narrow branch that is the distance.
  const bool isSteep = bisector.a != 0 && c * std::abs(sine) > bisector.b * std::sqrt(sine * sine + 1);
  const double rise = (length(toPoint) - bisector.apex) / c;
  if (!isSteep || !(rise > 0)) return exponentialOf(sine);
  return exponentialOf(std::copysign(std::sqrt(rise) * std::sqrt(rise + 2), sine));
}

EdgeCurve edgeCurve(std::span<const Circle> circles, const Diagram& diagram, std::int32_t edge, Metric metric) {
  const auto& [left, right, start, end] = diagram.edges[static_cast<std::size_t>(edge)];
  EdgeCurve curve;
  curve.bisector = bisector(circles[static_cast<std::size_t>(left)], circles[static_cast<std::size_t>(right)], metric);
  const auto vertexAt = [&](std::int32_t v) {
    const Vertex& vertex = diagram.vertices[static_cast<std::size_t>(v)];
    return Point{vertex.x, vertex.y};
  };
  if (start != kNone) {
    curve.start = vertexAt(start);
    curve.from = parameterAt(curve.bisector, curve.start);
  }
  if (end != kNone) {
    curve.end = vertexAt(end);
    curve.to = parameterAt(curve.bisector, curve.end);
  }
  // The order of the ends is certified: where the parameters contradict it, the edge has length zero up to rounding.
  if (curve.from > curve.to) curve.from = curve.to = std::sqrt(curve.from) * std::sqrt(curve.to);
  return curve;
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
  const Vector chord = {end.x - start.x, end.y - start.y};
  const double size = length(chord);
  EdgeCurve curve;
  Bisector& line = curve.bisector;
  line.across = {chord.x / size, chord.y / size};
  line.along = {line.across.y, -line.across.x};
  line.b = line.apex = size / 2;
  const Point middle = {start.x + chord.x / 2, start.y + chord.y / 2};
  line.left = line.origin = {middle.x - line.apex * line.along.x, middle.y - line.apex * line.along.y};
  line.right = {middle.x + line.apex * line.along.x, middle.y + line.apex * line.along.y};
  curve.from = exponentialOf(-1);
  curve.to = exponentialOf(1);
  curve.start = start;
  curve.end = end;
  return curve;
}

}  // namespace circle_voronoi
