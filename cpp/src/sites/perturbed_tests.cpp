// SPDX-License-Identifier: GPL-3.0-or-later
#include "perturbed_tests.h"

#include <array>
#include <cmath>
#include <utility>

#include "in_circle.h"
#include "integers.h"

namespace circle_voronoi {
namespace {

bool isBefore(Point a, Point b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

}  // namespace

/// In this unit, sums of products below 2^53 are exact in double arithmetic, which decides the ties of grids; 0 if it
/// is so small that products might underflow.
double PerturbedTests::unit() {
  if (unit_ >= 0) return unit_;
  CommonUnit common;
  for (const Point& p : points_) {
    common.include(p.x);
    common.include(p.y);
  }
  return unit_ = common.exponent() < -200 ? 0 : std::ldexp(1.0, common.exponent());
}

int PerturbedTests::orientation(Point a, Point b, Point c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  // A difference that was rounded exceeds 2^53 units; so its product with one that is not zero is too large here.
  if (std::abs(left) + std::abs(right) < 0x1p52 * unit() * unit()) return (left > right) - (left < right);
  return circle_voronoi::orientation(a, b, c);
}

bool PerturbedTests::isInCircle(Point a, Point b, Point c, Point d) {
  const double ax = a.x - d.x, ay = a.y - d.y;
  const double bx = b.x - d.x, by = b.y - d.y;
  const double cx = c.x - d.x, cy = c.y - d.y;
  const double aa = ax * ax + ay * ay;
  const double bb = bx * bx + by * by;
  const double cc = cx * cx + cy * cy;
  int side;
  if (aa + bb + cc < 0x1p26 * unit() * unit()) {
    // The determinant and all on the way to it are at most (aa + bb + cc)^2 units^4.
    const double determinant = aa * (bx * cy - by * cx) + bb * (cx * ay - cy * ax) + cc * (ax * by - ay * bx);
    side = (determinant > 0) - (determinant < 0);
  } else {
    side = inCircle(a, b, c, d);
  }
  if (side != 0) return side > 0;

  // The point lifted most decides: d outside, or a corner, whose lifting makes room on the other side of its opposite
  // side. Of two of them one decides, for no three of four co-circular points are collinear.
  std::array<std::pair<Point, int>, 4> order = {{{a, 0}, {b, 1}, {c, 2}, {d, 3}}};
  for (int i = 1; i < 4; ++i) {
    for (int j = i; j > 0 && isBefore(order[j - 1].first, order[j].first); --j) std::swap(order[j - 1], order[j]);
  }
  switch (order[0].second) {
    case 0:
      return orientation(d, b, c) > 0;
    case 1:
      return orientation(a, d, c) > 0;
    case 2:
      return orientation(a, b, d) > 0;
    default:
      return false;
  }
}

}  // namespace circle_voronoi
