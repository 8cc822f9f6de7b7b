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
void turnOnce(std::vector<HullArc>& arcs, std::span<const Circle> circles) {
  const auto radius = [&](const HullArc& arc) { return circles[static_cast<std::size_t>(arc.circle)].r; };
  const double largest = radius(*std::ranges::max_element(arcs, {}, radius));
  for (HullArc& arc : arcs) {
    if (radius(arc) < largest && arc.angle > kThreeQuarterTurn) arc.angle = 0;
  }
  const auto sum = [&] {
    return std::accumulate(arcs.begin(), arcs.end(), 0.0,
                           [](double partial, const HullArc& arc) { return partial + arc.angle; });
  };
  const auto widest = [&]() -> HullArc& { return *std::ranges::max_element(arcs, {}, &HullArc::angle); };
  for (auto excess = std::lround(sum() / kFullTurn) - 1; excess != 0; excess -= excess > 0 ? 1 : -1) {
    HullArc& arc = excess > 0 ? widest() : *std::ranges::max_element(arcs, {}, radius);
    arc.angle = excess > 0 ? 0 : kFullTurn;
  }
  // What the arcs now lack is what rounding made of others that hardly turn.
  widest().angle += kFullTurn - sum();
}

}  // namespace

Hull hull(const Diagram& diagram) {
  const auto circleAt = [&](std::size_t step) {
    return diagram.circles[static_cast<std::size_t>(diagram.hull[step % diagram.hull.size()])];
  };
  const std::size_t count = diagram.hull.size();
  Hull hull;
  if (count == 0) return hull;
  if (count == 1) {
    const Circle& c = circleAt(0);
    const Point start = pointOn(c, {1, 0});
    hull.arcs.push_back({diagram.hull[0], start, start, kFullTurn});
  }
  for (std::size_t step = 0; count > 1 && step < count; ++step) {
    const Vector in = tangentNormal(circleAt(step + count - 1), circleAt(step));
    const Vector out = tangentNormal(circleAt(step), circleAt(step + 1));
    const double angle = std::atan2(cross(in, out), dot(in, out));
    hull.arcs.push_back({diagram.hull[step], pointOn(circleAt(step), in), pointOn(circleAt(step), out),
                         angle < 0 ? angle + kFullTurn : angle});
  }
  turnOnce(hull.arcs, diagram.circles);

  for (std::size_t step = 0; step < count; ++step) {
    const HullArc& arc = hull.arcs[step];
    const Point next = hull.arcs[(step + 1) % count].start;
    const Point origin = hull.arcs[0].start;
    const auto triangle = [&](Point p, Point q) {
      return cross({p.x - origin.x, p.y - origin.y}, {q.x - origin.x, q.y - origin.y}) / 2;
    };
    const double r = circleAt(step).r;
    hull.length += r * arc.angle + lengthOf({next.x - arc.end.x, next.y - arc.end.y});
    hull.area += triangle(arc.start, arc.end) + triangle(arc.end, next) + r * r * (arc.angle - std::sin(arc.angle)) / 2;
  }
  return hull;
}

}  // namespace circle_voronoi
