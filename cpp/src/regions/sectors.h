// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "circle_voronoi/diagram.h"
#include "shifted_signs.h"

namespace circle_voronoi {

/// A cell of a diagram of circles, divided into sectors by rays from the center of its circle: to its vertices, to
/// infinity where sides end there, and to apexes. No sector spans more than half a turn.
///
/// A cell is star-shaped: every ray from the center leaves it once. So a line meets the sectors in the order in which
/// they go around the center, and meets the border of the cell in that order, too. This takes the place of comparing
/// where the line crosses the bisectors of different neighbors.
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
  CircleIndex cell() const { return cell_; }
  const std::vector<SideIndex>& sides() const { return sides_; }

  /// Returns the sector in which a corner lies. The search goes counter-clockwise from a sector.
  Sector find(Point corner, Sector first) const;
  Sector find(Point corner) const { return find(corner, {}); }
  /// Returns the sector in which a line comes across a side into the cell.
  Sector entered(SideIndex side, const ShiftedSigns::Line& line) const;

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
  std::vector<SideIndex> sides_;
};

}  // namespace circle_voronoi
