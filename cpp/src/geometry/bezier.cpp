// SPDX-License-Identifier: GPL-3.0-or-later
// Arcs of bisectors as Bezier curves and polylines.
//
// Each error depends on the middle of an arc's range and on its half-width h alone, since multiplying the parameter is
// an affine map. Let w = cosh h, the weight of the arc as a rational Bezier curve, be
//
//     w = (sqrt(to / from) + sqrt(from / to)) / 2.
#include <algorithm>
#include <cmath>

#include "chord.h"
#include "circle_voronoi/curve.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

/// w - 1
double excessOf(double from, double to) {
  const double difference = std::sqrt(to) - std::sqrt(from);
  return difference / std::sqrt(from) * (difference / std::sqrt(to)) / 2;
}

/// The largest distance of an arc from its chord, or a bound. On one side of the apex the arc turns by less than a
/// right angle, so the distance is largest at the middle parameter, where the tangent is parallel to the chord: w - 1
/// times the distance of that tangent from the middle of the hyperbola. An arc around the apex may be a needle, nearer
/// to the line of its chord than to its chord: what counts there is the way parallel to the axis, at most w - 1 times
/// |a|.
double chordError(const Bisector& bisector, double from, double to) {
  if (bisector.a == 0) return 0;
  const double along = excessOf(from, to) * std::abs(bisector.a);
  if (from < 1 && 1 < to) return along;
  const double middle = std::sqrt(from) * std::sqrt(to);
  const double x = bisector.a * (middle - 1 / middle) / 2;
  const double y = bisector.b * (middle + 1 / middle) / 2;
  return along * (bisector.b / lengthOf({x, y}));
}

/// A bound for the largest distance of an arc from the cubic with its tangents at both ends and its middle point.
///
/// In the affine frame where the arc is (cosh t, sinh t), |t| <= h, the cubic (X, Y)(u) has
///
///     X^2 - Y^2 = 1 - 4 (w - 1)^3 / (w + 1) q^2 (1 - 4 q),      q = u (1 - u),
///
/// so 0 <= 1 - X^2 + Y^2 <= f = (w - 1)^3 / (27 (w + 1)). That holds in the frame of the hyperbola's axes as well,
/// where the way to the branch along one axis is at most |a| f / (2 k cosh t), along the other b f / (k sinh t), with
/// k^2 = 1 - f and t the parameter of the arc nearest to the apex.
double cubicError(const Bisector& bisector, double from, double to) {
  const double excess = excessOf(from, to);
  const double f = excess * excess * excess / (27 * (excess + 2));
  if (!(f < 0.5)) return kInfinite;
  const double k = std::sqrt(1 - f);
  const double nearest = std::clamp(1.0, from, to);
  const double sine = std::abs(nearest - 1 / nearest) / 2;
  const double cosine = (nearest + 1 / nearest) / 2;
  const double error = std::abs(bisector.a) * f / (2 * k * cosine);
  return k * k * sine * sine > f ? std::min(error, bisector.b * f / (k * sine)) : error;
}

/// Returns the quotient of the parameters at the ends of an arc with a given w - 1.
double quotientOf(double excess) {
  const double root = 1 + excess + std::sqrt(excess * (excess + 2));
  return root * root;
}

/// Returns the largest parameter up to `to` at which an arc is still within the tolerance of its chord, except for a
/// few percent of the way.
double farthestByChord(const Bisector& bisector, double from, double to, double tolerance) {
  if (!(chordError(bisector, from, to) > tolerance)) return to;
  constexpr double kNearlyAll = 15.0 / 16;
  constexpr int kMostSteps = 50;
  // The error is w - 1 times a factor that is |a| around the apex, at most |a| elsewhere, and changes slowly.
  double excess = tolerance / std::abs(bisector.a);
  double good = from;
  double bad = to;
  if (from < 1 && 1 < to) {
    const double end = from * quotientOf(excess);
    if (end >= 1) return end;
    if (!(chordError(bisector, from, 1) > tolerance)) return 1;
    bad = 1;
  }
  for (int i = 0; i < kMostSteps; ++i) {
    const double proposed = from * quotientOf(excess);
    const double next = good < proposed && proposed < bad ? proposed : std::sqrt(good) * std::sqrt(bad);
    const double error = chordError(bisector, from, next);
    if (error > tolerance) {
      bad = next;
    } else {
      good = next;
      if (error >= kNearlyAll * tolerance) break;
    }
    excess = excessOf(from, next) * (tolerance / error);
  }
  return good > from ? good : bad;
}

/// Returns the largest parameter up to `to` at which an arc is still within the tolerance of its cubic, except for a
/// few percent of the way. The error grows with the parameter.
double farthestByCubic(const Bisector& bisector, double from, double to, double tolerance) {
  if (!(cubicError(bisector, from, to) > tolerance)) return to;
  constexpr int kHalvings = 50;
  constexpr double kNearEnough = 1.0 / 32;
  double good = from;
  double bad = to;
  for (int i = 0; i < kHalvings && bad - good > kNearEnough * (good - from); ++i) {
    const double middle = std::sqrt(good) * std::sqrt(bad);
    (cubicError(bisector, from, middle) <= tolerance ? good : bad) = middle;
  }
  return good > from ? good : bad;
}

