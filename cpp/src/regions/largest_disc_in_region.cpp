// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "at.h"
#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/region_queries.h"
#include "guarded.h"
#include "relative_circle.h"
#include "rounded.h"
#include "scale.h"
#include "scaled_region.h"

namespace circle_voronoi {
namespace {

/// With at most this number of circles and sides nearby, all triples are tried.
constexpr std::size_t kFew = 10;
/// All triples are also tried with at most this number nearby, if discs are larger than the best one by rounding at
/// most, as between parallel sides. Otherwise the rectangle would be divided along its whole length, down to rounding.
constexpr std::size_t kFewOfTie = 30;
/// Rectangles smaller than this share of the region are points up to rounding.
constexpr double kFinestRectangle = 0x1p-50;
/// Two sides are parallel if the sine of the angle between them is at most this.
constexpr double kMostSlope = 0x1p-4;
/// A rectangle is turned if it becomes larger by this factor at most. A square doubles at 45 degrees.
constexpr double kMostOfTurned = 2.001;
/// A disc touches circles and sides at a distance of its radius, up to this share of the region.
constexpr double kRoundingOfTouch = 0x1p-44;
constexpr int kRefinements = 2;
/// Bounds of distances may be off by this share of the region, by rounding.
constexpr double kRoundingOfBound = 0x1p-46;
/// Discs that are larger by less than this share are not looked for.
constexpr double kRoundingOfRadius = 0x1p-46;
/// The directions of things are sorted into this number of sectors.
constexpr std::size_t kSectors = 8;

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

/// A rectangle in any direction. If it lies in others, only those of its points count that lie in all of them.
struct Frame {
  Point center;
  Vector axis = {1, 0};  ///< of length 1
  Vector half;           ///< half of its length along the axis and across it
  std::shared_ptr<const Frame> within;

  /// A vector in the directions of the rectangle.
  [[nodiscard]] Vector seen(Vector v) const { return {dot(axis, v), cross(axis, v)}; }
  /// The largest value of v . w for all w from the center to points of the rectangle.
  [[nodiscard]] double reachOf(Vector v) const {
    const Vector its = seen(v);
    return half.x * std::abs(its.x) + half.y * std::abs(its.y);
  }
  [[nodiscard]] double reach() const { return length(half); }
  /// Returns whether a point counts, where the rectangles are larger by `slack`.
  [[nodiscard]] bool has(Point p, double slack) const {
    const Vector v = seen(vectorTo(center, p));
    return std::abs(v.x) <= half.x + slack && std::abs(v.y) <= half.y + slack && (!within || within->has(p, slack));
  }
  /// Returns whether points may count.
  [[nodiscard]] bool mayCount() const {
    for (const Frame* other = within.get(); other != nullptr; other = other->within.get()) {
      if (isBeside(*other) || other->isBeside(*this)) return false;
    }
    return true;
  }

  /// A part, of those in a number of columns along the axis and rows across it.
  [[nodiscard]] Frame part(int column, int columns, int row, int rows) const {
    Frame its = *this;
    its.half = {half.x / columns, half.y / rows};
    const double along = (2 * column + 1 - columns) * its.half.x;
    const double across = (2 * row + 1 - rows) * its.half.y;
    its.center = {center.x + (axis.x * along - axis.y * across), center.y + (axis.y * along + axis.x * across)};
    return its;
  }
  /// The smallest rectangle along a direction that contains this one, for the points of this one.
  [[nodiscard]] Frame turnedTo(Vector direction) const {
    return {center,
            direction,
            {reachOf(direction), reachOf({-direction.y, direction.x})},
            std::make_shared<const Frame>(*this)};
  }

