// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "circle_voronoi/error.h"
#include "circle_voronoi/point.h"
#include "vectors.h"

namespace circle_voronoi {

/// Returns whether the segment from a to b is below that from c to d where a line from left to right crosses both. They
/// do not cross, and a is before b and c before d.
bool isBelow(Point a, Point b, Point c, Point d);

/// Rings of points, one after the other: those from offsets[k] to before offsets[k + 1] are ring k, which has three
/// points or more. Points in a row differ. Side k begins at point k.
struct Rings {
  std::vector<Point> points;
  std::vector<std::int32_t> offsets;
};

/// The nesting of rings that neither cross nor overlap.
struct RingOrder {
  /// For each ring the smallest ring around it, or -1.
  std::vector<std::int32_t> parent;
  /// For each ring whether it runs counter-clockwise.
  std::vector<std::uint8_t> isCounterClockwise;
  /// The rings that meet in a point where several do. The point is given by its place among such points.
  struct Touch {
    std::int32_t point;
    std::int32_t ring;
  };
  std::vector<Touch> touches;
};

/// Determines how rings lie to each other. A line sweeps over them from left to right and keeps the sides that it
/// crosses in order (M. I. Shamos, D. Hoey, "Geometric intersection problems", 1976). All signs are exact.
///
/// Takes O(m log m) steps for m sides. Throws a ThrownError with a sentence if a ring crosses or touches itself, or two
/// rings cross or overlap; `sideName` says what a side is called, and `advise` appends advice about two sides.
RingOrder orderOf(const Rings& rings, const std::function<std::string(std::int32_t side)>& sideName,
                  const std::function<void(Error& error, std::int32_t a, std::int32_t b)>& advise);

/// Determines how rings lie to each other. Returns nothing if they cross or overlap, as by rounding.
std::optional<RingOrder> orderIfApart(const Rings& rings);

}  // namespace circle_voronoi