/// A tolerance, and not below a share of the arc's extent.
double atLeast(double share, const EdgeCurve& curve, double tolerance) {
  const double chord = lengthOf({curve.end.x - curve.start.x, curve.end.y - curve.start.y});
  const double least = share * (chord + chordError(curve.bisector, curve.from, curve.to));
  return tolerance > least ? tolerance : least;
}

/// Whether an arc is nearer to its chord than a tolerance, quickly; not so if that is not
/// plain. The error is at most w - 1 times |a| but for rounding.
bool isPlainlyStraight(const EdgeCurve& curve, double tolerance) {
  constexpr double kShare = 1 - 0x1p-40;
  return excessOf(curve.from, curve.to) * std::abs(curve.bisector.a) <= kShare * tolerance;
}

Point mix(Point p, Point q, double share) { return {p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)}; }

/// The intersection of the tangents at two parameters: the polar form of the branch.
Point control(const Bisector& bisector, double from, double to) {
  const double along = bisector.apex - std::abs(bisector.a) * ((from - 1) / (from + to) * (to - 1));
  const double across = bisector.b * (from / (from + to) * to - 1 / (from + to));
  return {bisector.origin.x + (along * bisector.along.x + across * bisector.across.x),
          bisector.origin.y + (along * bisector.along.y + across * bisector.across.y)};
}

RationalBezier rationalBezier(const Bisector& bisector, double from, double to, Point start, Point end) {
  return {start, control(bisector, from, to), end, 1 + excessOf(from, to)};
}

CubicBezier line(Point start, Point end) { return {start, mix(start, end, 1.0 / 3), mix(end, start, 1.0 / 3), end}; }

CubicBezier cubic(const RationalBezier& arc) {
  const double share = 4 * arc.weight / (3 * (1 + arc.weight));
  return {arc.start, mix(arc.start, arc.control, share), mix(arc.end, arc.control, share), arc.end};
}

}  // namespace

RationalBezier rationalBezier(const EdgeCurve& curve) {
  return rationalBezier(curve.bisector, curve.from, curve.to, curve.start, curve.end);
}

Point pointAt(const RationalBezier& bezier, double u) {
  const double first = (1 - u) * (1 - u);
  const double second = 2 * u * (1 - u) * bezier.weight;
  const double third = u * u;
  const double sum = first + second + third;
  return {(first * bezier.start.x + second * bezier.control.x + third * bezier.end.x) / sum,
          (first * bezier.start.y + second * bezier.control.y + third * bezier.end.y) / sum};
}

std::vector<CubicBezier> cubicBeziers(const EdgeCurve& curve, double tolerance) {
  tolerance = atLeast(1e-12, curve, tolerance);
  std::vector<CubicBezier> pieces;
  double from = curve.from;
  Point start = curve.start;
  for (bool isLast = false; !isLast;) {
    const bool byOneCubic = chordError(curve.bisector, from, curve.to) > tolerance &&
                            !(cubicError(curve.bisector, from, curve.to) > tolerance);
    const double byLine = byOneCubic ? from : farthestByChord(curve.bisector, from, curve.to, tolerance);
    const double byCubic =
        byOneCubic || byLine == curve.to ? curve.to : farthestByCubic(curve.bisector, from, curve.to, tolerance);
    const double to = std::max(byLine, byCubic);
    isLast = !(to < curve.to);
    const Point end = isLast ? curve.end : pointAt(curve.bisector, to);
    pieces.push_back(byCubic > byLine ? cubic(rationalBezier(curve.bisector, from, to, start, end)) : line(start, end));
    from = to;
    start = end;
  }
  return pieces;
}

bool isNearChord(const EdgeCurve& curve, double tolerance) {
  // Most arcs are short.
  if (curve.isStraight() || isPlainlyStraight(curve, tolerance)) return true;
  return !(chordError(curve.bisector, curve.from, curve.to) > atLeast(kFinestPolyline, curve, tolerance));
}

std::vector<Point> polyline(const EdgeCurve& curve, double tolerance) {
  if (isNearChord(curve, tolerance)) return {curve.start, curve.end};
  tolerance = atLeast(kFinestPolyline, curve, tolerance);
  std::vector<Point> points = {curve.start};
  double from = farthestByChord(curve.bisector, curve.from, curve.to, tolerance);
  while (from < curve.to) {
    points.push_back(pointAt(curve.bisector, from));
    from = farthestByChord(curve.bisector, from, curve.to, tolerance);
  }
  points.push_back(curve.end);
  return points;
}

}  // namespace circle_voronoi
