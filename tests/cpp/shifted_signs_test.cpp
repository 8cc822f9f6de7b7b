// SPDX-License-Identifier: GPL-3.0-or-later
// The signs that a clip rests on, where they are far from zero: against distances and cross products in double
// precision.
#include "shifted_signs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "circle_voronoi/compute.h"
#include "random.h"
#include "report.h"

namespace circle_voronoi {
namespace shifted_signs_test {
namespace {

constexpr double kSize = 100;

double turnOf(Point from, Point to, Point p) {
  return (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
}

Point centerOf(const Circle& c) { return {c.x, c.y}; }

double distanceOf(const Circle& c, Point p) { return std::hypot(p.x - c.x, p.y - c.y) - c.r; }

/// Compares a sign with that of a number, unless rounding could change it.
void expectSign(int sign, double value, const char* what) {
  if (std::abs(value) < 1e-6 * kSize) return;
  EXPECT_EQ(sign, value > 0 ? 1 : -1) << what << " " << value;
}

TEST(ShiftedSigns, AreThoseOfDistancesAndCrossProducts) {
  Random random(test::seedOr(20261128));
  const auto point = [&] { return Point{kSize * random.unit(), kSize * random.unit()}; };
  for (int round = 0; round < 20; ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    std::vector<Circle> circles;
    for (int i = 0; i < 12; ++i) {
      const Point center = point();
      circles.push_back({center.x, center.y, 12 * random.unit()});
    }
    const Diagram diagram = compute(circles).value();
    const ShiftedSigns signs(diagram);
    for (int s = 0; s < 2 * static_cast<int>(diagram.edges.size()); ++s) {
      const SideIndex side(s);
      const Circle& own = diagram.circles[static_cast<std::size_t>(diagram.circleOf(side))];
      const Circle& other = diagram.circles[static_cast<std::size_t>(diagram.neighborOf(side))];
      const ShiftedSigns::Line line = {point(), point()};
      const Point corner = point();
      expectSign(signs.sideOf(corner, line), turnOf(line.from, line.to, corner), "side of a corner");
      expectSign(signs.compare(diagram.circleOf(side), diagram.neighborOf(side), corner).sign,
                 distanceOf(other, corner) - distanceOf(own, corner), "comparison");
      expectSign(signs.turnFromNeighbor(side, corner), turnOf(centerOf(own), centerOf(other), corner),
                 "turn from the neighbor");
      const double distance = std::hypot(other.x - own.x, other.y - own.y);
      const double share = (distance + own.r - other.r) / (2 * distance);
      const Point apex = {own.x + share * (other.x - own.x), own.y + share * (other.y - own.y)};
      expectSign(signs.sideOfApex(side, line), turnOf(line.from, line.to, apex), "side of the apex");
      const double towards =
          (line.to.x - line.from.x) * (other.x - own.x) + (line.to.y - line.from.y) * (other.y - own.y);
      expectSign(signs.goesToNeighbor(side, line) ? 1 : -1, towards, "way to the neighbor");
      for (const bool isTarget : {false, true}) {
        const VertexIndex vertex = isTarget ? diagram.targetOf(side) : diagram.originOf(side);
        if (vertex == kNone) continue;
        const Vertex& v = diagram.vertices[static_cast<std::size_t>(vertex)];
        // Vertices far away are less exact.
        if (std::hypot(v.x, v.y) > 1e4 * kSize) continue;
        expectSign(signs.sideOfEnd(side, isTarget, line), turnOf(line.from, line.to, {v.x, v.y}), "side of an end");
        expectSign(signs.turnFromEnd(side, isTarget, corner), turnOf(centerOf(own), {v.x, v.y}, corner),
                   "turn from an end");
      }
    }
  }
}

}  // namespace
}  // namespace shifted_signs_test
}  // namespace circle_voronoi
