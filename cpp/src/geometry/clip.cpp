// SPDX-License-Identifier: GPL-3.0-or-later
#include "clip.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "parameter_at_distance.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

/// Ends at infinity are moved to that many times the distance of the region from the centers. From there, its
/// directions are those at infinity up to a few degrees.
constexpr double kFar = 64;

const HalfPlane* halfOf(std::int32_t cut, std::span<const HalfPlane> halves) {
  const auto found = std::ranges::find(halves, cut, &HalfPlane::side);
  return found == halves.end() ? nullptr : &*found;
}

}  // namespace

HalfPlane::HalfPlane(std::size_t side, Point from, Point to)
    : side_(static_cast<std::int32_t>(side)), from_(from), to_(to) {
  const Vector direction = vectorTo(from, to);
  along_ = measuredIn(powerOfTwoIn(largestOf(direction)), direction);
}

Point HalfPlane::nearest(Point p) const {
  const double share = place(p) / dot(along_, along_);
  return {from_.x + share * along_.x, from_.y + share * along_.y};
}

Point HalfPlane::onSide(Point p) const {
  const double ahead = place(p);
  return ahead <= 0 ? from_ : ahead >= place(to_) ? to_ : p;
}

std::vector<HalfPlane> halfPlanesOf(const ConvexPolygon& region) {
  const auto corners = region.corners();
  std::vector<std::size_t> sides;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Point before = corners[k == 0 ? corners.size() - 1 : k - 1];
    if (turn(vectorTo(before, corners[k]), vectorTo(corners[k], region.cornerAfter(k))) != 0) sides.push_back(k);
  }
  std::vector<HalfPlane> halves;
  halves.reserve(sides.size());
  for (std::size_t i = 0; i < sides.size(); ++i) {
    halves.emplace_back(sides[i], corners[sides[i]], corners[sides[(i + 1) % sides.size()]]);
  }
  return halves;
}

double reachFrom(Point p, const ConvexPolygon& region) {
  double reach = 0;
  for (const Point& corner : region.corners()) reach = std::max(reach, largestOf({corner.x - p.x, corner.y - p.y}));
  return reach;
}

CurvePart boundedPart(const EdgeCurve& whole, const ConvexPolygon& region) {
  const double reach = std::max(reachFrom(whole.bisector.left, region), reachFrom(whole.bisector.right, region));
  CurvePart part = {whole};
  EdgeCurve& curve = part.curve;
  if (curve.isBounded()) return part;
  const auto& bisector = curve.bisector;
  const double apex = std::abs(bisector.apex);
  const double most = parameterAtDistance(bisector, kFar * std::max(reach, apex));
  if (curve.startsAtInfinity()) {
    part.cutFrom = kFarCut;
    curve.from = std::min(1 / most, curve.to);
    curve.start = curve.from == curve.to ? curve.end : pointAt(bisector, curve.from);
  }
  if (curve.endsAtInfinity()) {
    part.cutTo = kFarCut;
    curve.to = std::max(most, curve.from);
    curve.end = curve.from == curve.to ? curve.start : pointAt(bisector, curve.to);
  }
  return part;
}

// The points that pieces share decide which ends are inside. A root only says where: it is moved to the end that it
// should not be beyond. So rounding moves an end by as little as the line, and the pieces of a loop stay linked.
std::size_t cutPart(const CurvePart& part, const HalfPlane& half, std::array<CurvePart, 2>& kept) {
  const EdgeCurve& curve = part.curve;
  const double first = half.height(curve.start);
  const double last = half.height(curve.end);
  const bool hasStart = first >= 0;
  const bool hasEnd = last >= 0;
  kept[0] = part;
  // A straight line crosses once.
  if (curve.isStraight() && hasStart == hasEnd) return hasStart ? 1 : 0;
  const LineCrossing line(curve.bisector, half.from(), half.along());
  const auto s = line.parameters();
  const auto endAt = [&](CurvePart& target, double parameter) {
    target.curve.to = parameter;
    target.cutTo = half.side();
    target.curve.end =
        parameter == curve.from && hasStart ? curve.start : half.nearest(pointAt(curve.bisector, parameter));
  };
  const auto startAt = [&](CurvePart& target, double parameter) {
    target.curve.from = parameter;
    target.cutFrom = half.side();
    target.curve.start = parameter == curve.to && hasEnd ? curve.end : half.nearest(pointAt(curve.bisector, parameter));
  };
  if (hasStart != hasEnd) {
    double crossing = std::abs(first) < std::abs(last) ? curve.from : curve.to;
    for (std::size_t k = 0; k < s.size(); ++k) {
      if (line.goesRight(k) == hasStart) crossing = std::clamp(s[k], curve.from, curve.to);
    }
    if (hasStart) {
      endAt(kept[0], crossing);
    } else {
      startAt(kept[0], crossing);
    }
    return 1;
  }
  const auto turning = line.turningPoint(hasStart);
  if (!turning || !(curve.from < *turning && *turning < curve.to)) return hasStart ? 1 : 0;
  const double early = std::max(s[0], curve.from);
  const double late = std::min(s[1], curve.to);
  if (!hasStart) {
    startAt(kept[0], early);
    endAt(kept[0], late);
    return 1;
  }
  kept[1] = part;
  endAt(kept[0], early);
  startAt(kept[1], late);
  return 2;
}

