// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <queue>
#include <utility>
#include <vector>

#include "at.h"
#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/region_queries.h"
#include "guarded.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

/// With at most this number of circles and sides nearby, all triples are tried.
constexpr std::size_t kFew = 10;
/// Squares smaller than this share of the region are points up to rounding.
constexpr double kFinestSquare = 0x1p-50;
/// A disc touches circles and sides at a distance of its radius, up to this share of the region.
constexpr double kRoundingOfTouch = 0x1p-44;
constexpr int kRefinements = 2;

/// A vector of the place of a disc: its center and its radius.
struct DiscPlace {
  double x = 0;
  double y = 0;
  double r = 0;
};

DiscPlace crossOf(const DiscPlace& u, const DiscPlace& v) {
  return {u.y * v.r - u.r * v.y, u.r * v.x - u.x * v.r, u.x * v.y - u.y * v.x};
}
double dotOf(const DiscPlace& u, const DiscPlace& v) { return u.x * v.x + u.y * v.y + u.r * v.r; }

/// An object that a disc may touch: a circle, a corner (a circle of radius 0) or the line of a side.
struct Touchable {
  Point point;    ///< the center, or a point of the line
  Vector inward;  ///< for a line, the unit normal to the side of the region; otherwise (0, 0)
  double r = 0;   ///< the radius of a circle
  bool isLine = false;

  /// Returns the distance of a point, and in which direction it grows.
  std::pair<double, Vector> distance(Point p) const {
    const Vector v = vectorTo(point, p);
    if (isLine) return {dot(inward, v), inward};
    const double size = lengthOf(v);
    return {size - r, size > 0 ? measuredIn(size, v) : Vector{1, 0}};
  }
};

/// A linear equation of a place: row . place = value.
struct Equation {
  DiscPlace row;
  double value = 0;
};

/// Solves three equations. Returns nothing if they are not independent.
std::optional<DiscPlace> solved(const std::array<Equation, 3>& equations) {
  // Clang 14 captures no structured bindings.
  const Equation& first = equations[0];
  const Equation& second = equations[1];
  const Equation& third = equations[2];
  const DiscPlace sides = crossOf(second.row, third.row);
  const double volume = dotOf(first.row, sides);
  if (volume == 0) return std::nullopt;
  const DiscPlace v = crossOf(third.row, first.row);
  const DiscPlace w = crossOf(first.row, second.row);
  const auto sum = [&](double DiscPlace::*axis) {
    return (first.value * sides.*axis + second.value * v.*axis + third.value * w.*axis) / volume;
  };
  return DiscPlace{sum(&DiscPlace::x), sum(&DiscPlace::y), sum(&DiscPlace::r)};
}

/// Calls `take` with each place of a disc that touches three things from outside.
///
/// Relative to the center of a circle of radius r, with q = rho + r, the center of a disc of radius rho that touches it
/// is on the cone |p| = q. The difference of two such equations is linear in p and q, and so is that of a line. Two
/// linear equations determine a line in space, which meets the cone twice.
template <class Take>
void placesTouching(std::array<const Touchable*, 3> things, Take take) {
  const auto refined = [&](DiscPlace place) {
    for (int round = 0; round < kRefinements; ++round) {
      std::array<Equation, 3> equations;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [distance, direction] = things[k]->distance({place.x, place.y});
        equations[k] = {{direction.x, direction.y, -1}, place.r - distance};
      }
      const auto step = solved(equations);
      // If the equations are nearly dependent, the place may be inaccurate.
      if (!step || !(std::abs(step->x) + std::abs(step->y) + std::abs(step->r) < 1e-4)) break;
      place = {place.x + step->x, place.y + step->y, place.r + step->r};
    }
    take(Point{place.x, place.y});
  };
  std::ranges::sort(things, {}, &Touchable::isLine);
  const auto lineEquation = [](const Touchable& line, Point origin, double r) {
    return Equation{{line.inward.x, line.inward.y, -1}, dot(line.inward, vectorTo(origin, line.point)) - r};
  };
  const Touchable& base = *things[0];
  if (base.isLine) {
    const auto place =
        solved({lineEquation(base, {}, 0), lineEquation(*things[1], {}, 0), lineEquation(*things[2], {}, 0)});
    if (place) refined(*place);
    return;
  }
  std::array<Equation, 2> equations;
  for (std::size_t k = 0; k < 2; ++k) {
    const Touchable& other = *things[k + 1];
    if (other.isLine) {
      equations[k] = lineEquation(other, base.point, base.r);
      continue;
    }
    const Vector v = vectorTo(base.point, other.point);
    const double more = other.r - base.r;
    const double size = std::max(largestOf(v), std::abs(more));
    if (size == 0) return;
    equations[k] = {{v.x / size, v.y / size, more / size}, (dot(v, v) - more * more) / (2 * size)};
  }
  const DiscPlace along = crossOf(equations[0].row, equations[1].row);
  const double square = dotOf(along, along);
  if (square == 0) return;
  const DiscPlace u = crossOf(equations[1].row, along);
  const DiscPlace v = crossOf(along, equations[0].row);
  const auto footOf = [&](double DiscPlace::*axis) {
    return (equations[0].value * u.*axis + equations[1].value * v.*axis) / square;
  };
  const DiscPlace foot = {footOf(&DiscPlace::x), footOf(&DiscPlace::y), footOf(&DiscPlace::r)};
  const double growth = along.x * along.x + along.y * along.y - along.r * along.r;
  const double half = -(foot.x * along.x + foot.y * along.y - foot.r * along.r);
  const double decay = foot.x * foot.x + foot.y * foot.y - foot.r * foot.r;
  const double discriminant = std::max(half * half - growth * decay, 0.0);
  const double sum = half + std::copysign(std::sqrt(discriminant), half);
  for (const double s : {sum / growth, decay / sum}) {
    if (!(std::abs(s) < kInfinite)) continue;
    refined({base.point.x + foot.x + s * along.x, base.point.y + foot.y + s * along.y, foot.r + s * along.r - base.r});
  }
}

