// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_arc.h"

#include <algorithm>
#include <cmath>

#include "carlson.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

/// They make kFinestPolyline of any arc, of half a turn at most.
constexpr int kMostHalvings = 16;

/// An arc by half its angle h: sin h and cos h, and R_F and R_D of (cos^2 h, 1, 1), for which
///
///     h = sin h R_F,        h - sin h cos h = 2 / 3 sin^3 h R_D,
///
/// which has no cancellation and needs no functions that differ between platforms (DLMF 19.25).
struct HalfAngle {
  double sine;
  double cosine;
  Carlson carlson;

  explicit HalfAngle(const CircleArc& arc)
      : sine(std::min(lengthOf({arc.end.x - arc.start.x, arc.end.y - arc.start.y}) / arc.r / 2, 1.0)),
        cosine(std::sqrt((1 - sine) * (1 + sine))),
        carlson(circle_voronoi::carlson(cosine, 1, 1)) {}
};

/// The point in the middle of an arc: beyond the middle of the chord by 1 - cos h = sin h tan (h / 2).
Point middleOf(const CircleArc& arc) {
  const Vector chord = {arc.end.x - arc.start.x, arc.end.y - arc.start.y};
  const HalfAngle half(arc);
  const double rise = half.sine / (1 + half.cosine) / 2;
  return {arc.start.x + chord.x / 2 + rise * chord.y, arc.start.y + chord.y / 2 - rise * chord.x};
}

}  // namespace

double arcLength(const CircleArc& arc) {
  const HalfAngle half(arc);
  return 2 * arc.r * half.sine * half.carlson.first;
}

// The center of mass is 2 / 3 sin^3 h / (h - sin h cos h) radii from the circle's center, and the chord cos h.
Moments momentsOverChord(const CircleArc& arc, Point reference, double unit) {
  const Vector chord = measuredIn(unit, {arc.end.x - arc.start.x, arc.end.y - arc.start.y});
  const double size = length(chord);
  if (size == 0) return {};
  const HalfAngle half(arc);
  const double area = half.sine * (size / 2) * (size / 2) * (2.0 / 3) * half.carlson.second;
  const double beyond = arc.r / unit * (1 / half.carlson.second - half.cosine);
  const Vector toStart = measuredIn(unit, {arc.start.x - reference.x, arc.start.y - reference.y});
  return {area, area * (toStart.x + chord.x / 2 + beyond * chord.y / size),
          area * (toStart.y + chord.y / 2 - beyond * chord.x / size)};
}

std::vector<Point> polyline(const CircleArc& arc, double tolerance) {
  const double least = std::max(tolerance, kFinestPolyline * arc.r);
  std::vector<Point> points = {arc.start, arc.end};
  // Half of a part has about a quarter of the part's sagitta.
  const auto isCoarse = [&](Point p, Point q) {
    const HalfAngle half({p, q, arc.r});
    return arc.r * half.sine * (half.sine / (1 + half.cosine)) > least;
  };
  for (int k = 0; k < kMostHalvings && isCoarse(points[0], points[1]); ++k) {
    const Point middle = middleOf({points[0], points[1], arc.r});
    // There is no point between two adjacent points of the grid of doubles.
    const auto isMiddle = [&](Point p) { return p.x == middle.x && p.y == middle.y; };
    if (isMiddle(points[0]) || isMiddle(points[1])) break;
    std::vector<Point> finer = {points.front()};
    for (std::size_t i = 1; i < points.size(); ++i) {
      finer.push_back(middleOf({points[i - 1], points[i], arc.r}));
      finer.push_back(points[i]);
    }
    points = std::move(finer);
  }
  return points;
}

}  // namespace circle_voronoi