 private:
  /// Returns whether a line along a side of this rectangle separates it from another one.
  [[nodiscard]] bool isBeside(const Frame& other) const {
    const Vector v = seen(vectorTo(center, other.center));
    return std::abs(v.x) > half.x + other.reachOf(axis) + kFinestRectangle ||
           std::abs(v.y) > half.y + other.reachOf({-axis.y, axis.x}) + kFinestRectangle;
  }
};

class DiscSearch {
 public:
  /// The region has been scaled by a power of two, to a unit of 1 at least. The diagram has not.
  DiscSearch(const Diagram& diagram, const Region& region, double scale) : region_(region), scale_(scale) {
    const Box box = region.bounds();
    origin_ = {box.minX + (box.maxX - box.minX) / 2, box.minY + (box.maxY - box.minY) / 2};
    unit_ = powerOfTwoIn(std::max(box.maxX - box.minX, box.maxY - box.minY));
    for (std::size_t i = 0; i < diagram.circles.size(); ++i) {
      const auto index = static_cast<std::int32_t>(i);
      if (!diagram.hasCell(index)) continue;
      const Circle& c = diagram.circles[i];
      circles_.push_back(index);
      things_.push_back({here({scale * c.x, scale * c.y}), {}, scale * c.r / unit_, false});
    }
    const auto points = region.points();
    const auto rings = region.ringOffsets();
    for (std::size_t ring = 0; ring + 1 < rings.size(); ++ring) {
      for (std::int32_t k = rings[ring]; k < rings[ring + 1]; ++k) {
        const Point from = here(points[at(k)]);
        const std::int32_t next = k + 1 == rings[ring + 1] ? rings[ring] : k + 1;
        const Point to = here(points[at(next)]);
        const Vector along = vectorTo(from, to);
        const double size = length(along);
        const Vector direction = {along.x / size, along.y / size};
        sides_.push_back({from, to, direction, size, points[at(k)], points[at(next)]});
        things_.push_back({from, {-along.y / size, along.x / size}, 0, true});
      }
      const std::span<Side> sides = std::span(sides_).subspan(at(rings[ring]));
      for (std::size_t k = 0; k < sides.size(); ++k) {
        Side& before = sides[k == 0 ? sides.size() - 1 : k - 1];
        const double turning = turn(vectorTo(before.from, before.to), vectorTo(sides[k].from, sides[k].to));
        before.turnAtEnd = (turning > 0 ? 1 : 0) - (turning < 0 ? 1 : 0);
        sides[k].turnAtStart = before.turnAtEnd;
      }
    }
  }

  std::optional<EmptyDisc> run() {
    // The region lies within 1 of the origin along x and y.
    Frame root;
    root.half = {1, 1};
    std::vector<std::int32_t> all(things_.size());
    std::iota(all.begin(), all.end(), 0);
    offerRectangle(std::move(root), std::move(all));
    while (!pending_.empty() && mayBeLarger(pending_.top()->most)) {
      const std::shared_ptr<const Rectangle> whole = pending_.top();
      pending_.pop();
      if (whole->turned) {
        offerRectangle(*whole->turned, whole->near);
        continue;
      }
      for (int column = 0; column < whole->columns; ++column) {
        for (int row = 0; row < whole->rows; ++row) {
          Frame part = whole->frame.part(column, whole->columns, row, whole->rows);
          if (part.mayCount()) offerRectangle(std::move(part), whole->near);
        }
      }
    }
    return best_;
  }

 private:
  struct Side {
    Point from;
    Point to;
    Vector direction;  ///< of length 1
    double size = 0;
    Point start;  ///< `from` and `to` where the region is
    Point end;
    int turnAtStart = 0;  ///< -1 at a reflex corner, 1 at a convex one
    int turnAtEnd = 0;
  };

  struct Rectangle {
    Frame frame;
    std::vector<std::int32_t> near;  ///< the circles and sides that may be nearest to a point that counts
    double most = 0;                 ///< no disc around a point that counts is larger
    int columns = 2;                 ///< the number of parts along the axis
    int rows = 2;                    ///< the number of parts across the axis
    std::optional<Frame> turned;     ///< is divided instead
  };

  Point here(Point p) const { return {(p.x - origin_.x) / unit_, (p.y - origin_.y) / unit_}; }
  Point there(Point p) const { return {origin_.x + unit_ * p.x, origin_.y + unit_ * p.y}; }
  /// Rounds a point to the numbers for which signs are exact (limits.h), times the unit.
  Point roundedInUnits(Point p) const { return {unit_ * rounded(p.x / unit_), unit_ * rounded(p.y / unit_)}; }

