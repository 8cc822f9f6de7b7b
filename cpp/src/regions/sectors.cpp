// SPDX-License-Identifier: GPL-3.0-or-later
#include "sectors.h"

#include <algorithm>
#include <cmath>

#include "at.h"
#include "beginning_of.h"
#include "refuse_clip.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

/// The largest number of sides that are collected again each time.
constexpr std::size_t kFewSides = 24;
/// Rounding of distances between circles.
constexpr double kInside = 1 - 0x1p-40;

}  // namespace

void Sectors::setCell(CircleIndex cell) {
  if (cell == cell_) return;
  cell_ = cell;
  few_.clear();
  many_ = nullptr;
  for (const SideIndex side : diagram_.sides(cell)) {
    few_.push_back(side);
    if (few_.size() <= kFewSides) continue;
    many_ = &manyOf(cell);
    break;
  }
  sides_ = many_ != nullptr ? std::span<const SideIndex>(many_->sides) : few_;
}

void Sectors::setCellWith(Point corner, CircleIndex from) {
  for (std::size_t steps = 0; steps <= diagram_.circles.size(); ++steps) {
    setCell(from);
    const CircleIndex nearer = nearerNeighbor(corner);
    if (nearer == kNone) return;
    from = nearer;
  }
  refuseClip("No cell of the diagram has a corner of the region.");
}

/// Returns a neighbor of the cell whose circle is nearer to a corner, or kNone.
CircleIndex Sectors::nearerNeighbor(Point corner) const {
  if (isStarWithManySides()) {
    const Sector sector = find(corner);
    return compareIn(sector, corner).sign > 0 ? CircleIndex() : diagram_.neighborOf(sides_[sector.side]);
  }
  CircleIndex best = cell_;
  for (const SideIndex side : sides_) {
    const CircleIndex neighbor = diagram_.neighborOf(side);
    if (neighbor != best && signs_.compare(best, neighbor, corner).sign < 0) best = neighbor;
  }
  return best == cell_ ? CircleIndex() : best;
}

const Sectors::Many& Sectors::manyOf(CircleIndex cell) {
  const auto [place, isNew] = kept_.try_emplace(cell);
  Many& many = place->second;
  if (!isNew) return many;
  const Circle& c = diagram_.circles[at(cell)];
  many.innerRadius = kInfinite;
  for (const SideIndex side : diagram_.sides(cell)) {
    many.places.emplace_back(side, many.sides.size());
    many.sides.push_back(side);
    many.beginnings.push_back(beginningOf(diagram_, side));
    const Circle& neighbor = diagram_.circles[at(diagram_.neighborOf(side))];
    const double least = lengthOf(vectorTo(Point{c.x, c.y}, Point{neighbor.x, neighbor.y})) * kInside;
    const double rounding = (std::abs(c.r) + std::abs(neighbor.r)) * (1 - kInside);
    many.innerRadius = std::min(many.innerRadius, (least + (c.r - neighbor.r) - rounding) / 2);
  }
  std::ranges::sort(many.places);
  return many;
}

std::size_t Sectors::placeOf(SideIndex side) const {
  if (many_ == nullptr) return static_cast<std::size_t>(std::ranges::find(sides_, side) - sides_.begin());
  return std::ranges::lower_bound(many_->places, std::pair(std::int32_t{side}, std::size_t{0}))->second;
}

/// A side a little before the sector in which a corner lies.
std::size_t Sectors::sideNear(Point corner) const {
  if (many_ == nullptr) return 0;
  const Circle& c = diagram_.circles[at(cell_)];
  const Vector toCorner = vectorTo({c.x, c.y}, corner);
  const auto& beginnings = many_->beginnings;
  const auto found = std::ranges::partition_point(
      beginnings, [&](Vector beginning) { return isNoLater(beginnings.front(), beginning, toCorner); });
  const auto place = static_cast<std::size_t>(found - beginnings.begin());
  return (place + sides_.size() - 1 - kSidesBefore) % sides_.size();
}

/// Whether the gap after a side goes on beyond the direction away from its neighbor. It spans less than half a turn up
/// to there, and from there.
bool Sectors::isGapDivided(std::size_t side) const {
  const Circle& neighbor = diagram_.circles[at(diagram_.neighborOf(sides_[side]))];
  return signs_.turnFromEnd(sides_[after(side)], false, {neighbor.x, neighbor.y}) > 0;
}

