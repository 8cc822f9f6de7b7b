// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/compute.h"

namespace circle_voronoi::test {

/// Expects that two numbers have the same bits; NaN equals NaN.
inline void expectSameBits(double a, double b) {
  EXPECT_TRUE((a != a && b != b) || std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b))
      << a << " and " << b << " differ by " << a - b;
}

/// Expects that a cell has the same outline and measures in two clips, to the bit. `indexOf` maps circles of the second
/// diagram to those of the first one.
template <class IndexOf>
void expectSameCell(const ClippedDiagram& a, CircleIndex circle, const ClippedDiagram& b, CircleIndex other,
                    IndexOf indexOf) {
  EXPECT_EQ(a.placeOf(circle), b.placeOf(other));
  const Outline its = a.outline(circle);
  const Outline theirs = b.outline(other);
  ASSERT_EQ(its.size(), theirs.size());
  for (std::size_t k = 0; k < its.size(); ++k) {
    ASSERT_EQ(its[k].size(), theirs[k].size()) << "in loop " << k;
    for (std::size_t p = 0; p < its[k].size(); ++p) {
      const OutlinePiece& piece = its[k][p];
      const OutlinePiece& same = theirs[k][p];
      expectSameBits(piece.curve.start.x, same.curve.start.x);
      expectSameBits(piece.curve.start.y, same.curve.start.y);
      expectSameBits(piece.curve.from, same.curve.from);
      expectSameBits(piece.curve.to, same.curve.to);
      EXPECT_EQ(piece.regionSide, same.regionSide);
      EXPECT_EQ(piece.r, same.r);
      EXPECT_EQ(std::int32_t{piece.neighbor}, same.neighbor == kNone ? kNone : indexOf(same.neighbor));
    }
  }
  expectSameBits(a.area(circle), b.area(other));
  expectSameBits(a.centroid(circle).x, b.centroid(other).x);
  expectSameBits(a.centroid(circle).y, b.centroid(other).y);
  expectSameBits(a.perimeter(circle), b.perimeter(other));
}

/// Expects that a cell that is clipped alone is the same as among all cells, to the bit.
inline void expectSameAlone(const ClippedDiagram& all, CircleIndex circle) {
  const auto alone =
      ClippedDiagram::ofCells(all.diagram(), all.region(), std::vector<CircleIndex>{circle}, all.maxDistance());
  ASSERT_TRUE(alone) << alone.error().message;
  expectSameCell(all, circle, *alone, circle, [](CircleIndex i) { return std::int32_t{i}; });
  EXPECT_EQ(alone->neighbors(circle), all.neighbors(circle));
}

/// Expects that a cell is the same in the diagram of its circle and the neighbors alone, to the bit, as
/// web/lib/regions/few-circles.ts relies on.
inline void expectSameAmongNeighbors(const ClippedDiagram& all, CircleIndex circle) {
  const Diagram& diagram = all.diagram();
  std::vector<CircleIndex> indices = neighbors(diagram, circle);
  if (indices.empty()) return;
  indices.push_back(circle);
  std::ranges::sort(indices);
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  std::vector<Circle> circles;
  for (const CircleIndex i : indices) circles.push_back(diagram.circles[static_cast<std::size_t>(i)]);
  Options options;
  options.weights = diagram.weights;
  const Diagram few = compute(circles, options).value();
  const CircleIndex place = static_cast<std::int32_t>(std::ranges::lower_bound(indices, circle) - indices.begin());
  const auto alone = ClippedDiagram::ofCells(few, all.region(), std::vector<CircleIndex>{place}, all.maxDistance());
  ASSERT_TRUE(alone) << alone.error().message;
  expectSameCell(all, circle, *alone, place,
                 [&](CircleIndex i) { return std::int32_t{indices[static_cast<std::size_t>(i)]}; });
}

}  // namespace circle_voronoi::test