  /// The distance of the center of a rectangle from a thing, and its bounds at center + v in the rectangle: it is at
  /// least value + along . v, because things are convex, and larger by at most `excess`.
  struct Distance {
    double value = 0;
    Vector along;
    double excess = kInfinite;
    double most = kInfinite;  ///< no point of the rectangle is farther from the thing
    bool isWhole = false;     ///< whether this is a side, and all points of the rectangle are beside it
  };

  Distance distanceTo(std::int32_t thing, const Frame& frame) const {
    const Point p = frame.center;
    Vector v;
    double radius = 0;
    if (at(thing) < circles_.size()) {
      v = vectorTo(things_[at(thing)].point, p);
      radius = things_[at(thing)].r;
    } else {
      const auto& [from, to, unit, size, start, end, turnAtStart, turnAtEnd] = sides_[at(thing) - circles_.size()];
      const double ahead = dot(vectorTo(from, p), unit);
      if (ahead > 0 && ahead < size) {
        const double height = cross(unit, vectorTo(from, p));
        const double sign = height < 0 ? -1 : 1;
        const Vector along = {-sign * unit.y, sign * unit.x};
        // The rectangle extends beyond the ends of the side this far.
        const double beyond = std::max(frame.reachOf(unit) - std::min(ahead, size - ahead), 0.0);
        const double aside = frame.reachOf(along);
        // Beyond the line, the distance grows again.
        return {std::abs(height), along, excessOf(std::abs(height), aside, beyond),
                length({std::abs(height) + aside, beyond}), beyond == 0};
      }
      v = vectorTo(ahead > 0 ? to : from, p);
    }
    const double distance = lengthOf(v);
    const double most = distance - radius + frame.reach();
    // At an end of a side, the distance grows in some directions only.
    if (!(distance > 0)) return {distance - radius, {}, kInfinite, most};
    const Vector along = measuredIn(distance, v);
    const double aside = frame.reachOf({-along.y, along.x});
    return {distance - radius, along, excessOf(distance, frame.reachOf(along), aside), most};
  }

  /// The distance from a point grows by a step ahead and a step aside by at most the step ahead and this.
  static double excessOf(double distance, double ahead, double aside) {
    if (!(distance > 2 * ahead)) return kInfinite;
    return aside * aside / (2 * (distance - ahead));
  }

  double distanceTo(std::int32_t thing, Point p) const {
    if (at(thing) < circles_.size()) return lengthOf(vectorTo(things_[at(thing)].point, p)) - things_[at(thing)].r;
    const Side& side = sides_[at(thing) - circles_.size()];
    const Vector v = vectorTo(side.from, p);
    const double ahead = dot(v, side.direction);
    if (ahead > 0 && ahead < side.size) return std::abs(cross(side.direction, v));
    return lengthOf(ahead > 0 ? vectorTo(side.to, p) : v);
  }