class DiscSearch {
 public:
  DiscSearch(const Diagram& diagram, const Region& region) : region_(region) {
    const Box box = region.bounds();
    origin_ = {box.minX + (box.maxX - box.minX) / 2, box.minY + (box.maxY - box.minY) / 2};
    unit_ = powerOfTwoIn(std::max(box.maxX - box.minX, box.maxY - box.minY));
    for (std::size_t i = 0; i < diagram.circles.size(); ++i) {
      const auto index = static_cast<std::int32_t>(i);
      if (!diagram.hasCell(index)) continue;
      const Circle& c = diagram.circles[i];
      circles_.push_back(index);
      things_.push_back({here({c.x, c.y}), {}, c.r / unit_, false});
    }
    const auto points = region.points();
    const auto rings = region.ringOffsets();
    for (std::size_t ring = 0; ring + 1 < rings.size(); ++ring) {
      for (std::int32_t k = rings[ring]; k < rings[ring + 1]; ++k) {
        const Point from = here(points[at(k)]);
        const Point to = here(points[at(k + 1 == rings[ring + 1] ? rings[ring] : k + 1)]);
        const Vector along = vectorTo(from, to);
        const double size = length(along);
        const std::int32_t before = k == rings[ring] ? rings[ring + 1] - 1 : k - 1;
        // No disc inside touches a corner where the region is convex.
        const bool isReflex = turn(vectorTo(here(points[at(before)]), from), along) < 0;
        sides_.push_back({from, to, isReflex});
        things_.push_back({from, {-along.y / size, along.x / size}, 0, true});
      }
    }
  }

  std::optional<EmptyDisc> run() {
    Square root;
    root.half = 1;
    root.near.resize(things_.size());
    for (std::size_t i = 0; i < things_.size(); ++i) root.near[i] = static_cast<std::int32_t>(i);
    offerSquare(std::move(root));
    while (!pending_.empty() && pending_.top()->most > radius_) {
      const std::shared_ptr<Square> square = pending_.top();
      pending_.pop();
      for (const double x : {-1.0, 1.0}) {
        for (const double y : {-1.0, 1.0}) {
          const double half = square->half / 2;
          Square quarter;
          quarter.center = {square->center.x + x * half, square->center.y + y * half};
          quarter.half = half;
          quarter.near = square->near;
          offerSquare(std::move(quarter));
        }
      }
    }
    return best_;
  }

 private:
  struct Side {
    Point from;
    Point to;
    bool startsAtReflexCorner = false;
  };

  struct Square {
    Point center;
    double half = 0;                 ///< half of its side
    double most = 0;                 ///< no disc around a point of the square is larger
    std::vector<std::int32_t> near;  ///< the circles and sides that may be nearest to a point of the square
  };

  Point here(Point p) const { return {(p.x - origin_.x) / unit_, (p.y - origin_.y) / unit_}; }
  Point there(Point p) const { return {origin_.x + unit_ * p.x, origin_.y + unit_ * p.y}; }

