// SPDX-License-Identifier: GPL-3.0-or-later
#include "path_checks.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace circle_voronoi::test {
double clearanceAlong(std::span<const Circle> circles, Point a, Point b) {
  double least = 1e300;
  for (const Circle& c : circles) least = std::min(least, distanceToSide({c.x, c.y}, {a, b}) - c.r);
  return least;
}

PartsOfRegion::PartsOfRegion(const Region& region) : parents_(region.polygonCount()) {
  std::iota(parents_.begin(), parents_.end(), 0);
  for (const auto& rings : polygonsOf(region)) {
    polygons_.push_back(Region::fromPolygons(std::vector<std::vector<Region::Ring>>{rings}).value());
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
    return std::ranges::any_of(sides, [&](const auto& side) { return distanceToSide(point, side) < tolerance; });
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
