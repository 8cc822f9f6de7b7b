// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "circle_voronoi/point.h"

namespace circle_voronoi {

/// A segment between two points of a list, by their indices. Point `a` is before point `b` (isBefore).
struct Segment {
  std::int32_t a;
  std::int32_t b;

  friend auto operator<=>(const Segment&, const Segment&) = default;
};

/// The places where segments meet, except at ends that they share.
struct Meetings {
  /// Two segments that cross at a point inside both. If an end of a third segment lies there, the touches have it, and
  /// the crossing may be missing.
  struct Crossing {
    std::int32_t first;
    std::int32_t second;
  };
  /// An end of a segment that lies inside another segment.
  struct Touch {
    std::int32_t segment;
    std::int32_t point;
  };
  std::vector<Crossing> crossings;
  std::vector<Touch> touches;
};

/// Finds where segments meet, each place once, with exact signs. No two segments are the same, and no two points.
/// Returns nothing if there are more than `most` meetings.
///
/// Divides the plane into halves at the middle one of the ends, from left to right, and so on (I. J. Balaban, "An
/// optimal algorithm for finding segment intersections", 1995). In each slab, segments that go through it and do not
/// cross one another are its levels. A search among the levels finds where others cross them. These others are searched
/// in both halves. Takes O(n log^2 n + k log n) steps for n segments and k meetings, however long the segments are.
std::optional<Meetings> meetingsOf(std::span<const Point> points, std::span<const Segment> segments, std::size_t most);

/// Where two lines cross that are not parallel, compared with a vertical line.
/// Returns 1 if the crossing of the lines through a, b and through c, d lies left of x, 0 if it lies on x, -1 if it
/// lies right of x. The sign is exact.
int sideOfCrossing(Point a, Point b, Point c, Point d, double x);

}  // namespace circle_voronoi
