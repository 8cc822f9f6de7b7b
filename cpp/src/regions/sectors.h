// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "circle_voronoi/diagram.h"
#include "shifted_signs.h"
#include "vectors.h"

namespace circle_voronoi {

/// Sectors are looked for from so many sides before the approximate place on: rounding may be off by sides of next to
/// no length.
inline constexpr std::size_t kSidesBefore = 2;

/// A cell of a diagram of circles, divided into sectors by rays from the center of its circle: to its vertices, to
/// infinity where sides end there, and to apexes. No sector spans more than half a turn.
///
/// A cell is star-shaped: every ray from the center leaves it once. So a line meets the sectors in the order in which
/// they go around the center, and meets the border of the cell in that order, too. This takes the place of comparing
/// where the line crosses the bisectors of different neighbors.
///
/// The sides of cells with many sides are kept, and sectors of these are found by bisection. So a walk that comes into
/// such a cell again and again does not collect its sides each time.
class Sectors {
 public:
  Sectors(const Diagram& diagram, const ShiftedSigns& signs) : diagram_(diagram), signs_(signs) {}

  /// A sector: a part of a side, before its apex or after it, or a part of the gap at infinity that follows a side.
  struct Sector {
    std::size_t side = 0;  ///< in sides()
    enum class Part : std::uint8_t { beforeApex, afterApex, gap, secondGap } part = Part::beforeApex;
  };

  /// Takes the sides of a cell, counter-clockwise.
  void setCell(CircleIndex cell);
  /// Takes the sides of the cell that has a corner, by steps from a circle to nearer neighbors.
  void setCellWith(Point corner, CircleIndex from);
  CircleIndex cell() const { return cell_; }
  std::span<const SideIndex> sides() const { return sides_; }
  bool hasManySides() const { return many_ != nullptr; }
  /// Returns whether the cell has so many sides that sectors are found faster.
  bool isStarWithManySides() const { return hasManySides() && diagram_.metric == Metric::circles; }
  /// Returns the radius of a disc around the center that certainly lies in the cell, if it has many sides.
  double innerRadius() const { return many_->innerRadius; }

  /// Returns the sector in which a corner lies. The search goes counter-clockwise from a sector.
  Sector find(Point corner, Sector first) const;
  Sector find(Point corner) const { return find(corner, {sideNear(corner), Part::beforeApex}); }
  /// Returns the sector in which a line comes across a side into the cell.
  Sector entered(SideIndex side, const ShiftedSigns::Line& line) const;

  /// Calls `visit` with the sides of the cell that may come within a distance of a place in the cell.
  template <class Visit>
  void visitSidesNear(Point p, double reach, Visit visit) const;

  /// Returns whether the cell of the circle has a corner that lies in a sector. The cell is star-shaped, so the
  /// neighbor across the side there decides.
  ShiftedSigns::Comparison compareIn(Sector sector, Point corner) const;
  /// Returns whether a segment between two corners comes into the cell across a side, wherever it begins.
  bool isEnteredAcross(SideIndex side, const ShiftedSigns::Line& segment) const;

  /// Returns the side across which a line leaves the cell, ahead of a place in a sector and before the end of the line;
  /// nothing if it ends before. The place is the start of the line, or where it enters the cell across the side of the
  /// sector. `endsInCell` says whether the end of the line lies in the cell.
  std::optional<SideIndex> exitFrom(Sector sector, bool isEntered, const ShiftedSigns::Line& line,
                                    bool endsInCell) const;

 private:
  using Part = Sector::Part;
  using Line = ShiftedSigns::Line;
  /// A ray between two sectors.
  struct Ray {
    enum class To : std::uint8_t { origin, target, neighbor, awayFromNeighbor } to;
    std::size_t side;
  };

  /// The sides of a cell with many sides.
  struct Many {
    std::vector<SideIndex> sides;
    std::vector<Vector> beginnings;                            ///< about the directions in which they begin
    std::vector<std::pair<std::int32_t, std::size_t>> places;  ///< of each side in `sides`, by side
    double innerRadius = 0;
  };
  const Many& manyOf(CircleIndex cell);
  CircleIndex nearerNeighbor(Point corner) const;
  std::size_t placeOf(SideIndex side) const;
  std::size_t sideNear(Point corner) const;
  bool isBeyond(std::size_t side, Vector toPlace, double reach) const;
  std::size_t after(std::size_t side) const { return side + 1 == sides_.size() ? 0 : side + 1; }
  std::size_t before(std::size_t side) const { return side == 0 ? sides_.size() - 1 : side - 1; }
  bool hasGap(std::size_t side) const { return diagram_.targetOf(sides_[side]) == kNone; }
  bool isGapDivided(std::size_t side) const;
  Part lastPart(std::size_t side) const;
  Sector next(Sector sector, bool isForward) const;
  Ray rayAfter(Sector sector, bool isForward) const;
  int turn(const Ray& ray, Point corner) const;
  int sideOf(const Ray& ray, const Line& line) const;
  bool bulges(SideIndex side, const Line& line, int center) const;

  const Diagram& diagram_;
  const ShiftedSigns& signs_;
  CircleIndex cell_;
  std::span<const SideIndex> sides_;
  std::vector<SideIndex> few_;  ///< the sides of a cell with few
  const Many* many_ = nullptr;
  std::unordered_map<std::int32_t, Many> kept_;
};

template <class Visit>
void Sectors::visitSidesNear(Point p, double reach, Visit visit) const {
  const std::size_t count = sides_.size();
  if (!hasManySides() || diagram_.metric == Metric::power) {
    for (const SideIndex side : sides_) visit(side);
    return;
  }
  const Circle& c = diagram_.circles[static_cast<std::size_t>(cell_)];
  const Vector toPlace = {p.x - c.x, p.y - c.y};
  // From the sector of the place on, counter-clockwise and clockwise.
  const std::size_t first = sideNear(p);
  std::size_t ahead = 0;
  do {
    visit(sides_[(first + ahead) % count]);
    ++ahead;
  } while (ahead < count && (ahead <= 2 * kSidesBefore + 1 || !isBeyond((first + ahead) % count, toPlace, reach)));
  for (std::size_t back = 1; back + ahead <= count && !isBeyond((first + count + 1 - back) % count, toPlace, reach);
       ++back) {
    visit(sides_[(first + count - back) % count]);
  }
}

}  // namespace circle_voronoi