  /// Tries discs of a rectangle, and keeps it for division if a larger one may be in it. `near` are the things that may
  /// be nearest to a point that counts.
  void offerRectangle(Frame its, std::vector<std::int32_t> near) {
    Rectangle rectangle;
    rectangle.frame = std::move(its);
    rectangle.near = std::move(near);
    const Frame& frame = rectangle.frame;
    std::vector<Distance> distances;
    distances.reserve(rectangle.near.size());
    std::size_t nearest = 0;
    for (const std::int32_t thing : rectangle.near) {
      distances.push_back(distanceTo(thing, frame));
      if (distances.back().value < distances[nearest].value) nearest = distances.size() - 1;
    }
    const double least = distances[nearest].value;
    const double reach = frame.reach();
    const Distance& first = distances[nearest];
    rectangle.most = first.most;
    if (!mayBeLarger(rectangle.most)) return;
    // The smaller of two distances is at most their mean, which is nearly the same all over the rectangle if the two
    // things are opposite each other.
    const Distance* opposite = &first;
    for (const Distance& other : distances) {
      const Vector sum = {first.along.x + other.along.x, first.along.y + other.along.y};
      const double mean =
          (first.value + other.value + frame.reachOf(sum) + first.excess + other.excess) / 2 + kRoundingOfBound;
      if (mean < rectangle.most) {
        rectangle.most = mean;
        opposite = &other;
      }
    }
    if (!mayBeLarger(rectangle.most)) return;
    const bool isCounted = frame.has(frame.center, 0);
    // A way from outside into the region crosses the boundary, and is at least as long up to there as to the nearest
    // thing: a side, or a circle that covers the boundary where its sides are not kept.
    const double mostFromOutside = reach - std::abs(least);
    if (isCounted && !(rectangle.most < mostFromOutside) && !contains(frame.center, least, rectangle)) {
      double closest = kInfinite;
      for (const Distance& each : distances) closest = std::min(closest, each.value - frame.reachOf(each.along));
      if (closest > kRoundingOfBound) return;
      rectangle.most = mostFromOutside;
      opposite = &first;
      if (!mayBeLarger(rectangle.most)) return;
    }
    // The disc between the two.
    const double half = (opposite->value - first.value) / 2;
    if (half > 0) {
      const Point between = {frame.center.x + half * first.along.x, frame.center.y + half * first.along.y};
      if (frame.has(between, 0)) offer(between, rectangle);
    }
    if (!mayBeLarger(rectangle.most)) return;
    const std::int32_t thing = rectangle.near[nearest];
    divide(rectangle, first, thing, keepNearest(rectangle, distances, first));
    // Parts next to a side that are too small for a larger disc are left out before all discs are tried.
    const bool mayBeDivided = least <= reach && reach < 4 * radius_;
    const bool isTie = rectangle.most <= radius_ + 2 * kRoundingOfBound;
    if (rectangle.near.size() <= (isTie ? kFewOfTie : kFew) && !mayBeDivided) {
      tryAll(rectangle);
      return;
    }
    if (isCounted) offer(frame.center, rectangle);
    if (largestOf(frame.half) > kFinestRectangle) {
      rectangle.near.shrink_to_fit();
      pending_.push(std::make_shared<Rectangle>(std::move(rectangle)));
    }
  }

  /// Decides into how many parts a rectangle is divided. Along sides that are longer than the rectangle, it is first
  /// turned to their direction, and divided until it is thinner than its distance from the nearest one. So a strip
  /// between two long sides takes few rectangles, however thin it is.
  void divide(Rectangle& rectangle, const Distance& first, std::int32_t nearest, bool areMostParallel) const {
    const Vector half = rectangle.frame.half;
    rectangle.columns = 2 * half.x > half.y ? 2 : 1;
    rectangle.rows = 2 * half.y > half.x ? 2 : 1;
    if (!first.isWhole || !areMostParallel) return;
    const Vector direction = sides_[at(nearest) - circles_.size()].direction;
    const Vector slope = rectangle.frame.seen(direction);
    if (half.x * std::abs(slope.y) <= first.value) {
      if (2 * half.y > first.value) {
        rectangle.columns = 1;
        rectangle.rows = 2;
      }
    } else if (half.y * std::abs(slope.x) <= first.value) {
      if (2 * half.x > first.value) {
        rectangle.columns = 2;
        rectangle.rows = 1;
      }
    } else {
      Frame turned = rectangle.frame.turnedTo(direction);
      const Frame* within = rectangle.frame.within.get();
      const double size = turned.half.x * turned.half.y;
      const bool isSmaller = within == nullptr || 4 * size <= within->half.x * within->half.y;
      if (isSmaller && size <= kMostOfTurned * half.x * half.y) rectangle.turned = std::move(turned);
    }
  }

  double leastDistance(Point p, const Rectangle& rectangle) const {
    double least = kInfinite;
    for (const std::int32_t thing : rectangle.near) least = std::min(least, distanceTo(thing, p));
    return least;
  }

