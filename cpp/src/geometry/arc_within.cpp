// SPDX-License-Identifier: GPL-3.0-or-later
#include "arc_within.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "parameter_at_distance.h"

namespace circle_voronoi {
namespace {

/// The distance is near that of an apex if it exceeds it by no more than this share of the radius.
constexpr double kNearApex = 0x1p-16;

ShiftedSign beyondOf(const DistanceSigns& signs, const ArcEnd& end) {
  if (end.crossing) return signs.beyond(*end.crossing);
  return end.vertex == kNone ? ShiftedSign{1, false} : signs.beyond(end.vertex);
}

/// `atInfinity` is the result for an end at infinity.
ShiftedSign pastApexOf(const DistanceSigns& signs, const Edge& edge, const ArcEnd& end, int atInfinity) {
  if (end.crossing) return signs.pastApex(edge.left, edge.right, *end.crossing);
  if (end.vertex == kNone) return {atInfinity, false};
  return signs.pastApex(edge.left, edge.right, end.vertex);
}

}  // namespace

// The distance from both circles grows from the apex to both sides.
std::optional<ArcWithin> arcWithin(const DistanceSigns& signs, const Edge& edge, const EdgeCurve& curve,
                                   const ArcEnd& start, const ArcEnd& end) {
  const ShiftedSign first = beyondOf(signs, start);
  const ShiftedSign last = beyondOf(signs, end);
  ArcWithin arc = {curve, first.sign > 0, last.sign > 0};
  if (!arc.isCutFrom && !arc.isCutTo) return arc;
  if (arc.isCutFrom && arc.isCutTo) {
    const bool hasApex = signs.meetsRim(edge.left, RimLine::ofEdge(edge.right)) &&
                         pastApexOf(signs, edge, start, -1).sign < 0 && pastApexOf(signs, edge, end, 1).sign > 0;
    if (!hasApex) return std::nullopt;
  }
  const Bisector& bisector = curve.bisector;
  const double reach = signs.radius(bisector.origin == bisector.left ? edge.left : edge.right);
  const double apex = std::abs(bisector.apex);
  const bool isNearApex = !(reach - apex > kNearApex * reach);
  const double most = parameterAtDistance(bisector, std::max(reach, apex));
  // An end exactly at the distance cuts the edge if it is on this side of the apex.
  const auto cutAt = [&](double parameter, int side) -> std::pair<double, Point> {
    if (first.isTie && pastApexOf(signs, edge, start, -1).sign == side) return {curve.from, curve.start};
    if (last.isTie && pastApexOf(signs, edge, end, 1).sign == side) return {curve.to, curve.end};
    if (isNearApex) {
      // Rounding of the distance would make a large share of the rest.
      const Point p = signs.rimPoint(edge.left, RimLine::ofEdge(edge.right), side > 0).point;
      return {std::clamp(parameterAt(bisector, p), curve.from, curve.to), p};
    }
    if (parameter <= curve.from) return {curve.from, curve.start};
    if (parameter >= curve.to) return {curve.to, curve.end};
    return {parameter, pointAt(bisector, parameter)};
  };
  if (arc.isCutFrom) std::tie(arc.curve.from, arc.curve.start) = cutAt(1 / most, -1);
  if (arc.isCutTo) std::tie(arc.curve.to, arc.curve.end) = cutAt(most, 1);
  // Rounding may exchange two cuts at one place.
  if (arc.curve.from > arc.curve.to) {
    arc.curve.to = arc.curve.from;
    (arc.isCutTo ? arc.curve.end : arc.curve.start) = arc.isCutTo ? arc.curve.start : arc.curve.end;
  }
  return arc;
}

}  // namespace circle_voronoi
