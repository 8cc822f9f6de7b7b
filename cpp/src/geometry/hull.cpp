// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/hull.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "scale.h"
#include "tangent.h"

namespace circle_voronoi {
namespace {

constexpr double kFullTurn = 2 * std::numbers::pi;
constexpr double kThreeQuarterTurn = 1.5 * std::numbers::pi;

/// Rounding may turn an arc of next to no angle into one of nearly a full turn, or the other way round. The hull turns
/// once, and only its largest circle may turn by more than half of that: what reaches farthest in two opposite
/// directions is as wide as any other.
void turnOnce(std::vector<HullArc>& arcs) {
  const double largest = std::ranges::max_element(arcs, {}, &HullArc::r)->r;
  for (HullArc& arc : arcs) {
    if (arc.r < largest && arc.angle > kThreeQuarterTurn) arc.angle = 0;
  }
  const auto sum = [&] {
    return std::accumulate(arcs.begin(), arcs.end(), 0.0,
                           [](double partial, const HullArc& arc) { return partial + arc.angle; });
  };
  const auto widest = [&]() -> HullArc& { return *std::ranges::max_element(arcs, {}, &HullArc::angle); };
  // Numbers that a program has changed may have no angles.
  const double turns = std::isfinite(sum()) ? sum() / kFullTurn : 1;
  for (auto excess = std::lround(turns) - 1; excess != 0; excess -= excess > 0 ? 1 : -1) {
    HullArc& arc = excess > 0 ? widest() : *std::ranges::max_element(arcs, {}, &HullArc::r);
    arc.angle = excess > 0 ? 0 : kFullTurn;
  }
  // The missing angle belongs to arcs with hardly any turn, whose angles rounding has changed.
  widest().angle += kFullTurn - sum();
}

}  // namespace

double hullGrowth(const Diagram& diagram) {
  double growth = 0;
  for (const CircleIndex i : diagram.hull) growth = std::max(growth, -diagram.circles[static_cast<std::size_t>(i)].r);
  return growth;
}

Hull convexHull(const Diagram& diagram) {
  const double growth = hullGrowth(diagram);
  const auto circleAt = [&](std::size_t step) {
    const Circle& c = diagram.circles[static_cast<std::size_t>(diagram.hull[step % diagram.hull.size()])];
    return Circle{c.x, c.y, diagram.metric == Metric::circles ? c.r + growth : 0};
  };
  const std::size_t count = diagram.hull.size();
  Hull hull;
  if (count == 0) return hull;
  if (count == 1) {
    const Circle c = circleAt(0);
    const Point start = pointOn(c, {1, 0});
    hull.arcs.push_back({diagram.hull[0], c.r, start, start, kFullTurn});
  }
  for (std::size_t step = 0; count > 1 && step < count; ++step) {
    const Circle c = circleAt(step);
    const Vector in = tangentNormal(circleAt(step + count - 1), c);
    const Vector out = tangentNormal(c, circleAt(step + 1));
    const double angle = std::atan2(cross(in, out), dot(in, out));
    hull.arcs.push_back(
        {diagram.hull[step], c.r, pointOn(c, in), pointOn(c, out), angle < 0 ? angle + kFullTurn : angle});
  }
  turnOnce(hull.arcs);

  for (std::size_t step = 0; step < count; ++step) {
    const HullArc& arc = hull.arcs[step];
    const Point next = hull.arcs[(step + 1) % count].start;
    const Point origin = hull.arcs[0].start;
    const auto triangle = [&](Point p, Point q) {
      return cross({p.x - origin.x, p.y - origin.y}, {q.x - origin.x, q.y - origin.y}) / 2;
    };
    const double r = arc.r;
    hull.length += r * arc.angle + lengthOf({next.x - arc.end.x, next.y - arc.end.y});
    hull.area += triangle(arc.start, arc.end) + triangle(arc.end, next) + r * r * (arc.angle - std::sin(arc.angle)) / 2;
  }
  return hull;
}

}  // namespace circle_voronoi