  /// Returns whether the region contains a point of a rectangle whose distance from the nearest thing is `least`, up to
  /// rounding. If the nearest things are sides, the point is inside on their left, and beyond a reflex corner. The two
  /// sides of a wall may be a few units of rounding apart.
  bool contains(Point p, double least, const Rectangle& rectangle) const {
    if (std::abs(least) <= kRoundingOfTouch) return true;
    std::array<bool, 2> answers = {false, false};
    for (const std::int32_t thing : rectangle.near) {
      if (distanceTo(thing, p) > least + kRoundingOfTouch) continue;
      if (at(thing) < circles_.size()) return region_.contains(there(p));
      answers[isInsideOf(sides_[at(thing) - circles_.size()], p) ? 1 : 0] = true;
    }
    return answers[0] != answers[1] ? answers[1] : region_.contains(there(p));
  }

  /// Returns whether a point is in the region if the given side is the nearest one.
  static bool isInsideOf(const Side& side, Point p) {
    const Vector v = vectorTo(side.from, p);
    const double ahead = dot(side.direction, v);
    const int turnAtCorner = ahead < 0 ? side.turnAtStart : ahead > side.size ? side.turnAtEnd : 0;
    return turnAtCorner == 0 ? cross(side.direction, v) > 0 : turnAtCorner < 0;
  }

  /// Returns whether a bound leaves room for a larger disc than the best one.
  bool mayBeLarger(double most) const { return most > radius_ * (1 + kRoundingOfRadius); }

  /// Keeps the things that may be nearest to a point of a rectangle. Returns whether most of them are sides along the
  /// whole rectangle, parallel to the side that is nearest to its center.
  bool keepNearest(Rectangle& rectangle, const std::vector<Distance>& distances, const Distance& first) const {
    // Of each sector of directions, the thing with the least bound.
    std::array<const Distance*, kSectors> nearest = {};
    const auto bound = [](const Distance& distance) { return distance.value + distance.excess; };
    for (const Distance& distance : distances) {
      const Distance*& its = nearest[sectorOf(distance.along)];
      if (its == nullptr || bound(distance) < bound(*its)) its = &distance;
    }
    const auto isBeyond = [&](const Distance& distance, const Distance* other) {
      if (other == nullptr) return false;
      const Vector difference = {distance.along.x - other->along.x, distance.along.y - other->along.y};
      return distance.value > bound(*other) + rectangle.frame.reachOf(difference) + kRoundingOfBound;
    };
    std::size_t count = 0;
    std::size_t parallel = 0;
    for (std::size_t i = 0; i < distances.size(); ++i) {
      if (distances[i].value - rectangle.frame.reachOf(distances[i].along) > first.most + kRoundingOfBound) continue;
      const std::size_t sector = sectorOf(distances[i].along);
      bool isKept = true;
      for (const std::size_t step : {std::size_t{0}, std::size_t{1}, kSectors - 1}) {
        isKept = isKept && !isBeyond(distances[i], nearest[(sector + step) % kSectors]);
      }
      if (!isKept) continue;
      rectangle.near[count++] = rectangle.near[i];
      if (distances[i].isWhole && std::abs(cross(distances[i].along, first.along)) <= kMostSlope) ++parallel;
    }
    rectangle.near.resize(count);
    return 2 * parallel > count;
  }

  /// Counted counter-clockwise.
  static std::size_t sectorOf(Vector v) {
    const bool isLower = v.y < 0;
    if (isLower) v = {-v.x, -v.y};
    const bool isLeft = v.x < 0;
    if (isLeft) v = {v.y, -v.x};
    return (isLower ? 4U : 0U) + (isLeft ? 2U : 0U) + (v.y > v.x ? 1U : 0U);
  }

