// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"

namespace circle_voronoi::fuzz {

/// A number of a diagram to be overwritten.
struct Edit {
  std::uint8_t field = 0;  ///< which list, and which number of its items
  std::uint8_t item = 0;
  std::int8_t value = 0;
};

struct Input {
  std::vector<Circle> circles;
  std::vector<Edit> edits;
};

/// Reads any bytes as circles and edits. The first byte is the format:
///   bits 0-1  numbers: 0 small integers (3 bytes a circle), 1 small integers scaled by a power of two and moved far
///             away, 2 doubles bit by bit (24 bytes), 3 small integers times separate powers of two (6 bytes)
///   bits 2-4  the number of edits, from the end of the data
/// At most kMostCircles circles are read, and half of that if they differ by hundreds of decades, because exact
/// arithmetic is slow then.
Input decode(std::span<const std::uint8_t> bytes);

inline constexpr std::size_t kMostCircles = 24;

/// The diagram with numbers overwritten, which may be right or wrong afterwards.
Diagram corrupted(Diagram diagram, std::span<const Edit> edits);

/// Whether the products of four numbers of a power diagram do not underflow (compute).
inline bool isExact(const Diagram& diagram) {
  double largest = 0;
  double least = 1e300;
  for (const Circle& c : diagram.circles) {
    for (const double value : {std::abs(c.x), std::abs(c.y), c.r}) {
      largest = std::max(largest, value);
      if (value > 0) least = std::min(least, value);
    }
  }
  return diagram.metric != Metric::power || least > 0x1p-190 * largest;
}

}  // namespace circle_voronoi::fuzz
