// SPDX-License-Identifier: GPL-3.0-or-later
#include "sphere_cell.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "at.h"

namespace circle_voronoi::sphere {
namespace {

/// The bearing of a vertex from one of its caps. It has more digits than the vertex, whose degrees are rounded, unless
/// the other two caps are at nearly the same place.
double bearingOf(const SphereDiagram& diagram, const Places& places, CircleIndex cap, VertexIndex vertex) {
  std::array<CircleIndex, 3> caps = diagram.vertexCaps[at(vertex)];
  while (caps[0] != cap) caps = {caps[1], caps[2], caps[0]};
  const Border second = places.border(cap, caps[1]);
  const Border third = places.border(cap, caps[2]);
  const Vector step = {third.vector.x - second.vector.x, third.vector.y - second.vector.y};
  const double size = length(second.vector) + length(third.vector) + std::abs(second.offset) + std::abs(third.offset);
  const double apart = length(step) + std::abs(third.offset - second.offset);
  if (apart <= 0x1p-20 * size) {
    const SphereVertex& given = diagram.vertices[at(vertex)];
    const Vector toVertex = viewOf(places[cap], placeAt(given.longitude, given.latitude)).vector;
    // The errors of the two directions are about size / apart and 1 / |toVertex| roundings.
    if (16 * apart < size * length(toVertex)) return angleOf(toVertex.y, toVertex.x);
  }
  const double opposite =
      heightOf(viewOf(places[caps[1]], places[caps[2]]).squaredHalf, places.halfGrowth(caps[1], caps[2]));
  const Vector direction = Places::touchFrom(second, third, opposite).direction;
  return angleOf(direction.y, direction.x);
}

double wrappedAngle(double angle, double least) {
  while (angle < least) angle += 2 * kPi;
  while (angle >= least + 2 * kPi) angle -= 2 * kPi;
  return angle;
}

}  // namespace

std::vector<CellSide> sidesOf(const SphereDiagram& diagram, const Places& places, CircleIndex cap) {
  std::vector<CellSide> sides;
  double total = 0;
  for (const SideIndex side : diagram.sides(cap)) {
    CellSide result;
    result.side = side;
    result.border = places.border(cap, diagram.neighborOf(side));
    result.amplitude = length(result.border.vector);
    result.bearing = angleOf(result.border.vector.y, result.border.vector.x);
    if (diagram.originOf(side) == kNone) {
      result.to = 2 * kPi;
    } else {
      const double from = bearingOf(diagram, places, cap, diagram.originOf(side));
      const double turn = wrappedAngle(bearingOf(diagram, places, cap, diagram.targetOf(side)) - from, 0);
      result.from = wrappedAngle(from - result.bearing, -kPi);
      result.to = result.from + turn;
      total += turn;
    }
    sides.push_back(result);
  }
  // All sides together turn once. Each further turn is a step back by rounding.
  while (total > 3 * kPi) {
    const auto largest = std::max_element(
        sides.begin(), sides.end(), [](const CellSide& a, const CellSide& b) { return a.to - a.from < b.to - b.from; });
    largest->to -= 2 * kPi;
    total -= 2 * kPi;
  }
  return sides;
}

std::vector<CellPart> partsOf(const CellSide& side, std::optional<double> cotangent) {
  if (!cotangent) return {{side.from, side.to, false}};
  // The border is nearest toward the other cap, and within the angle up to `widest` on both sides of it.
  const double cosine = (*cotangent - side.border.offset) / side.amplitude;
  if (!(cosine < 1)) return {{side.from, side.to, true}};
  if (!(cosine > -1)) return {{side.from, side.to, false}};
  const double widest = angleOf(std::sqrt((1 - cosine) * (1 + cosine)), cosine);
  std::vector<CellPart> parts;
  double reached = side.from;
  for (const double middle : {0.0, 2 * kPi}) {
    const double from = std::max(middle - widest, side.from);
    const double to = std::min(middle + widest, side.to);
    if (from >= to) continue;
    if (from > reached) parts.push_back({reached, from, true});
    parts.push_back({from, to, false});
    reached = to;
  }
  if (reached < side.to) parts.push_back({reached, side.to, true});
  return parts;
}

Reach reachOf(const SphereDiagram& diagram, CircleIndex cap, std::optional<double> maxDistance) {
  if (!maxDistance) return {};
  const double angle = (diagram.caps[at(cap)].r + *maxDistance) / diagram.radius;
  if (angle >= kPi) return {};
  return {angle};
}

}  // namespace circle_voronoi::sphere
