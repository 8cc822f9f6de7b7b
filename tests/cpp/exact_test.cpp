// SPDX-License-Identifier: GPL-3.0-or-later
// Exact predicates against their definition, evaluated with 500 decimal digits: a disc is solved for from its
// equations, and picked by the order in which it touches the circles. With integers of a few digits, results other than
// zero are far above the rounding error, so results below kZero are zero.
#include "exact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <optional>
#include <vector>

#include "predicates.h"
#include "report.h"
#include "tie_inputs.h"

namespace circle_voronoi {
namespace {

using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<500>, boost::multiprecision::et_off>;

const Real kZero("1e-250");

int signOf(const Real& value) { return value > kZero ? 1 : value < -kZero ? -1 : 0; }

struct Point2 {
  Real x, y;
};
Point2 operator-(const Point2& u, const Point2& v) { return {u.x - v.x, u.y - v.y}; }
Point2 operator+(const Point2& u, const Point2& v) { return {u.x + v.x, u.y + v.y}; }
Real crossOf(const Point2& u, const Point2& v) { return u.x * v.y - u.y * v.x; }
Point2 centerOf(const Circle& c) { return {c.x, c.y}; }

struct Disc {
  Point2 center;
  Real radius;
};

/// Whether the disc is on the outside of all three circles and touches them counter-clockwise.
bool touchesInOrder(const Disc& disc, const std::array<const Circle*, 3>& circles) {
  std::array<Point2, 3> directions;
  for (int i = 0; i < 3; ++i) {
    const Real distance = disc.radius + circles[i]->r;
    if (signOf(distance) < 0) return false;
    // At the center of a circle its direction is free, and any order is right.
    if (signOf(distance) == 0) return true;
    const Point2 v = centerOf(*circles[i]) - disc.center;
    directions[i] = {v.x / distance, v.y / distance};
  }
  return signOf(crossOf(directions[1] - directions[0], directions[2] - directions[0])) > 0;
}

/// Solves |p - c_i| = r_i + R: two differences of the squares are linear, which leaves a line in (x, y, R) space.
std::vector<Disc> touchingDiscs(const Circle& a, const Circle& b, const Circle& c) {
  struct Plane {
    Real x, y, s, k;
  };
  const auto plane = [&](const Circle& u) {
    const Real x = Real(u.x) - a.x, y = Real(u.y) - a.y, s = Real(u.r) - a.r;
    return Plane{x, y, s, (x * x + y * y - s * s) / 2};  // x X + y Y + s (R + r_a) = k
  };
  const Plane p = plane(b);
  const Plane q = plane(c);
  // The line runs along (dx, dy, ds); one of its points has the coordinate 0 where the determinant of the other two is
  // not 0.
  const Real dx = p.y * q.s - p.s * q.y;
  const Real dy = p.s * q.x - p.x * q.s;
  const Real ds = p.x * q.y - p.y * q.x;
  Real x = 0, y = 0, s = 0;
  if (signOf(ds) != 0) {
    x = (p.k * q.y - p.y * q.k) / ds;
    y = (p.x * q.k - p.k * q.x) / ds;
  } else if (signOf(dy) != 0) {
    x = (p.s * q.k - p.k * q.s) / dy;
    s = (p.k * q.x - p.x * q.k) / dy;
  } else if (signOf(dx) != 0) {
    y = (p.k * q.s - p.s * q.k) / dx;
    s = (p.y * q.k - p.k * q.y) / dx;
  } else {
    return {};
  }
  const Real qa = dx * dx + dy * dy - ds * ds;
  const Real qb = x * dx + y * dy - s * ds;
  const Real qc = x * x + y * y - s * s;
  std::vector<Real> roots;
  if (signOf(qa) == 0) {
    if (signOf(qb) != 0) roots = {-qc / (2 * qb)};
  } else {
    const Real discriminant = qb * qb - qa * qc;
    if (signOf(discriminant) < 0) return {};
    const Real root = discriminant > 0 ? Real(sqrt(discriminant)) : Real(0);
    roots = {(-qb - root) / qa, (-qb + root) / qa};
  }
  std::vector<Disc> discs;
  for (const Real& t : roots) discs.push_back({{a.x + x + t * dx, a.y + y + t * dy}, s + t * ds - a.r});
  return discs;
}

/// A direction to the disc of a face, seen from one of its circles; at infinity the normal of the tangent line.
std::optional<Point2> directionOf(const exact::Face& face, const Circle& from) {
  if (face[2] == nullptr) {
    const Circle& a = *face[0];
    const Circle& b = *face[1];
    // n . c + r is the same for both circles, the largest there is; the line is to the left of a -> b.
    const Point2 d = centerOf(b) - centerOf(a);
    const Real length2 = d.x * d.x + d.y * d.y;
    const Real along = (Real(a.r) - b.r) / length2;
    const Real across = sqrt(1 - along * along * length2) / sqrt(length2);
    return Point2{along * d.x - across * d.y, along * d.y + across * d.x};
  }
  for (const Disc& disc : touchingDiscs(*face[0], *face[1], *face[2])) {
    if (touchesInOrder(disc, face)) return disc.center - centerOf(from);
  }
  return std::nullopt;
}

bool hides(const Circle& outer, const Circle& inner) {
  const Point2 d = centerOf(outer) - centerOf(inner);
  const Real s = Real(outer.r) - inner.r;
  return s >= 0 && d.x * d.x + d.y * d.y <= s * s;
}

std::vector<Circle> visible(const std::vector<Circle>& circles) {
  std::vector<Circle> result;
  for (std::size_t i = 0; i < circles.size(); ++i) {
    bool hidden = false;
    for (std::size_t j = 0; j < circles.size(); ++j)
      hidden = hidden || (i != j && hides(circles[j], circles[i]) && (j < i || circles[i] != circles[j]));
    if (!hidden) result.push_back(circles[i]);
  }
  return result;
}

struct Seen {
  exact::Face face;
  Point2 direction;
};

void compareContains(const std::vector<Circle>& circles) {
  for (const Circle& outer : circles) {
    for (const Circle& inner : circles) EXPECT_EQ(exact::contains(outer, inner), hides(outer, inner));
  }
}

/// All three numbers of a disc to 48 bits of themselves, or of its distance from the smallest circle.
void compareDisc(const exact::Face& face, const Point2& center) {
  const std::optional<Vertex> disc = exact::disc(face);
  ASSERT_TRUE(disc.has_value());
  const Circle& o = **std::min_element(face.begin(), face.end(), [](auto* a, auto* b) { return a->r < b->r; });
  const Point2 v = center - centerOf(o);
  const Real radius = sqrt(Real(v.x * v.x + v.y * v.y)) - o.r;
  const auto compare = [](double actual, const Real& expected, const Real& offset) {
    EXPECT_LE(abs(Real(actual) - expected), 0x1p-48 * (abs(offset) + abs(expected)) + kZero);
  };
  compare(disc->x, center.x, v.x);
  compare(disc->y, center.y, v.y);
  compare(disc->r, radius, radius + o.r);
}

bool shareAnEdge(const exact::Face& a, const exact::Face& b) {
  return std::count_if(a.begin(), a.end(), [&](auto* c) { return std::find(b.begin(), b.end(), c) != b.end(); }) >= 2;
}

/// Directions from the first circle to all its discs.
void compareFrom(const std::vector<Circle>& circles) {
  const Circle& from = circles[0];
  std::vector<Seen> seen;
  for (std::size_t i = 1; i < circles.size(); ++i) {
    seen.push_back({{&from, &circles[i], nullptr}, *directionOf({&from, &circles[i], nullptr}, from)});
    seen.push_back({{&circles[i], &from, nullptr}, *directionOf({&circles[i], &from, nullptr}, from)});
    for (std::size_t j = 1; j < circles.size(); ++j) {
      if (j == i) continue;
      const exact::Face face = {&from, &circles[i], &circles[j]};
      const auto direction = directionOf(face, from);
      ASSERT_EQ(exact::hasDisc(face), direction.has_value()) << i << ", " << j;
      if (!direction) continue;
      seen.push_back({face, *direction});
      compareDisc(face, *direction + centerOf(from));
    }
  }
  for (const Seen& s : seen) {
    const Real x = exact::kAxisX, y = exact::kAxisY;
    EXPECT_EQ(exact::directionSign(s.face, from, 0), signOf(x * s.direction.x + y * s.direction.y));
    EXPECT_EQ(exact::directionSign(s.face, from, 1), signOf(x * s.direction.y - y * s.direction.x));
    for (const Seen& t : seen) {
      if (!shareAnEdge(s.face, t.face)) continue;
      EXPECT_EQ(exact::crossSign(s.face, t.face, from), signOf(crossOf(s.direction, t.direction)));
    }
  }
}

void compareTangentSides(const std::vector<Circle>& circles) {
  for (std::size_t i = 1; i < circles.size(); ++i) {
    const Circle& a = circles[0];
    const Circle& b = circles[i];
    const Point2 n = *directionOf({&a, &b, nullptr}, a);
    for (std::size_t j = 1; j < circles.size(); ++j) {
      if (j == i) continue;
      const Circle& c = circles[j];
      const Real beyond = n.x * (Real(c.x) - a.x) + n.y * (Real(c.y) - a.y) + c.r - a.r;
      EXPECT_EQ(exact::tangentSide(a, b, c), signOf(beyond));
    }
  }
}

/// Bits for which results other than zero are still far above the rounding error.
constexpr std::array kDisturbed = {test::Disturbance::lastPlace, test::Disturbance::slight, test::Disturbance::far,
                                   test::Disturbance::oneHuge};

TEST(Exact, AgreesWithTheDefinition) {
  const std::uint64_t seed = test::seedOr(1);
  for (const test::TieKind& kind : test::tieKinds()) {
    for (std::uint64_t trial = 0; trial < 40; ++trial) {
      Random random(seed * 1'000'003 + trial);
      auto circles = kind.make(5, random);
      if (trial % 4 == 3) test::disturb(circles, kDisturbed[trial / 4 % kDisturbed.size()], random);
      compareContains(circles);
      circles = visible(circles);
      compareFrom(circles);
      compareTangentSides(circles);
      if (testing::Test::HasFailure()) FAIL() << kind.name << ", trial " << trial << test::describe(circles);
    }
  }
}

TEST(Exact, FindsTies) {
  // All touch the disc of radius 5 around the origin, one of them inside out.
  const std::array<Circle, 4> circles = {{{10, 0, 5}, {0, 13, 8}, {-3, -4, 0}, {24, -7, 20}}};
  const exact::Face first = {&circles[0], &circles[1], &circles[2]};
  const exact::Face second = {&circles[0], &circles[2], &circles[3]};
  EXPECT_EQ(exact::crossSign(first, second, circles[0]), 0);
  EXPECT_EQ(exact::crossSign(first, second, circles[2]), 0);
  // On one tangent line.
  const std::array<Circle, 3> row = {{{0, 1, 1}, {5, 3, 3}, {-7, 0, 0}}};
  EXPECT_EQ(exact::tangentSide(row[1], row[0], row[2]), 0);
  EXPECT_EQ(exact::tangentSide(row[1], row[2], row[0]), 0);
  // Inside, touching.
  EXPECT_TRUE(exact::contains({0, 0, 10}, {3, 4, 5}));
  EXPECT_FALSE(exact::contains({0, 0, 10}, {3, 4, std::nextafter(5.0, 6.0)}));
}

}  // namespace
}  // namespace circle_voronoi