void moveOntoSides(CurvePart& part, std::span<const HalfPlane> halves) {
  if (const HalfPlane* half = halfOf(part.cutFrom, halves)) part.curve.start = half->onSide(part.curve.start);
  if (const HalfPlane* half = halfOf(part.cutTo, halves)) part.curve.end = half->onSide(part.curve.end);
}

std::vector<CurvePart> partsInside(const CurvePart& part, const ConvexPolygon& region) {
  const std::vector<HalfPlane> halves = halfPlanesOf(region);
  std::vector<CurvePart> parts = {part};
  std::vector<CurvePart> next;
  std::array<CurvePart, 2> kept;
  for (const HalfPlane& half : halves) {
    next.clear();
    for (const CurvePart& rest : parts) {
      const std::size_t count = cutPart(rest, half, kept);
      for (std::size_t k = 0; k < count; ++k) {
        if (!kept[k].isPoint()) next.push_back(kept[k]);
      }
    }
    parts.swap(next);
  }
  for (CurvePart& rest : parts) moveOntoSides(rest, halves);
  std::erase_if(parts, [](const CurvePart& rest) { return rest.isPoint(); });
  return parts;
}

// The distance grows from the apex to both sides: the part is from 1 / s to s.
std::optional<CurvePart> partNear(const EdgeCurve& curve, double reach) {
  const auto& bisector = curve.bisector;
  if (!(reach > bisector.apex)) return std::nullopt;
  const double most = parameterAtDistance(bisector, reach);
  CurvePart part = {curve};
  if (curve.from < 1 / most) {
    part.cutFrom = kCircleCut;
    part.curve.from = 1 / most;
    part.curve.start = pointAt(bisector, 1 / most);
  }
  if (curve.to > most) {
    part.cutTo = kCircleCut;
    part.curve.to = most;
    part.curve.end = pointAt(bisector, most);
  }
  if (part.curve.from > part.curve.to) return std::nullopt;
  return part;
}

// With n the normal to the right of the line, n . (point(s) - p) > 0 becomes, multiplied by 2 s,
// (A + B) s^2 - 2 (A + k) s + (A - B) > 0, where A = -|a| n . along, B = b n . across, k = n . (p - origin - apex
// along). Only the ratios of A, B and k count.
LineCrossing::LineCrossing(const Bisector& bisector, Point p, Vector direction) {
  const Vector normal = {direction.y, -direction.x};
  const double a = -std::abs(bisector.a) * dot(normal, bisector.along);
  const double b = bisector.b * dot(normal, bisector.across);
  const double k = dot(normal, vectorTo(bisector.origin, p)) - bisector.apex * dot(normal, bisector.along);
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

std::optional<double> LineCrossing::turningPoint(bool right) const {
  if (count_ < 2 || (growth_ < 0) != right) return std::nullopt;
  return std::sqrt(decay_ / growth_);
}

std::vector<EdgeCurve> clip(const EdgeCurve& curve, const ConvexPolygon& region) {
  std::vector<EdgeCurve> pieces;
  for (const CurvePart& part : partsInside(boundedPart(curve, region), region)) pieces.push_back(part.curve);
  return pieces;
}

}  // namespace circle_voronoi
