// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/convex_polygon.h"

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "circle_voronoi/limits.h"
#include "guarded.h"
#include "rounded.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

Error fail(std::string message) { return {ErrorCode::badOption, kNone, std::move(message)}; }

/// Returns an error if a coordinate is out of range.
std::string notInRange(const char* whose) {
  return std::string(whose) + " is not finite, or beyond " + kRegionLimitText + ".";
}

/// Also false for NaN.
bool isInRange(double coordinate) { return std::abs(coordinate) <= kRegionLimit; }

/// Whether a direction lies in the half-open upper half-plane; it changes twice in each full turn.
bool isUpper(Vector v) { return v.y > 0 || (v.y == 0 && v.x > 0); }

/// Returns an error if the corners do not form a convex polygon.
std::optional<std::string> problemOf(std::span<const Point> corners) {
  if (corners.size() < 3) return "A convex polygon needs three corners or more.";
  for (const Point& p : corners) {
    if (!isInRange(p.x) || !isInRange(p.y)) return notInRange("A corner of the polygon");
  }
  const std::size_t n = corners.size();
  int halfTurns = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vector in = vectorTo(corners[i], corners[(i + 1) % n]);
    const Vector out = vectorTo(corners[(i + 1) % n], corners[(i + 2) % n]);
    if (in.x == 0 && in.y == 0) return "Two corners of the polygon in a row are equal.";
    const double side = turn(in, out);
    if (side < 0 || (side == 0 && facing(in, out) < 0)) {
      return "The polygon is not convex, or its corners are not counter-clockwise.";
    }
    if (isUpper(in) != isUpper(out)) ++halfTurns;
  }
  if (halfTurns == 2) return std::nullopt;
  return "The polygon winds more than once, or has no area.";
}

}  // namespace

Result<ConvexPolygon> ConvexPolygon::from(const Box& box) {
  return guarded([&]() -> Result<ConvexPolygon> {
    if (!isInRange(box.minX) || !isInRange(box.minY) || !isInRange(box.maxX) || !isInRange(box.maxY)) {
      return fail(notInRange("A coordinate of the box"));
    }
    const auto [minX, minY] = rounded(Point{box.minX, box.minY});
    const auto [maxX, maxY] = rounded(Point{box.maxX, box.maxY});
    if (!(minX < maxX && minY < maxY)) return fail("The box is empty.");
    return ConvexPolygon(std::vector<Point>{{minX, minY}, {maxX, minY}, {maxX, maxY}, {minX, maxY}});
  });
}

Result<ConvexPolygon> ConvexPolygon::from(std::span<const Point> corners) {
  return guarded([&]() -> Result<ConvexPolygon> {
    std::vector<Point> result;
    for (const Point& p : corners) result.push_back(rounded(p));
    if (auto problem = problemOf(result)) return fail(*std::move(problem));
    return ConvexPolygon(std::move(result));
  });
}

bool ConvexPolygon::contains(Point p) const {
  for (std::size_t k = 0; k < size(); ++k) {
    if (turn(vectorTo(corners_[k], cornerAfter(k)), vectorTo(corners_[k], p)) < 0) return false;
  }
  return true;
}

double ConvexPolygon::area() const {
  double twice = 0;
  for (std::size_t k = 0; k < size(); ++k) {
    twice += cross(vectorTo(corners_[0], corners_[k]), vectorTo(corners_[0], cornerAfter(k)));
  }
  return twice / 2;
}

Point ConvexPolygon::middle() const {
  Point sum;
  for (const Point& p : corners_) {
    sum.x += p.x / static_cast<double>(size());
    sum.y += p.y / static_cast<double>(size());
  }
  return sum;
}

}  // namespace circle_voronoi
