// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "circle_voronoi/cells.h"
#include "circle_voronoi/finder.h"
#include "circle_voronoi/queries.h"
#include "clip.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

/// Where a disc touches a circle and a side, the two distances differ by less than this share.
constexpr double kRoundingOfPlace = 0x1p-31;
constexpr double kRoundingOfDepth = 0x1p-48;

/// The line of a side of the region, with the region on its left.
struct Side {
  Point corner;
  Vector inward;  ///< unit normal

  double depth(Point p) const { return dot(inward, {p.x - corner.x, p.y - corner.y}); }
};

/// The sides of a region; several on one line are one.
std::vector<Side> sidesOf(const ConvexPolygon& region) {
  std::vector<Side> sides;
  for (std::size_t k = 0; k < region.size(); ++k) {
    const auto directionOf = [&](std::size_t i) {
      const Point from = region.corners()[i];
      const Point to = region.cornerAfter(i);
      return Vector{to.x - from.x, to.y - from.y};
    };
    const Vector direction = directionOf(k);
    if (turn(directionOf(k == 0 ? region.size() - 1 : k - 1), direction) == 0) continue;
    const double size = lengthOf(direction);
    sides.push_back({region.corners()[k], {-direction.y / size, direction.x / size}});
  }
  return sides;
}

/// A segment of the medial axis of the region: points at the same depth from two sides, and from none less.
struct Ridge {
  Point from;
  Point to;
  double depthFrom = 0;
  double depthTo = 0;
};

/// The medial axis: of each side the part of the region to which it is the nearest, cut out of the region side by side.
std::vector<Ridge> ridgesOf(const ConvexPolygon& region, const std::vector<Side>& sides) {
  struct Corner {
    Point point;
    std::size_t cut;  ///< the side beyond the line from here to the next corner; itself: a side of the region
  };
  double extent = 0;
  for (const Point& p : region.corners()) {
    extent = std::max(extent, largestOf({p.x - region.corners()[0].x, p.y - region.corners()[0].y}));
  }
  std::vector<Ridge> ridges;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    std::vector<Corner> part;
    for (const Point& corner : region.corners()) part.push_back({corner, k});
    for (std::size_t j = 0; j < sides.size() && !part.empty(); ++j) {
      if (j == k) continue;
      const auto excess = [&](Point p) { return sides[k].depth(p) - sides[j].depth(p); };
      const double allowed = kRoundingOfDepth * extent;
      std::vector<Corner> kept;
      for (std::size_t i = 0; i < part.size(); ++i) {
        const Corner& here = part[i];
        const Corner& next = part[(i + 1) % part.size()];
        const double first = excess(here.point);
        const double second = excess(next.point);
        const bool isKept = first <= allowed;
        if (isKept) kept.push_back(here);
        if (isKept == (second <= allowed)) continue;
        const double share = std::clamp(first / (first - second), 0.0, 1.0);
        const Point p = {here.point.x + share * (next.point.x - here.point.x),
                         here.point.y + share * (next.point.y - here.point.y)};
        kept.push_back({p, isKept ? j : here.cut});
      }
      part.swap(kept);
    }
    for (std::size_t i = 0; i < part.size(); ++i) {
      // Each ridge belongs to two sides.
      if (part[i].cut <= k) continue;
      const Point from = part[i].point;
      const Point to = part[(i + 1) % part.size()].point;
      ridges.push_back({from, to, sides[k].depth(from), sides[k].depth(to)});
    }
  }
  return ridges;
}

/// The solutions of u^2 growth - 2 u half + decay = 0, given half^2 - growth decay.
std::array<double, 2> rootsOf(double growth, double half, double decay, double discriminant) {
  if (!(discriminant >= 0)) return {-1, -1};
  const double sum = half + std::copysign(std::sqrt(discriminant), half);
  return {sum / growth, decay / sum};
}

class Search {
 public:
  Search(const Diagram& diagram, const ConvexPolygon& region)
      : diagram_(diagram), region_(region), sides_(sidesOf(region)), finder_(diagram) {}

  std::optional<EmptyDisc> run() {
    // First what touches most circles: of equal discs the first is kept.
    offerVertices();
    offerAlongEdges();
    const std::vector<Ridge> ridges = ridgesOf(region_, sides_);
    for (const Ridge& ridge : ridges) {
      offer(ridge.from);
      offer(ridge.to);
    }
    for (const Ridge& ridge : ridges) offerAlongRidge(ridge);
    return best_;
  }

 private:
  double depthOf(Point p) const {
    double depth = kInfinite;
    for (const Side& side : sides_) depth = std::min(depth, side.depth(p));
    return depth;
  }
  double radius() const { return best_ ? best_->disc.r : -kInfinite; }

  void keep(Point p, double radius, const std::array<CircleIndex, 3>& circles) {
    if (radius > this->radius()) best_ = {{p.x, p.y, radius}, circles};
  }

