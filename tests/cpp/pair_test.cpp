// SPDX-License-Identifier: GPL-3.0-or-later
#include "pair.h"

#include <gtest/gtest.h>

namespace circle_voronoi {
namespace {

using Pairs = std::vector<Pair>;

TEST(Pairs, OfAllCirclesAreInOrderOnceEach) {
  EXPECT_EQ(pairAll(0), Pairs{});
  EXPECT_EQ(pairAll(1), Pairs{});
  EXPECT_EQ(pairAll(3), (Pairs{{0, 1}, {0, 2}, {1, 2}}));
}

TEST(Pairs, OfNeighboringSamplesOnceEach) {
  // A row of circles 1, 0, 2 with two samples each.
  const Samples samples = {{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}}, {1, 1, 0, 0, 2, 2}};
  EXPECT_EQ(pairNeighbors(samples, 3), (Pairs{{0, 1}, {0, 2}}));
}

// The samples of two tangent circles in the point of contact are one corner of the Delaunay graph.
TEST(Pairs, OfCoincidingSamplesAreThoseOfTheirCircles) {
  const Samples samples = {{{0, 0}, {1, 0}, {1, 0}, {2, 0}}, {0, 0, 1, 1}};
  EXPECT_EQ(pairNeighbors(samples, 2), (Pairs{{0, 1}}));
}

// All circles are paired through the point that their samples share.
TEST(Pairs, OfOneSampleThatManyShareAreAllOfThem) {
  const Samples samples = {{{0, 0}, {0, 0}, {0, 0}, {0, 0}}, {3, 0, 2, 1}};
  EXPECT_EQ(pairNeighbors(samples, 4), pairAll(4));
}

}  // namespace
}  // namespace circle_voronoi
