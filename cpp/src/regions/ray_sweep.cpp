// SPDX-License-Identifier: GPL-3.0-or-later
#include "ray_sweep.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>

#include "at.h"
#include "in_circle.h"

namespace circle_voronoi {

RaySweep::RaySweep(const Region& region, const ShiftedSigns& signs) : region_(region), signs_(signs) {}

RegionSideIndex RaySweep::before(RegionSideIndex side) const {
  const std::size_t ring = at(region_.ringOf(side));
  return side == region_.ringOffsets()[ring] ? region_.ringOffsets()[ring + 1] - 1 : side - 1;
}

RegionSideIndex RaySweep::after(RegionSideIndex side) const {
  const std::size_t ring = at(region_.ringOf(side));
  return side + 1 == region_.ringOffsets()[ring + 1] ? region_.ringOffsets()[ring] : side + 1;
}

/// The position of a place on a ray that crosses a side: 1 if it is nearer than the side, -1 if it lies beyond it.
int RaySweep::signOfPlace(const Side& side, Point p) const {
  return side.centerSign * orientation(side.from, side.to, p);
}

/// Whether a ray that crosses two sides meets the first one first. The sides do not cross.
bool RaySweep::isNearer(const Side& one, const Side& other) const {
  const auto endsOf = [&](const Side& side, const Side& its) {
    return std::minmax({signOfPlace(side, its.from), signOfPlace(side, its.to)});
  };
  // One of them lies on one side of the line through the other.
  const auto [least, most] = endsOf(one, other);
  if (least >= 0 && most > 0) return false;
  if (most <= 0 && least < 0) return true;
  const auto [itsLeast, itsMost] = endsOf(other, one);
  return itsLeast >= 0 && itsMost > 0;
}

/// The order of places counter-clockwise around the center, from the direction of the x axis.
bool RaySweep::isEarlier(Point one, Point other) const {
  const bool isUpper = one.y >= center_.y;
  if (isUpper != (other.y >= center_.y)) return isUpper;
  return signs_.turnFromRay(cell_, one, other) > 0;
}

/// Decides whether the ray goes on in the region: in one of the polygons at the place, on the left of all its sides.
void RaySweep::decideRay(RayPlace& place) const {
  struct InPolygon {
    std::int32_t polygon;
    bool isInside;
  };
  std::vector<InPolygon> sides;
  const auto comesFromOutside = [&](Point from, Point to) { return signs_.sideOf(center_, {from, to}) < 0; };
  const auto add = [&](RegionSideIndex side, bool isInside) {
    sides.push_back({region_.polygonOf(region_.ringOf(side)), isInside});
  };
  for (const RegionSideIndex side : place.corners) {
    const Point start = pointOf(before(side));
    const Point end = pointOf(after(side));
    const bool isAfterFirst = comesFromOutside(start, place.point);
    const bool isAfterSecond = comesFromOutside(place.point, end);
    const bool isConvex = orientation(start, place.point, end) > 0;
    add(side, isConvex ? isAfterFirst && isAfterSecond : isAfterFirst || isAfterSecond);
    if (!isConvex && isAfterFirst != isAfterSecond) place.isJump = true;
  }
  for (const RegionSideIndex side : place.touching) add(side, comesFromOutside(pointOf(side), pointOf(after(side))));
  if (sides.size() > 1) place.isJump = true;
  std::ranges::sort(sides, {}, &InPolygon::polygon);
  place.goesOn = sides.empty();
  for (std::size_t k = 0; k < sides.size() && !place.goesOn;) {
    const std::int32_t polygon = sides[k].polygon;
    bool isInside = true;
    for (; k < sides.size() && sides[k].polygon == polygon; ++k) isInside = isInside && sides[k].isInside;
    place.goesOn = isInside;
  }
}

void RaySweep::run(CircleIndex cell, Point center, std::span<const RegionSideIndex> indices,
                   std::span<const RegionSideIndex> corners, std::span<const Point> given,
                   const std::function<void(const RayPlace&)>& visit) {
  cell_ = cell;
  center_ = center;
  std::vector<Side> sides;
  sides.reserve(indices.size());
  for (const RegionSideIndex index : indices) {
    const Point from = pointOf(index);
    const Point to = pointOf(after(index));
    sides.push_back({index, from, to, signs_.sideOf(center, {from, to})});
  }

  /// Along the ray, also for a place on it.
  struct Order {
    using is_transparent = void;
    const RaySweep& sweep;
    const std::vector<Side>& sides;
    bool operator()(std::size_t one, std::size_t other) const { return sweep.isNearer(sides[one], sides[other]); }
    bool operator()(std::size_t side, Point p) const { return sweep.signOfPlace(sides[side], p) < 0; }
    bool operator()(Point p, std::size_t side) const { return sweep.signOfPlace(sides[side], p) > 0; }
  };
  std::set<std::size_t, Order> crossed(Order{*this, sides});
  std::vector<std::optional<std::set<std::size_t, Order>::iterator>> places(sides.size());
  const auto insert = [&](std::size_t side) { places[side] = crossed.insert(side).first; };

  enum class Kind : std::uint8_t { end, start, corner, point };
  struct Event {
    Point point;
    Kind kind;
    std::size_t index;
  };
  std::vector<Event> events;
  events.reserve(2 * sides.size() + corners.size() + given.size());
  for (std::size_t k = 0; k < sides.size(); ++k) {
    events.push_back({sides[k].first(), Kind::start, k});
    events.push_back({sides[k].last(), Kind::end, k});
  }
  for (const RegionSideIndex corner : corners) events.push_back({pointOf(corner), Kind::corner, at(corner)});
  for (std::size_t k = 0; k < given.size(); ++k) events.push_back({given[k], Kind::point, k});
  std::ranges::sort(events, [&](const Event& one, const Event& other) {
    if (one.point != other.point) return isEarlier(one.point, other.point);
    return std::pair(one.kind, one.index) < std::pair(other.kind, other.index);
  });
  for (std::size_t k = 0; k < sides.size(); ++k) {
    if (isEarlier(sides[k].last(), sides[k].first())) insert(k);
  }

  std::vector<RegionSideIndex> cornersHere;
  std::vector<RegionSideIndex> touching;
  std::vector<std::int32_t> givenHere;
  for (std::size_t k = 0; k < events.size();) {
    const Point point = events[k].point;
    std::vector<std::size_t> starts;
    cornersHere.clear();
    touching.clear();
    givenHere.clear();
    for (; k < events.size() && events[k].point == point; ++k) {
      const auto& [_, kind, index] = events[k];
      if (kind == Kind::end && places[index]) {
        crossed.erase(*places[index]);
        places[index].reset();
      } else if (kind == Kind::start) {
        starts.push_back(index);
      } else if (kind == Kind::corner) {
        cornersHere.emplace_back(static_cast<std::int32_t>(index));
      } else if (kind == Kind::point) {
        givenHere.push_back(static_cast<std::int32_t>(index));
      }
    }
    if (!cornersHere.empty() || !givenHere.empty()) {
      // The nearest side that the place is not beyond.
      auto next = crossed.lower_bound(point);
      for (; next != crossed.end() && signOfPlace(sides[*next], point) == 0; ++next) {
        touching.push_back(sides[*next].index);
      }
      RayPlace place = {point, cornersHere, touching, givenHere};
      place.first = next == crossed.end() ? RegionSideIndex() : sides[*next].index;
      decideRay(place);
      visit(place);
    }
    for (const std::size_t side : starts) insert(side);
  }
}

}  // namespace circle_voronoi
