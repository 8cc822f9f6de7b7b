// SPDX-License-Identifier: GPL-3.0-or-later
#include "sectors.h"

#include <algorithm>

#include "at.h"
#include "refuse_clip.h"

namespace circle_voronoi {

void Sectors::setCell(CircleIndex cell) {
  cell_ = cell;
  sides_.clear();
  for (const SideIndex side : diagram_.sides(cell)) sides_.push_back(side);
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
  const auto found = std::ranges::find(sides_, across);
  const auto side = static_cast<std::size_t>(found - sides_.begin());
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
