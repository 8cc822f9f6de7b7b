// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "arc_measure.h"
#include "circle_arc.h"
#include "circle_voronoi/cells.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

/// An area of less than this share of the square around it is but rounding.
constexpr double kRoundingOfArea = 0x1p-44;
/// The start of the first piece: moments are taken relative to it.
Point referenceOf(const Outline& outline) { return outline.front().front().curve.start; }

Point middleOf(const EdgeCurve& curve) { return pointAt(curve.bisector, std::sqrt(curve.from) * std::sqrt(curve.to)); }

/// Returns about the largest distance of two of its points. The middle of a curved piece may be much farther away than
/// its ends.
double extentOf(const Outline& outline) {
  const Point reference = referenceOf(outline);
  double extent = 0;
  const auto take = [&](Point p) { extent = std::max(extent, largestOf({p.x - reference.x, p.y - reference.y})); };
  for (const auto& loop : outline) {
    for (const OutlinePiece& piece : loop) {
      const EdgeCurve& curve = piece.curve;
      take(curve.start);
      if (!curve.isStraight()) take(middleOf(curve));
    }
  }
  return extent;
}

Moments momentsOf(const Outline& outline, double unit) {
  const Point reference = referenceOf(outline);
  const auto toPoint = [&](Point p) { return measuredIn(unit, {p.x - reference.x, p.y - reference.y}); };
  Moments sum;
  for (const auto& loop : outline) {
    for (const OutlinePiece& piece : loop) {
      const Vector u = toPoint(piece.curve.start);
      const Vector v = toPoint(piece.curve.end);
      const double triangle = cross(u, v) / 2;
      const Moments beyond = piece.isOnCircle() ? momentsOverChord(circleArc(piece), reference, unit)
                                                : momentsOverChord(piece.curve, reference, unit);
      sum.area += triangle + beyond.area;
      sum.x += triangle * (u.x + v.x) / 3 + beyond.x;
      sum.y += triangle * (u.y + v.y) / 3 + beyond.y;
    }
  }
  return sum;
}

}  // namespace

Outline outline(const Diagram& diagram, CircleIndex circle) {
  std::vector<OutlinePiece> loop;
  for (const SideIndex side : diagram.sides(circle)) {
    loop.push_back({sideCurve(diagram, side), side, diagram.neighborOf(side)});
    if (!loop.back().curve.isBounded()) return {};
  }
  return loop.empty() ? Outline{} : Outline{std::move(loop)};
}

double area(const Outline& outline) {
  if (outline.empty()) return 0;
  const double unit = unitFor(extentOf(outline));
  return momentsOf(outline, unit).area * unit * unit;
}

Point centroid(const Outline& outline) {
  if (outline.empty()) return {};
  const Point reference = referenceOf(outline);
  const double extent = extentOf(outline);
  const double unit = unitFor(extent);
  const Moments moments = momentsOf(outline, unit);
  if (extent > 0 && moments.area > kRoundingOfArea * (extent / unit) * (extent / unit)) {
    return {reference.x + unit * (moments.x / moments.area), reference.y + unit * (moments.y / moments.area)};
  }
  Vector sum;
  double count = 0;
  for (const auto& loop : outline) {
    for (const OutlinePiece& piece : loop) {
      sum.x += piece.curve.start.x - reference.x;
      sum.y += piece.curve.start.y - reference.y;
      ++count;
    }
  }
  return {reference.x + sum.x / count, reference.y + sum.y / count};
}

double perimeter(const Outline& outline) {
  double sum = 0;
  for (const auto& loop : outline) {
    for (const OutlinePiece& piece : loop) {
      sum += piece.isOnCircle() ? arcLength(circleArc(piece)) : arcLength(piece.curve);
    }
  }
  return sum;
}

}  // namespace circle_voronoi
