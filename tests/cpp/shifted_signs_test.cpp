// SPDX-License-Identifier: GPL-3.0-or-later
// The signs that a clip rests on: where they are far from zero, against distances and cross products in double
// precision, and the order of crossings at ties against a region that is moved, in numbers of 1600 bits.
#include "shifted_signs.h"

#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdlib>
#include <optional>
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

using Real =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<1600, boost::multiprecision::digit_base_2>,
                                  boost::multiprecision::et_off>;
using Line = ShiftedSigns::Line;

/// Returns how far along the bisector of two circles a line comes out of the cell of the left one: the parameter s of
/// the place, which is x = -d (s + 1 / s) / 4 and y = b (s - 1 / s) / 2 from the middle of the centers. The line is
/// moved by a shift that stands for (e, f).
std::optional<Real> movedCrossing(const Circle& left, const Circle& right, const Line& line) {
  const Real e = ldexp(Real(1), -100);
  const Real f = ldexp(Real(1), -600);
  const Real dx = Real(right.x) - left.x;
  const Real dy = Real(right.y) - left.y;
  const Real apart = sqrt(dx * dx + dy * dy);
  const Real ux = dx / apart;
  const Real uy = dy / apart;
  const Real d = Real(right.r) - left.r;
  const Real b = sqrt(apart * apart - d * d) / 2;
  // The normal to the left of the line, along both axes.
  const Real nx = -(Real(line.to.y) - line.from.y);
  const Real ny = Real(line.to.x) - line.from.x;
  const Real alongX = nx * ux + ny * uy;
  const Real alongY = ny * ux - nx * uy;
  const Real height =
      nx * (line.from.x + e - (Real(left.x) + right.x) / 2) + ny * (line.from.y + f - (Real(left.y) + right.y) / 2);
  // a s^2 - height s + c grows where the bisector goes to the left of the line.
  const Real a = -d * alongX / 4 + b * alongY / 2;
  const Real c = -d * alongX / 4 - b * alongY / 2;
  const Real square = height * height - 4 * a * c;
  if (square <= 0 || (a == 0 && height > 0)) return std::nullopt;
  const Real root = sqrt(square);
  const Real s = height > 0 ? Real((height + root) / (2 * a)) : Real(2 * c / (height - root));
  return s > 0 ? std::optional(s) : std::nullopt;
}

TEST(ShiftedSigns, OrderCrossingsAsThoseOfAMovedRegion) {
  // A hyperbola with the axes 32 and 24 and the line between equal circles, and points on each.
  struct Bisected {
    std::array<Circle, 2> circles;
    std::vector<Point> places;
  };
  const std::vector<Bisected> cases = {
      {{{{-40, 0, 64}, {40, 0, 0}}}, {{68, -45}, {40, -18}, {32, 0}, {40, 18}, {68, 45}}},
      {{{{-40, 0, 7}, {40, 0, 7}}}, {{0, -45}, {0, 0}, {0, 50}}},
  };
  int compared = 0;
  for (const Bisected& one : cases) {
    for (int turn = 0; turn < 8; ++turn) {
      // Quarter turns, and the circles in both orders.
      const auto turned = [&](Point p) {
        for (int k = 0; k < turn / 2; ++k) p = {-p.y, p.x};
        return p;
      };
      std::vector<Circle> circles;
      for (const Circle& c : one.circles) {
        const Point p = turned({c.x, c.y});
        circles.push_back({p.x, p.y, c.r});
      }
      if (turn % 2 == 1) std::swap(circles[0], circles[1]);
      const Diagram diagram = compute(circles).value();
      const ShiftedSigns signs(diagram);
      struct Crossed {
        Line line;
        Real place;
      };
      std::vector<Crossed> lines;
      for (const Point place : one.places) {
        const Point p = turned(place);
        for (const Vector way : {Vector{0, 1}, {1, 0}, {1, 1}, {1, -2}, {3, 4}, {4, 3}, {3, -4}, {-5, 12}, {-4, 3}}) {
          for (const double length : {1.0, -1.0}) {
            const Line line = {p, {p.x + length * way.x, p.y + length * way.y}};
            const auto at = movedCrossing(circles[0], circles[1], line);
            if (at) lines.push_back({line, *at});
          }
        }
      }
      ASSERT_GT(lines.size(), 20U);
      for (const Crossed& p : lines) {
        for (const Crossed& q : lines) {
          EXPECT_EQ(signs.isBefore(0, 1, p.line, q.line), p.place < q.place)
              << turn << ": " << p.line.from.x << " " << p.line.from.y << " to " << p.line.to.x << " " << p.line.to.y
              << ", " << q.line.from.x << " " << q.line.from.y << " to " << q.line.to.x << " " << q.line.to.y;
          ++compared;
        }
      }
    }
  }
  RecordProperty("compared", compared);
}

}  // namespace
}  // namespace shifted_signs_test
}  // namespace circle_voronoi
