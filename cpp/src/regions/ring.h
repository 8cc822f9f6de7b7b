// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/convex_polygon.h"
#include "circle_voronoi/point.h"

namespace circle_voronoi {

/// In place of a side of a region: the circle that limits it.
inline constexpr std::int32_t kCircleOfRing = -2;

/// A part of a segment, by how far its ends are along it: from 0 to 1.
struct Chord {
  double from = 0;
  double to = 1;
};

/// Returns the part of a segment inside a disc. Whether the ends of the segment are inside has been decided.
std::optional<Chord> chordOf(Point from, Point to, bool hasFrom, bool hasTo, const Circle& disc);

/// The boundary of a convex region as one closed line, counter-clockwise: of a polygon, of a disc, or of what both have
/// in common. It is made of segments and of arcs of a quarter turn at most.
class Ring {
 public:
  struct Element {
    Point start;
    Point end;
    double r = 0;           ///< of an arc; 0: a segment
    std::int32_t side = 0;  ///< of the polygon, or kCircleOfRing
  };

  /// Either may be missing, but not both. Empty if they have nothing in common. The disc has a radius above 0.
  Ring(const ConvexPolygon* polygon, const std::optional<Circle>& disc);

  bool isEmpty() const { return elements_.empty(); }
  std::span<const Element> elements() const { return elements_; }
  /// Whether it is a circle as a whole.
  bool isCircle() const {
    return std::ranges::all_of(elements_, [](const Element& element) { return element.r > 0; });
  }
  /// A point inside.
  Point middle() const;

  // A place is how far along the chords of the elements a point is from the start of the first.

  double total() const { return reach_.back(); }
  Point at(double place) const;
  /// The place next to a point, of those on a side or on the circle if one is given.
  double placeNear(Point p, std::optional<std::int32_t> side = std::nullopt) const;

  /// The parts of elements from one place to another, which may be up to two rounds ahead, with the given ends for
  /// these places. No element has length zero.
  std::vector<Element> between(double from, double to, Point start, Point end) const;

 private:
  void takeDisc();
  void takePolygon(const ConvexPolygon& polygon);
  void takeCommon(const ConvexPolygon& polygon);
  void addSegment(Point from, Point to, std::int32_t side);
  void addArc(Point from, Point to);

  std::size_t elementAt(double place) const;
  double shareOn(const Element& element, Point p) const;
  Point pointOn(const Element& element, double share) const;

  Circle disc_;
  std::vector<Element> elements_;
  std::vector<double> reach_;
};

}  // namespace circle_voronoi
