// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "circle_voronoi/diagram.h"
#include "circle_voronoi/point.h"
#include "shift_polynomial.h"

namespace circle_voronoi {

/// A place where a side of a region goes from one cell to another.
struct SideCrossing {
  Point from;  ///< the start of the side
  Point to;
  CircleIndex before;
  CircleIndex after;
  Point point;  ///< right to 2^-44 of the side and rounding
};

/// A line that meets the rim of a cell's disc: that of a side of a region, or the line through both points at which an
/// edge of the cell meets the rim.
struct RimLine {
  CircleIndex neighbor = {};  ///< the neighbor across the edge; kNone for a side of a region
  Point from;
  Point to;

  static RimLine ofEdge(CircleIndex neighbor) { return {neighbor, {}, {}}; }
  static RimLine ofSide(Point from, Point to) { return {kNone, from, to}; }
  bool isOfEdge() const { return neighbor != kNone; }
  friend bool operator==(const RimLine&, const RimLine&) = default;
};

/// A point of the rim.
struct RimPoint {
  RimLine line;
  bool isAhead = false;  ///< whether it is the second of both points along the line; of an edge, with the cell on its
                         ///< left
  SideIndex side = {};   ///< the side of the cell, for an edge
  Point point;
  double place = 0;  ///< a pseudo-angle, from 0 to 4, within `error`
  double error = 0;
};

/// The signs that decide how cells are cut at a distance from their circles. The *disc* of a cell is the disc around
/// its center with the radius r + distance, an exact sum. For the metric `power` its squared radius is the weight plus
/// the square of the distance, minus it for a negative distance. The circle of the disc is the *rim*. Both rims of an
/// edge meet its bisector in the same points.
///
/// Signs that involve a region belong to one region that is moved by a tiny shift (shift_polynomial.h), as those where
/// its sides meet the edges (shifted_signs.h). So no corner lies on a rim, no side touches one, and no side passes
/// through a point where an edge meets a rim. Vertices exactly at the distance count as within. An apex exactly at the
/// distance does not, because only an edge of length zero would be kept there. A disc whose radius is not positive
/// keeps nothing.
///
/// Each sign is found in doubles with an error bound or, if that does not decide, in integers. Where the value is 0 for
/// the region that is not moved, the sign is a tie.
///
/// Laws (laws_test.cpp):
///   meetsRim(i, ofEdge(j)) == meetsRim(j, ofEdge(i)).
///   pastApex(i, j, v) and pastApex(j, i, v) have opposite signs, unless it is a tie.
///   pastFoot(i, p, q, r) and pastFoot(i, q, p, r) have opposite signs.
///   meetsRim(i, ofSide(p, q)) == meetsRim(i, ofSide(q, p)).
///   isBefore is a strict order of the points of a rim.
class DistanceSigns {
 public:
  /// The distance is rounded as the circles were (limits.h).
  DistanceSigns(const Diagram& diagram, double maxDistance);

  /// Returns a circle of the diagram, without its radius if the metric takes no account of it.
  Circle circle(CircleIndex i) const;
  /// Returns the radius of the disc of a cell in doubles.
  double radius(CircleIndex cell) const;
  /// Returns whether the disc of a cell has a positive radius.
  bool hasDisc(CircleIndex cell) const;
  /// Returns whether a cell contains the center of its circle. Only cells of the metric `power` may not.
  bool hasCenter(CircleIndex cell) const;

  // 1 beyond the distance, -1 within it.
  ShiftedSign beyond(VertexIndex vertex) const;
  ShiftedSign beyond(const SideCrossing& crossing) const;
  ShiftedSign beyond(CircleIndex cell, Point corner) const;

  // 1 if a place on an edge comes after the apex of its bisector, in the direction with `left` on the left.
  ShiftedSign pastApex(CircleIndex left, CircleIndex right, VertexIndex vertex) const;
  ShiftedSign pastApex(CircleIndex left, CircleIndex right, const SideCrossing& crossing) const;

  // 1 if a place on a side comes after the foot of the perpendicular from the center of a cell.
  ShiftedSign pastFoot(CircleIndex cell, Point from, Point to, Point corner) const;
  ShiftedSign pastFoot(CircleIndex cell, const SideCrossing& crossing) const;

  /// Returns whether a line meets the rim of a cell in two points. The line of an edge does if the apex of its bisector
  /// is nearer than the distance.
  bool meetsRim(CircleIndex cell, const RimLine& line) const;

  /// Returns a point where a line meets the rim of a cell, which it does.
  RimPoint rimPoint(CircleIndex cell, const RimLine& line, bool isAhead) const;
  /// Returns whether one point of the rim comes before another one, counter-clockwise from the direction of the x axis.
  bool isBefore(CircleIndex cell, const RimPoint& p, const RimPoint& q) const;
  /// Returns whether a point of the rim lies in the upper half, from the direction of the x axis to before the opposite
  /// one.
  bool isUpper(CircleIndex cell, const RimPoint& p) const;

 private:
  /// The center of a circle, or a place.
  struct Site {
    Point p;
    CircleIndex circle = {};  ///< kNone for a place
  };
  Site siteOf(CircleIndex i) const;
  std::array<Site, 2> sitesOf(const RimLine& line) const;
  struct ExactDisc;
  ExactDisc exactDisc(CircleIndex cell, std::span<const Site> sites) const;
  ExactDisc straightDisc(CircleIndex cell, std::span<const Site> sites) const;
  template <class Formula>
  auto seenFromStraight(CircleIndex cell, std::span<const Site> sites, Formula formula) const;
  template <class Formula>
  auto seenFromDisc(CircleIndex cell, std::span<const Site> sites, Formula formula) const;
  template <class Formula>
  ShiftedSign shiftedSign(CircleIndex cell, std::span<const Site> sites, Formula formula) const;

  /// A line as seen from the center of a disc.
  struct SeenLine {
    Vector along;       ///< of length 1
    double height = 0;  ///< how far the line lies to the left of the center
    double error = 0;   ///< a bound on the errors of the height and of the radius
  };
  SeenLine seenLine(CircleIndex cell, const RimLine& line) const;
  double radiusSize(CircleIndex cell) const;
  ShiftedSign leftOf(CircleIndex cell, const RimPoint& p, const RimLine& line) const;
  int aheadOn(CircleIndex cell, const RimPoint& p, const RimLine& line) const;
  double halfChord(CircleIndex cell, const RimLine& line) const;
  int turnToCenter(CircleIndex cell, const RimLine& line) const;
  bool isFollowedBy(SideIndex side, SideIndex other) const;
  bool comesFirst(CircleIndex cell, const RimPoint& p, const RimPoint& q) const;

  const Diagram& diagram_;
  double distance_;
};

}  // namespace circle_voronoi
