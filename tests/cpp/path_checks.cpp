// SPDX-License-Identifier: GPL-3.0-or-later
#include "path_checks.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace circle_voronoi::test {
namespace {

double distanceToSegment(Point p, Point a, Point b) {
  const double x = b.x - a.x;
  const double y = b.y - a.y;
  const double square = x * x + y * y;
  const double t = square == 0 ? 0 : std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / square, 0.0, 1.0);
  return std::hypot(a.x + t * x - p.x, a.y + t * y - p.y);
}

}  // namespace

double clearanceAlong(std::span<const Circle> circles, Point a, Point b) {
  double least = 1e300;
  for (const Circle& c : circles) least = std::min(least, distanceToSegment({c.x, c.y}, a, b) - c.r);
  return least;
}

std::vector<std::array<Point, 2>> sidesOf(const Region& region) {
  std::vector<std::array<Point, 2>> sides;
  const auto points = region.points();
  const auto rings = region.ringOffsets();
  for (std::size_t r = 0; r + 1 < rings.size(); ++r) {
    for (std::int32_t k = rings[r]; k < rings[r + 1]; ++k) {
      const std::int32_t next = k + 1 == rings[r + 1] ? rings[r] : k + 1;
      sides.push_back({points[static_cast<std::size_t>(k)], points[static_cast<std::size_t>(next)]});
    }
  }
  return sides;
}

PartsOfRegion::PartsOfRegion(const Region& region) : parents_(region.polygonCount()) {
  std::iota(parents_.begin(), parents_.end(), 0);
  const auto rings = region.ringOffsets();
  for (std::size_t k = 0; k < region.polygonCount(); ++k) {
    std::vector<Region::Ring> its;
    for (std::int32_t r = region.polygonOffsets()[k]; r < region.polygonOffsets()[k + 1]; ++r) {
      const auto at = static_cast<std::size_t>(r);
      its.emplace_back(region.points().begin() + rings[at], region.points().begin() + rings[at + 1]);
    }
    polygons_.push_back(Region::fromPolygons(std::vector<std::vector<Region::Ring>>{its}).value());
  }
  for (std::size_t k = 0; k < polygons_.size(); ++k) {
    for (const Point& p : polygons_[k].points()) {
      for (std::size_t other = 0; other < polygons_.size(); ++other) {
        if (polygons_[other].contains(p)) parents_[find(other)] = find(k);
      }
    }
  }
}

bool PartsOfRegion::areTogether(Point p, Point q) { return partOf(p) == partOf(q); }

std::size_t PartsOfRegion::partOf(Point p) {
  for (std::size_t k = 0; k < polygons_.size(); ++k) {
    if (polygons_[k].contains(p)) return find(k);
  }
  return polygons_.size();
}

std::size_t PartsOfRegion::find(std::size_t k) {
  while (parents_[k] != k) k = parents_[k];
  return k;
}

std::string faultOf(const Region& region, std::span<const Circle> circles, Point p, Point q, const ClearestPath& path,
                    double tolerance) {
  const auto textOf = [](Point point) {
    std::ostringstream text;
    text << '(' << point.x << ", " << point.y << ')';
    return text.str();
  };
  const auto sides = sidesOf(region);
  const auto isNear = [&](Point point) {
    if (region.contains(point)) return true;
    return std::ranges::any_of(
        sides, [&](const auto& side) { return distanceToSegment(point, side[0], side[1]) < tolerance; });
  };
  double least = clearanceAlong(circles, p, p);
  Point last = p;
  for (const EdgeCurve& curve : path.curves) {
    if (curve.start != last) return "There is a gap at " + textOf(last) + ".";
    last = curve.end;
    Point before = curve.start;
    constexpr int kSamples = 16;
    for (int k = 1; k <= kSamples; ++k) {
      const double share = static_cast<double>(k) / kSamples;
      Point point = {curve.start.x + share * (curve.end.x - curve.start.x),
                     curve.start.y + share * (curve.end.y - curve.start.y)};
      if (!curve.isStraight() && k < kSamples) {
        point = pointAt(curve.bisector, curve.from * std::pow(curve.to / curve.from, share));
      }
      if (!isNear(point)) return textOf(point) + " lies outside the region.";
      if (curve.isStraight()) {
        least = std::min(least, clearanceAlong(circles, before, point));
      } else {
        const double apex = curve.from <= 1 && 1 <= curve.to ? 1 : curve.from;
        for (const Point sample : {point, pointAt(curve.bisector, apex)}) {
          least = std::min(least, clearanceAlong(circles, sample, sample));
        }
      }
      before = point;
    }
  }
  if (last != q) return "The path ends at " + textOf(last) + ".";
  if (!(std::abs(least - path.clearance) <= tolerance)) {
    return "The clearance is " + std::to_string(least) + ", not " + std::to_string(path.clearance) + ".";
  }
  return "";
}

}  // namespace circle_voronoi::test