  /// Tries all discs around points of a rectangle that touch three things.
  void tryAll(const Rectangle& rectangle) {
    std::vector<Touchable> near;
    for (const std::int32_t thing : rectangle.near) {
      near.push_back(things_[at(thing)]);
      if (at(thing) < circles_.size()) continue;
      // Only one of the two sides at a corner adds the corner.
      const Side& side = sides_[at(thing) - circles_.size()];
      if (side.turnAtStart < 0) near.push_back({side.from, {}, 0, false});
    }
    const Frame& frame = rectangle.frame;
    if (frame.has(frame.center, 0)) offer(frame.center, rectangle);
    const double slack = frame.reach() * kRounding + kFinestRectangle;
    const auto take = [&](Point p) {
      if (frame.has(p, slack)) offer(p, rectangle);
    };
    for (std::size_t i = 0; i < near.size(); ++i) {
      for (std::size_t j = i + 1; j < near.size(); ++j) {
        for (std::size_t k = j + 1; k < near.size(); ++k) placesTouching({&near[i], &near[j], &near[k]}, take);
      }
    }
  }

  void offer(Point p, const Rectangle& rectangle) {
    double least = leastDistance(p, rectangle);
    if (!(least > radius_) || !contains(p, least, rectangle)) return;
    const Point center = roundedInUnits(there(p));
    // In thin regions, rounding of the center counts.
    for (const std::int32_t thing : rectangle.near) {
      if (at(thing) >= circles_.size()) least = std::min(least, exactDistance(thing, center) / unit_);
    }
    if (!(least > radius_) || !region_.contains(center)) return;
    radius_ = least;
    EmptyDisc found = {{center.x / scale_, center.y / scale_, least * unit_ / scale_}, {kNone, kNone, kNone}};
    std::size_t count = 0;
    for (const std::int32_t thing : rectangle.near) {
      if (at(thing) >= circles_.size() || count == found.circles.size()) continue;
      if (distanceTo(thing, p) <= least + kRoundingOfTouch) found.circles[count++] = circles_[at(thing)];
    }
    best_ = found;
  }

  /// Returns the distance of a point in the region from a side, right to rounding of itself.
  double exactDistance(std::int32_t thing, Point p) const {
    const Side& side = sides_[at(thing) - circles_.size()];
    const Vector along = vectorTo(side.start, side.end);
    const double size = lengthOf(along);
    const Vector unit = measuredIn(size, along);
    const Vector fromStart = vectorTo(side.start, p);
    if (!(dot(unit, fromStart) > 0)) return lengthOf(fromStart);
    const Vector fromEnd = vectorTo(side.end, p);
    if (!(dot(unit, fromEnd) < 0)) return lengthOf(fromEnd);
    const Circle start = {side.start.x, side.start.y, 0};
    const Circle end = {side.end.x, side.end.y, 0};
    const Circle place = {p.x, p.y, 0};
    return exact::seenFrom(start, std::array<const Circle*, 2>{&end, &place}, [&](const auto& seen, int exponent) {
      return std::abs(exact::floating(exact::planeCross(seen[0].v, seen[1].v)).times(2 * exponent)) / size;
    });
  }

  struct IsLess {
    bool operator()(const std::shared_ptr<Rectangle>& one, const std::shared_ptr<Rectangle>& other) const {
      return one->most < other->most;
    }
  };

  const Region& region_;
  double scale_;
  Point origin_;
  double unit_ = 1;
  std::vector<CircleIndex> circles_;
  std::vector<Touchable> things_;  ///< the circles, then the lines of the sides
  std::vector<Side> sides_;
  std::priority_queue<std::shared_ptr<Rectangle>, std::vector<std::shared_ptr<Rectangle>>, IsLess> pending_;
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
    const Box box = region.bounds();
    const double unit = powerOfTwoIn(std::max(box.maxX - box.minX, box.maxY - box.minY));
    // A small region is enlarged, so that rounding is the same share of any region.
    const double scale = unit < 1 ? 1 / unit : 1;
    const Region enlarged = scaledRegion(region, scale);
    if (auto disc = DiscSearch(diagram, enlarged, scale).run()) return disc;
    const auto clipped = ClippedDiagram::from(diagram, region);
    if (!clipped) return clipped.error();
    const auto centered = clipped->largestEmptyDisc();
    if (centered && centered->disc.r <= 0) return centered;
    return Error{ErrorCode::badOption, kNone, "The region is so thin that rounding leaves no disc inside it."};
  });
}

}  // namespace circle_voronoi
