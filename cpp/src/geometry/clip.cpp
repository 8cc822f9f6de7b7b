// SPDX-License-Identifier: GPL-3.0-or-later
#include "clip.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "far_view.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

/// A parameter between two.
double between(double from, double to) {
  if (from == 0) return to == kInfinite ? 1 : to / 2;
  return to == kInfinite ? 2 * from : std::sqrt(from) * std::sqrt(to);
}

Point onSide(const ConvexPolygon& region, std::int32_t side, Point p) {
  const auto k = static_cast<std::size_t>(side);
  const Point from = region.corners()[k];
  const Point to = region.cornerAfter(k);
  const Vector direction = {to.x - from.x, to.y - from.y};
  const double unit = unitFor(largestOf(direction));
  const Vector along = measuredIn(unit, direction);
  const double share = dot(measuredIn(unit, {p.x - from.x, p.y - from.y}), along) / dot(along, along);
  if (share <= 0) return from;
  if (share >= 1) return to;
  return {from.x + share * direction.x, from.y + share * direction.y};
}

/// A range of the parameter, and the sides that cut it off.
struct Span {
  double from = 0;
  double to = 0;
  std::int32_t cutFrom = kNone;
  std::int32_t cutTo = kNone;
};

std::vector<Span> spansInside(const EdgeCurve& curve, const ConvexPolygon& region) {
  std::vector<Span> spans = {{curve.from, curve.to, kNone, kNone}};
  std::vector<Span> kept;
  for (std::size_t k = 0; k < region.size() && !spans.empty(); ++k) {
    const Point from = region.corners()[k];
    const Point to = region.cornerAfter(k);
    const LineCrossing crossing(curve.bisector, from, {to.x - from.x, to.y - from.y});
    const auto side = static_cast<std::int32_t>(k);
    kept.clear();
    for (Span rest : spans) {
      const auto keep = [&](const Span& span) {
        if (!crossing.isRight(span.from, span.to)) kept.push_back(span);
      };
      for (const double s : crossing.parameters()) {
        if (s <= rest.from || s >= rest.to) continue;
        keep({rest.from, s, rest.cutFrom, side});
        rest.from = s;
        rest.cutFrom = side;
      }
      keep(rest);
    }
    spans.swap(kept);
  }
  return spans;
}

/// How far what is in the region may be from a point, along one axis.
double reachFrom(Point p, const ConvexPolygon& region) {
  double reach = 0;
  for (const Point& corner : region.corners()) reach = std::max(reach, largestOf({corner.x - p.x, corner.y - p.y}));
  return reach;
}

}  // namespace

// With n the normal to the right of the line, n . (point(s) - p) > 0 becomes, multiplied by 2 s,
// (A + B) s^2 - 2 (A + k) s + (A - B) > 0, where A = -|a| n . along, B = b n . across, k = n . (p - origin - apex
// along). Only the ratios of A, B and k count. The direction is made short, since k is large where the circles are near
// one another.
LineCrossing::LineCrossing(const Bisector& bisector, Point p, Vector direction) {
  const double largest = largestOf(direction);
  const Vector along = measuredIn(largest > 0 ? powerOfTwoIn(largest) : 1, direction);
  const Vector normal = {along.y, -along.x};
  double a = -std::abs(bisector.a) * dot(normal, bisector.along);
  double b = bisector.b * dot(normal, bisector.across);
  double k = dot(normal, measuredIn(bisector.unit, {p.x - bisector.origin.x, p.y - bisector.origin.y})) -
             bisector.apex * dot(normal, bisector.along);
  const double unit = unitFor(std::max({std::abs(a), std::abs(b), std::abs(k)}));
  a /= unit;
  b /= unit;
  k /= unit;
  growth_ = a + b;
  half_ = a + k;
  decay_ = a - b;
  const double discriminant = k * (k + 2 * a) + b * b;
  if (!(discriminant > 0)) return;
  const double sum = half_ + std::copysign(std::sqrt(discriminant), half_);
  // The root of larger magnitude and the other one, each with the slope of the height there.
  const auto add = [&](double s, bool goesRight) {
    if (!(s > 0 && s < kInfinite)) return;
    parameters_[count_] = s;
    goesRight_[count_] = goesRight;
    ++count_;
  };
  add(sum / growth_, growth_ > 0);
  add(decay_ / sum, decay_ < 0);
  if (count_ == 2 && parameters_[0] > parameters_[1]) {
    std::swap(parameters_[0], parameters_[1]);
    std::swap(goesRight_[0], goesRight_[1]);
  }
}

bool LineCrossing::isRight(double from, double to) const {
  const double middle = between(from, to);
  const auto height = [&](double s) { return growth_ * s - 2 * half_ + decay_ / s; };
  // The branch may touch the line in one of any two points, but not in both.
  const double first = height(between(from, middle));
  const double second = height(between(middle, to));
  return (std::abs(first) > std::abs(second) ? first : second) > 0;
}

std::vector<CurvePart> partsInside(const EdgeCurve& whole, const ConvexPolygon& region) {
  const EdgeCurve curve = seenFrom(whole, reachFrom(whole.bisector.origin, region));
  std::vector<CurvePart> parts;
  for (const Span& span : spansInside(curve, region)) {
    CurvePart part = {curve, span.cutFrom, span.cutTo};
    part.curve.from = span.from;
    part.curve.to = span.to;
    if (span.cutFrom != kNone) part.curve.start = onSide(region, span.cutFrom, pointAt(curve.bisector, span.from));
    if (span.cutTo != kNone) part.curve.end = onSide(region, span.cutTo, pointAt(curve.bisector, span.to));
    if (part.curve.isBounded()) parts.push_back(part);
  }
  return parts;
}

// The distance apex + c (cosh t - 1) grows from the apex to both sides: the part is from 1 / s to s.
std::optional<CurvePart> partNear(const EdgeCurve& whole, double reach) {
  const EdgeCurve curve = seenFrom(whole, reach);
  const auto& bisector = curve.bisector;
  const double rise = (reach / bisector.unit - bisector.apex) / (bisector.apex + std::abs(bisector.a));
  if (!(rise > 0)) return std::nullopt;
  const double most = parameterAtRise(rise);
  CurvePart part = {curve};
  if (curve.from < 1 / most) {
    part.cutFrom = kCircleOfRing;
    part.curve.from = 1 / most;
    part.curve.start = pointAt(bisector, 1 / most);
  }
  if (curve.to > most) {
    part.cutTo = kCircleOfRing;
    part.curve.to = most;
    part.curve.end = pointAt(bisector, most);
  }
  if (part.curve.from > part.curve.to) return std::nullopt;
  return part;
}

std::vector<EdgeCurve> clip(const EdgeCurve& curve, const ConvexPolygon& region) {
  std::vector<EdgeCurve> pieces;
  for (const CurvePart& part : partsInside(curve, region)) pieces.push_back(part.curve);
  return pieces;
}

}  // namespace circle_voronoi