Sectors::Part Sectors::lastPart(std::size_t side) const {
  return signs_.hasApex(sides_[side]) ? Part::afterApex : Part::beforeApex;
}

Sectors::Sector Sectors::next(Sector sector, bool isForward) const {
  const auto& [side, part] = sector;
  if (isForward) {
    if (part == Part::beforeApex && signs_.hasApex(sides_[side])) return {side, Part::afterApex};
    if (part <= Part::afterApex && hasGap(side)) return {side, Part::gap};
    if (part == Part::gap && isGapDivided(side)) return {side, Part::secondGap};
    return {after(side), Part::beforeApex};
  }
  if (part == Part::afterApex) return {side, Part::beforeApex};
  if (part == Part::gap) return {side, lastPart(side)};
  if (part == Part::secondGap) return {side, Part::gap};
  const std::size_t last = before(side);
  if (hasGap(last)) return {last, isGapDivided(last) ? Part::secondGap : Part::gap};
  return {last, lastPart(last)};
}

/// The ray that bounds a sector counter-clockwise if `isForward`, else clockwise.
Sectors::Ray Sectors::rayAfter(Sector sector, bool isForward) const {
  const auto& [side, part] = sector;
  switch (part) {
    case Part::beforeApex:
      if (!isForward) return {Ray::To::origin, side};
      if (signs_.hasApex(sides_[side])) return {Ray::To::neighbor, side};
      return {Ray::To::target, side};
    case Part::afterApex:
      return {isForward ? Ray::To::target : Ray::To::neighbor, side};
    case Part::gap:
      if (!isForward) return {Ray::To::target, side};
      if (isGapDivided(side)) return {Ray::To::awayFromNeighbor, side};
      return {Ray::To::origin, after(side)};
    case Part::secondGap:
      break;
  }
  if (!isForward) return {Ray::To::awayFromNeighbor, side};
  return {Ray::To::origin, after(side)};
}

/// Whether a corner lies counter-clockwise (1) or clockwise (-1) from a ray.
int Sectors::turn(const Ray& ray, Point corner) const {
  const SideIndex side = sides_[ray.side];
  if (ray.to == Ray::To::neighbor) return signs_.turnFromNeighbor(side, corner);
  if (ray.to == Ray::To::awayFromNeighbor) return -signs_.turnFromNeighbor(side, corner);
  return signs_.turnFromEnd(side, ray.to == Ray::To::target, corner);
}

/// The side of a line on which a ray meets the border of the cell.
int Sectors::sideOf(const Ray& ray, const Line& line) const {
  const SideIndex side = sides_[ray.side];
  if (ray.to == Ray::To::neighbor) return signs_.sideOfApex(side, line);
  return signs_.sideOfEnd(side, ray.to == Ray::To::target, line);
}

Sectors::Sector Sectors::find(Point corner, Sector first) const {
  Sector sector = first;
  bool isAhead = turn(rayAfter(sector, false), corner) > 0;
  do {
    const bool isBefore = turn(rayAfter(sector, true), corner) < 0;
    if (isAhead && isBefore) return sector;
    isAhead = !isBefore;
    sector = next(sector, true);
  } while (sector.side != first.side || sector.part != first.part);
  refuseClip("A corner of the region lies in no sector of its cell.");
}

Sectors::Sector Sectors::entered(SideIndex across, const Line& line) const {
  const std::size_t side = placeOf(across);
  if (!signs_.hasApex(across)) return {side, Part::beforeApex};
  const Circle& c = diagram_.circles[at(cell_)];
  const int center = signs_.sideOf({c.x, c.y}, line);
  const bool isForward = center > 0;
  const Part first = isForward ? Part::beforeApex : Part::afterApex;
  const Part second = isForward ? Part::afterApex : Part::beforeApex;
  // Along the border, in the order of the line, the side goes from the center's side of the line to the other one.
  if (signs_.sideOfApex(across, line) != center) return {side, first};
  if (signs_.sideOfEnd(across, isForward, line) != center) return {side, second};
  // The line leaves the cell across this part of the side again.
  return {side, signs_.goesToNeighbor(across, line) ? first : second};
}

/// Whether the cell of a smaller neighbor reaches across the line between the ends of a side, which lie beyond the
/// line.
bool Sectors::bulges(SideIndex side, const Line& line, int center) const {
  return signs_.crossesTwice(side, line, center) &&
         signs_.approachAtEnd(side, false, line) * signs_.approachAtEnd(side, true, line) < 0;
}

