// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "circle_voronoi/diagram.h"
#include "circle_voronoi/point.h"
#include "exact.h"
#include "weighted_point.h"

namespace circle_voronoi {

/// The signs that decide how the boundary of a region runs through a diagram, as if the region were moved by (e, f),
/// where e is positive but smaller than any number and f is positive but smaller than any power of e.
///
/// Moved like this, no corner of the region lies on an edge, no side passes through a vertex, and no side runs along an
/// edge. So no sign is 0, and signs agree with each other. Each sign is found in doubles with an error bound or, if
/// that does not decide, in integers. Where the unmoved value is 0, its derivatives decide.
///
/// A `Line` is the line through two corners of the region, from the first to the second. Its left side has the sign 1.
///
/// Laws (laws_test.cpp), with -l for the line from l.to to l.from:
///   compare(i, j, p).sign == -compare(j, i, p).sign.
///   sideOf, sideOfEnd and sideOfApex change their signs from l to -l; the last two have the same sign from both sides
///   of an edge.
///   goesToNeighbor(s, -l) == goesToNeighbor(twin(s), l), and not both goesToNeighbor(s, l) and goesToNeighbor(s, -l).
///   isBefore(i, j, l, m) != isBefore(i, j, m, l), and isBefore(i, j, l, m) == isBefore(j, i, -m, -l).
///   sideOfCrossing(i, j, l, m) == -sideOfCrossing(i, j, l, -m) == sideOfCrossing(j, i, -l, m).
///   turnFromRay(i, p, q) == -turnFromRay(i, q, p).
class ShiftedSigns {
 public:
  struct Line {
    Point from;
    Point to;
  };

  explicit ShiftedSigns(const Diagram& diagram);

  /// The difference of a corner's distances from another circle and from its own.
  struct Comparison {
    int sign = 0;
    double least = 0;  ///< a lower bound, in terms of distances from the corner to the bisector: negative if unknown
  };
  Comparison compare(CircleIndex own, CircleIndex other, Point corner) const;

  /// Returns the side of a line on which a point lies.
  int sideOf(Point p, const Line& line) const;
  /// Returns the side of a line on which an end of a side lies: its target or its origin. If that is at infinity, the
  /// line goes through the cell of the side.
  int sideOfEnd(SideIndex side, bool isTarget, const Line& line) const;
  /// Returns the side of a line on which the apex of the bisector of a side lies.
  int sideOfApex(SideIndex side, const Line& line) const;

  // Directions seen from the center of the cell of a side. The metric is Metric::circles.

  /// Returns 1 if a corner lies counter-clockwise from the end of a side, -1 if it lies clockwise from it, by less than
  /// half a turn.
  int turnFromEnd(SideIndex side, bool isTarget, Point corner) const;
  /// Returns 1 if a corner lies counter-clockwise from the direction to the neighbor, -1 if it lies clockwise from it.
  int turnFromNeighbor(SideIndex side, Point corner) const;
  /// Returns whether the direction to the neighbor lies between the ends of a side whose neighbor is not smaller.
  bool hasApex(SideIndex side) const;

  /// Returns whether a line crosses the bisector of a side twice. The center of the cell lies on the given side of the
  /// line.
  bool crossesTwice(SideIndex side, const Line& line, int center) const;
  /// Returns whether a line that crosses the bisector of a side twice does so with both crossings ahead of a corner on
  /// the line, or both behind it.
  bool isAheadOf(SideIndex side, const Line& line, Point corner) const;
  /// Returns the sign of the rate at which the neighbor comes nearer, compared with the circle, along a line at an end
  /// of a side. It may be 0.
  int approachAtEnd(SideIndex side, bool isTarget, const Line& line) const;
  /// Returns whether a line goes towards the neighbor, away from the circle.
  bool goesToNeighbor(SideIndex side, const Line& line) const;

  /// Returns where a line comes out of one cell into another across their bisector: the share of the way from its first
  /// corner to its second. Right to rounding of itself, for the region that is not moved.
  double shareOfCrossing(CircleIndex from, CircleIndex to, const Line& line) const;

  // Lines that cross the bisector of two circles. They come out of the cell of `left` into that of `right`, and the
  // bisector is seen with the cell of `left` on its left.

  /// Returns whether the crossing of one line comes before that of another one, along the bisector.
  bool isBefore(CircleIndex left, CircleIndex right, const Line& line, const Line& other) const;
  /// Returns the side of another line on which the crossing of a line lies. Returns 0 if both lie on one line.
  int sideOfCrossing(CircleIndex left, CircleIndex right, const Line& line, const Line& other) const;

  // Rays from the center of a circle through a place that moves with the region: a corner, or a point in it.

  /// Returns 1 if a corner lies counter-clockwise from a ray, by less than half a turn, -1 if it lies clockwise from
  /// it. Returns 0 only if the corner is the place through which the ray goes.
  int turnFromRay(CircleIndex circle, Point through, Point corner) const;
  /// Returns turnFromRay for the crossing where a line comes out of one cell into another, of which one is that of the
  /// circle. The crossing is between the two corners of the line. Returns 0 if the ray goes through the crossing of the
  /// region that is not moved.
  int turnFromRay(CircleIndex circle, Point through, CircleIndex from, CircleIndex to, const Line& line) const;
  /// Returns where a ray crosses a line: the share of the way from its first corner to its second. Right to rounding of
  /// itself, for the region that is not moved.
  double shareOnRay(CircleIndex circle, Point through, const Line& line) const;

  /// Returns a bound on how far a vertex may be off.
  double errorOf(VertexIndex vertex) const;

 private:
  const Circle& circle(CircleIndex i) const { return diagram_.circles[static_cast<std::size_t>(i)]; }
  /// The weight of a circle in a diagram of straight edges.
  TwoPart weight(const Circle& c) const {
    return diagram_.metric == Metric::power ? powerWeight(c, diagram_.weights) : TwoPart{};
  }
  exact::Face faceOf(SideIndex side, bool isTarget) const;
  Comparison compareStraight(const Circle& own, const Circle& other, Point corner) const;
  /// Returns a circle without its radius if edges are straight.
  Circle flattened(CircleIndex i) const;
  int bulgeSide(CircleIndex left, CircleIndex right, const Line& line) const;
  bool isTangent(CircleIndex left, CircleIndex right, const Line& line) const;

  const Diagram& diagram_;
  bool isCurved_;
};

}  // namespace circle_voronoi
