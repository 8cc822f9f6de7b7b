// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/cells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_set>

#include "cell_limits.h"
#include "infinity.h"
#include "scale.h"
#include "unbounded_cell.h"

namespace circle_voronoi {
namespace {

const Circle& circleAt(const Diagram& diagram, CircleIndex i) { return diagram.circles[static_cast<std::size_t>(i)]; }

/// Returns a bound on the rounding error of distanceDifference: a part of the distance between the two centers minus
/// the difference of the radii.
double roundingOfDifference(const Diagram& diagram, CircleIndex circle, CircleIndex other) {
  const Circle& c = circleAt(diagram, circle);
  const Circle& d = circleAt(diagram, other);
  return 0x1p-49 * (lengthOf(between(d, c)) + std::abs(radiusOf(diagram, d) - radiusOf(diagram, c)));
}

}  // namespace

std::vector<CircleIndex> neighbors(const Diagram& diagram, CircleIndex circle) {
  std::vector<CircleIndex> result;
  for (const SideIndex side : diagram.sides(circle)) result.push_back(diagram.neighborOf(side));
  return result;
}

double distanceFrom(const Diagram& diagram, CircleIndex circle, Point p) {
  return distance(diagram.metric, circleAt(diagram, circle), p, diagram.weights);
}

// |p - d|^2 - |p - c|^2 = (c - d) . ((p - c) + (p - d)).
double distanceDifference(const Diagram& diagram, CircleIndex circle, CircleIndex other, Point p) {
  const Circle& c = circleAt(diagram, circle);
  const Circle& d = circleAt(diagram, other);
  const Vector fromCircle = {p.x - c.x, p.y - c.y};
  const Vector fromOther = {p.x - d.x, p.y - d.y};
  const double difference = diagram.metric == Metric::centers ? 0 : d.r - c.r;
  const bool isPower = diagram.metric == Metric::power;
  const double radii = isPower ? std::abs(radiusOf(diagram, c)) + std::abs(radiusOf(diagram, d)) : 0;
  const double size = lengthOf(fromCircle) + lengthOf(fromOther) + radii;
  if (size == 0) return -difference;
  const Vector sum = {fromCircle.x + fromOther.x, fromCircle.y + fromOther.y};
  // The point may lie anywhere.
  const double unit = unitFor(std::max(largestOf(sum), size));
  const double product = dot(between(d, c), measuredIn(unit, sum));
  if (!isPower) return product / (size / unit) - difference;
  return (product - difference * ((diagram.weights ? 1 : radii) / unit)) / (size / unit);
}

bool contains(const Diagram& diagram, CircleIndex circle, Point p) {
  if (!diagram.hasCell(circle)) return false;
  std::vector<CircleIndex> asked = {circle};
  // If a neighbor is as near as the circle up to rounding, one of its own neighbors may be much nearer.
  std::unordered_set<CircleIndex> met;
  for (std::size_t k = 0; k < asked.size(); ++k) {
    for (const SideIndex side : diagram.sides(asked[k])) {
      const CircleIndex other = diagram.neighborOf(side);
      if (other == circle) continue;
      const double its = distanceDifference(diagram, circle, other, p);
      const double rounding = roundingOfDifference(diagram, circle, other);
      // Also false for NaN.
      if (!(its >= (k == 0 ? 0 : -rounding))) return false;
      if (its <= rounding && met.insert(other).second) asked.push_back(other);
    }
  }
  return true;
}

double cellArea(const Diagram& diagram, CircleIndex circle) {
  const Outline whole = outline(diagram, circle);
  return isUnbounded(diagram, circle, whole) ? kInfinite : area(whole);
}

Point cellCentroid(const Diagram& diagram, CircleIndex circle) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const Outline whole = outline(diagram, circle);
  return whole.empty() ? Point{kNan, kNan} : centroid(whole);
}

double cellPerimeter(const Diagram& diagram, CircleIndex circle) {
  const Outline whole = outline(diagram, circle);
  return isUnbounded(diagram, circle, whole) ? kInfinite : perimeter(whole);
}

}  // namespace circle_voronoi