/// Whether the ray to the beginning of a side is farther from a place than a distance, and so is all that lies beyond
/// it.
bool Sectors::isBeyond(std::size_t side, Vector toPlace, double reach) const {
  const Vector ray = many_->beginnings[side];
  const double size = lengthOf(ray);
  const double away = dot(ray, toPlace) > 0 ? std::abs(cross(ray, toPlace)) / size : lengthOf(toPlace);
  return away * kInside > reach;
}

ShiftedSigns::Comparison Sectors::compareIn(Sector sector, Point corner) const {
  if (sector.part >= Part::gap) return {1, -1};
  return signs_.compare(cell_, diagram_.neighborOf(sides_[sector.side]), corner);
}

/// A line crosses the bisector of two circles twice at most, once into each direction. So on the segment it comes into
/// the cell once at most. It does so across the side if it does so on the line across the side.
bool Sectors::isEnteredAcross(SideIndex side, const Line& segment) const {
  const CircleIndex neighbor = diagram_.neighborOf(side);
  const bool startsIn = signs_.compare(cell_, neighbor, segment.from).sign > 0;
  const bool endsIn = signs_.compare(cell_, neighbor, segment.to).sign > 0;
  if (startsIn && !endsIn) return false;
  const double radius = diagram_.circles[at(cell_)].r;
  const double other = diagram_.circles[at(neighbor)].r;
  const bool isStraight = diagram_.metric != Metric::circles || radius == other;
  if (isStraight && startsIn == endsIn) return false;
  // The circle that the bisector does not bend around.
  const SideIndex ofLarger = radius >= other ? side : Diagram::twin(side);
  const auto centerOfLarger = [&] {
    const Circle& c = diagram_.circles[at(diagram_.circleOf(ofLarger))];
    return signs_.sideOf({c.x, c.y}, segment);
  };
  if (startsIn == endsIn) {
    // The segment goes through the convex side of the bisector, or not at all.
    if (startsIn != (radius > other)) return false;
    if (!signs_.crossesTwice(ofLarger, segment, centerOfLarger())) return false;
    if (!signs_.isAheadOf(ofLarger, segment, segment.from) || signs_.isAheadOf(ofLarger, segment, segment.to)) {
      return false;
    }
  }
  const int atOrigin = signs_.sideOfEnd(side, false, segment);
  const int atTarget = signs_.sideOfEnd(side, true, segment);
  if (atOrigin != atTarget) return atOrigin > 0;
  if (isStraight) return false;
  const int center = centerOfLarger();
  return atOrigin != center && bulges(ofLarger, segment, center);
}

std::optional<SideIndex> Sectors::exitFrom(Sector sector, bool isEntered, const Line& line, bool endsInCell) const {
  const Circle& c = diagram_.circles[at(cell_)];
  const int center = signs_.sideOf({c.x, c.y}, line);
  const bool isForward = center > 0;
  const auto isBeyond = [&](const Ray& ray) { return sideOf(ray, line) != center; };
  bool wasBeyond = false;  // whether the ray before the sector meets the border of the cell beyond the line
  bool isFirst = true;
  // Each side has four parts at most, and the line spans less than a turn.
  for (std::size_t steps = 0; steps <= 4 * sides_.size(); ++steps, isFirst = false) {
    const Ray ray = rayAfter(sector, isForward);
    const bool endsHere = endsInCell && center * turn(ray, line.to) < 0;
    if (sector.part >= Part::gap) {
      if (endsHere) return std::nullopt;
      wasBeyond = ray.to != Ray::To::awayFromNeighbor && isBeyond(ray);
    } else {
      const SideIndex side = sides_[sector.side];
      if (!isBeyond(ray)) return endsHere ? std::nullopt : std::optional(side);
      const bool mayBulge = diagram_.circles[at(diagram_.neighborOf(side))].r < c.r && !(isFirst && isEntered) &&
                            (isFirst ? isBeyond(rayAfter(sector, !isForward)) : wasBeyond);
      if (mayBulge && bulges(side, line, center) && !(isFirst && !signs_.isAheadOf(side, line, line.from)) &&
          !(endsHere && signs_.isAheadOf(side, line, line.to))) {
        return side;
      }
      if (endsHere) return std::nullopt;
      wasBeyond = true;
    }
    sector = next(sector, isForward);
  }
  refuseClip("A side of the region does not leave a cell in which it does not end.");
}

}  // namespace circle_voronoi