  double distanceTo(std::int32_t thing, Point p) const {
    if (at(thing) < circles_.size()) return things_[at(thing)].distance(p).first;
    const Side& side = sides_[at(thing) - circles_.size()];
    const Vector along = vectorTo(side.from, side.to);
    const double size = length(along);
    const Vector unit = {along.x / size, along.y / size};
    const double share = std::clamp(dot(vectorTo(side.from, p), unit) / size, 0.0, 1.0);
    if (share == 0 || share == 1) return lengthOf(vectorTo(share == 0 ? side.from : side.to, p));
    return std::abs(cross(unit, vectorTo(side.from, p)));
  }

  void offerSquare(Square square) {
    std::vector<double> distances;
    distances.reserve(square.near.size());
    double least = kInfinite;
    double toSide = kInfinite;
    for (const std::int32_t thing : square.near) {
      const double distance = distanceTo(thing, square.center);
      distances.push_back(distance);
      least = std::min(least, distance);
      if (at(thing) >= circles_.size()) toSide = std::min(toSide, distance);
    }
    const double reach = square.half * std::sqrt(2.0);
    const bool isInside = region_.contains(there(square.center));
    // Outside, the distance from the boundary counts as negative.
    square.most = (isInside ? least : std::min(least, -toSide)) + reach;
    if (!(square.most > radius_)) return;
    std::size_t count = 0;
    for (std::size_t i = 0; i < square.near.size(); ++i) {
      if (distances[i] <= least + 2 * reach) square.near[count++] = square.near[i];
    }
    square.near.resize(count);
    if (count <= kFew) {
      tryAll(square);
      return;
    }
    offer(square.center, square);
    if (square.half > kFinestSquare) {
      square.near.shrink_to_fit();
      pending_.push(std::make_shared<Square>(std::move(square)));
    }
  }

  /// Tries all discs around points of a square that touch three things.
  void tryAll(const Square& square) {
    std::vector<Touchable> near;
    for (const std::int32_t thing : square.near) {
      near.push_back(things_[at(thing)]);
      if (at(thing) < circles_.size()) continue;
      // Only one of the two sides at a corner adds the corner.
      const Side& side = sides_[at(thing) - circles_.size()];
      if (side.startsAtReflexCorner) near.push_back({side.from, {}, 0, false});
    }
    offer(square.center, square);
    const double slack = square.half * (1 + kRounding) + kFinestSquare;
    const auto take = [&](Point p) {
      if (largestOf(vectorTo(square.center, p)) <= slack) offer(p, square);
    };
    for (std::size_t i = 0; i < near.size(); ++i) {
      for (std::size_t j = i + 1; j < near.size(); ++j) {
        for (std::size_t k = j + 1; k < near.size(); ++k) placesTouching({&near[i], &near[j], &near[k]}, take);
      }
    }
  }

  void offer(Point p, const Square& square) {
    double least = kInfinite;
    for (const std::int32_t thing : square.near) least = std::min(least, distanceTo(thing, p));
    if (!(least > radius_)) return;
    const Point center = there(p);
    if (!region_.contains(center)) return;
    radius_ = least;
    EmptyDisc found = {{center.x, center.y, least * unit_}, {kNone, kNone, kNone}};
    std::size_t count = 0;
    for (const std::int32_t thing : square.near) {
      if (at(thing) >= circles_.size() || count == found.circles.size()) continue;
      if (distanceTo(thing, p) <= least + kRoundingOfTouch) found.circles[count++] = circles_[at(thing)];
    }
    best_ = found;
  }

  struct IsLess {
    bool operator()(const std::shared_ptr<Square>& one, const std::shared_ptr<Square>& other) const {
      return one->most < other->most;
    }
  };

  const Region& region_;
  Point origin_;
  double unit_ = 1;
  std::vector<CircleIndex> circles_;
  std::vector<Touchable> things_;  ///< the circles, then the lines of the sides
  std::vector<Side> sides_;
  std::priority_queue<std::shared_ptr<Square>, std::vector<std::shared_ptr<Square>>, IsLess> pending_;
  double radius_ = 0;
  std::optional<EmptyDisc> best_;
};

}  // namespace

// The distance from the nearest circle or side has its maximum at a point that is equally near to three circles or
// sides, or along two parallel sides, and then also at an end of that segment, which is such a point. A corner counts
// as a circle of radius 0.
Result<std::optional<EmptyDisc>> largestEmptyDiscInside(const Diagram& diagram, const Region& region) {
  return guarded([&]() -> Result<std::optional<EmptyDisc>> {
    if (diagram.metric != Metric::circles) {
      return Error{ErrorCode::badOption, kNone, "The largest empty disc takes a diagram of the metric circles."};
    }
    if (auto disc = DiscSearch(diagram, region).run()) return disc;
    auto clipped = ClippedDiagram::from(diagram, region);
    if (!clipped) return clipped.error();
    return clipped->largestEmptyDisc();
  });
}

}  // namespace circle_voronoi