  /// The largest disc around p, if it touches the circles named but for rounding.
  void offer(Point p, CircleIndex circle = kNone, CircleIndex other = kNone) {
    const double depth = depthOf(p);
    if (!(depth > radius())) return;
    const CircleIndex nearest = finder_.find(p, circle);
    const double distance = nearest == kNone ? kInfinite : distanceFrom(diagram_, nearest, p);
    if (circle == kNone) {
      if (distance <= depth) circle = nearest;
    } else {
      const double size = std::abs(p.x) + std::abs(p.y) + depth + std::abs(this->circle(circle).r);
      if (nearest != circle && nearest != other && distanceFrom(diagram_, circle, p) > distance + kRounding * size)
        return;
      // The disc of radius depth is too small to reach the circles: only sides bound it.
      if (distance > depth + kRounding * size + kRoundingOfPlace * depth) circle = other = kNone;
    }
    keep(p, std::min(depth, distance), {circle, other, kNone});
  }

  void offerVertices() {
    for (std::size_t v = 0; v < diagram_.vertices.size(); ++v) {
      const auto& [x, y, radius] = diagram_.vertices[v];
      if (radius > this->radius() && depthOf({x, y}) >= radius) keep({x, y}, radius, diagram_.vertexCircles[v]);
    }
  }

  /// Discs that touch two circles and a side. With n the normal of the side, D the depth of the curve's origin, and r
  /// the radius of its circle, the distance from the circle is the depth where (P - Q) s^2 - 2 K s + (P + Q) = 0, P = c
  /// + |a| n . along, Q = b n . across, K = D + r + c n . along + |a|, and K^2 - P^2 + Q^2 = (D + r) (D + r + 2 (c n .
  /// along + |a|)).
  void offerAlongEdges() {
    for (EdgeIndex e = 0; e < static_cast<std::int32_t>(diagram_.edges.size()); ++e) {
      const auto& [left, right, start, end] = diagram_.edges[static_cast<std::size_t>(e)];
      const auto radiusAt = [&](VertexIndex v) {
        return v == kNone ? kInfinite : diagram_.vertices[static_cast<std::size_t>(v)].r;
      };
      // Along an edge the distance is largest at one of its ends.
      if (std::max(radiusAt(start), radiusAt(end)) <= radius()) continue;
      for (const CurvePart& part : partsInside(boundedPart(edgeCurve(diagram_, e), region_), region_)) {
        const Bisector& bisector = part.curve.bisector;
        const double r = std::min(circle(left).r, circle(right).r);
        const double a = std::abs(bisector.a);
        const double c = bisector.apex + a;
        for (const Side& side : sides_) {
          const double along = dot(side.inward, bisector.along);
          const double p = c + a * along;
          const double q = bisector.b * dot(side.inward, bisector.across);
          const double reach = side.depth(bisector.origin) + r;
          const double bend = c * along + a;
          for (const double s : rootsOf(p - q, reach + bend, p + q, reach * (reach + 2 * bend))) {
            if (s >= part.curve.from * (1 - kRounding) && s <= part.curve.to * (1 + kRounding)) {
              offer(pointAt(bisector, s), left, right);
            }
          }
        }
      }
    }
  }

  /// Discs that touch a circle and two sides.
  void offerAlongRidge(const Ridge& ridge) {
    for (std::size_t i = 0; i < diagram_.circles.size(); ++i) {
      const CircleIndex index = static_cast<std::int32_t>(i);
      if (std::max(ridge.depthFrom, ridge.depthTo) <= radius()) return;
      if (!diagram_.hasCell(index)) continue;
      const auto& [x, y, r] = circle(index);
      const Vector toFrom = {ridge.from.x - x, ridge.from.y - y};
      const Vector step = {ridge.to.x - ridge.from.x, ridge.to.y - ridge.from.y};
      const double reach = ridge.depthFrom + r;
      const double rise = ridge.depthTo - ridge.depthFrom;
      const double size = length(step);
      const double distance = length(toFrom);
      const double growth = (size - rise) * (size + rise);
      const double half = reach * rise - dot(toFrom, step);
      const double decay = (distance - reach) * (distance + reach);
      for (const double u : rootsOf(growth, half, decay, half * half - growth * decay)) {
        if (!(u >= -kRounding && u <= 1 + kRounding)) continue;
        const double share = std::clamp(u, 0.0, 1.0);
        offer({ridge.from.x + share * step.x, ridge.from.y + share * step.y}, index);
      }
    }
  }

  const Circle& circle(CircleIndex i) const { return diagram_.circles[static_cast<std::size_t>(i)]; }

  const Diagram& diagram_;
  const ConvexPolygon& region_;
  std::vector<Side> sides_;
  Finder finder_;
  std::optional<EmptyDisc> best_;
};

}  // namespace

// The least of the distance from the nearest circle and the depth is largest where it cannot grow: not inside a cell or
// along an edge where a circle alone bounds it (there it grows away from the center, or from the apex); nor where one
// circle and one side do (to move along the side keeps the depth and gains distance). So the largest disc touches three
// circles, two and a side, one and two sides, or sides alone; the last two lie on the medial axis of the region. All
// candidates are tried, and each is shrunk until it is empty and inside. Therefore rounding cannot make a result too
// large.
std::optional<EmptyDisc> largestEmptyDiscInside(const Diagram& diagram, const ConvexPolygon& region) {
  const auto centered = largestEmptyDiscCenteredIn(diagram, region);
  if (centered && centered->disc.r <= 0) return centered;
  return Search(diagram, region).run();
}

}  // namespace circle_voronoi
