// SPDX-License-Identifier: GPL-3.0-or-later
// Compares error bounds with errors. No error exceeds its bound, and the worst one found exceeds a tenth of it, so the
// test would notice a bound that is ten times too small. Hill climbing from random circles finds the worst errors.
#include "estimate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "homogeneous_disc.h"
#include "in_circle.h"
#include "random.h"
#include "refined.h"
#include "report.h"
#include "two_part.h"

namespace circle_voronoi {
namespace {

using Real = boost::multiprecision::cpp_bin_float_100;
using Circles = std::array<Circle, 4>;

/// A difference of circles, exactly, as the estimates take it.
struct Exact {
  Real x, y, s;
  Exact(const Circle& u, const Circle& o) : x(Real(u.x) - o.x), y(Real(u.y) - o.y), s(Real(u.r) - o.r) {}
  Exact(const Real& x_, const Real& y_, const Real& s_) : x(x_), y(y_), s(s_) {}
};
Real coneOf(const Exact& u, const Exact& v) { return u.x * v.x + u.y * v.y - u.s * v.s; }
bool hide(const Circle& a, const Circle& b) { return coneOf({a, b}, {a, b}) <= 0; }

/// The part of the bound that an error takes; 0 if nothing was computed.
double part(const Real& exact, double value, double error) {
  return std::isfinite(error) ? static_cast<double>(abs(Real(exact - value)) / error) : 0;
}
/// Ignores rounding that does not change the sign.
double part(const Real& exact, const Estimate& estimate) {
  if (!std::isfinite(estimate.error)) return 0;
  const Real wrong = abs(Real(exact - estimate.value)) - kUnitRoundoff * abs(Real(estimate.value));
  return static_cast<double>(wrong / estimate.error);
}

Point centerOf(const Circle& c) { return {c.x, c.y}; }

double orientationPart(const Circles& c) {
  const Exact u(c[0], c[2]);
  const Exact v(c[1], c[2]);
  return part(u.x * v.y - u.y * v.x, orientationOf(centerOf(c[0]), centerOf(c[1]), centerOf(c[2])));
}

template <bool kIsFine>
double inCirclePart(const Circles& c) {
  const Exact u(c[0], c[3]);
  const Exact v(c[1], c[3]);
  const Exact w(c[2], c[3]);
  const Real exact = (u.x * u.x + u.y * u.y) * (v.x * w.y - v.y * w.x) +
                     (v.x * v.x + v.y * v.y) * (w.x * u.y - w.y * u.x) +
                     (w.x * w.x + w.y * w.y) * (u.x * v.y - u.y * v.x);
  const InCircleEstimate estimate(centerOf(c[0]), centerOf(c[1]), centerOf(c[2]), centerOf(c[3]));
  return part(exact, kIsFine ? estimate.fine() : estimate.coarse());
}

double tangentLengthPart(const Circles& c) {
  const Exact d(c[0], c[1]);
  return part(coneOf(d, d), tangentLengthSquared(c[0], c[1]));
}

double infinityPart(const Circles& c) {
  if (hide(c[0], c[1])) return 0;
  const HomogeneousDisc disc = discAtInfinity(c[0], c[1]);
  const Exact d(c[1], c[0]);
  const Real root = sqrt(coneOf(d, d));
  return std::max(part(-d.s * d.x - root * d.y, disc.x, disc.error), part(-d.s * d.y + root * d.x, disc.y, disc.error));
}

Real exactReach(const Circles& c) {
  const Exact d(c[1], c[0]);
  const Exact e(c[2], c[0]);
  return e.s * (d.x * d.x + d.y * d.y) - d.s * (d.x * e.x + d.y * e.y) + (d.x * e.y - d.y * e.x) * sqrt(coneOf(d, d));
}

double reachPart(const Circles& c) { return hide(c[0], c[1]) ? 0 : part(exactReach(c), reachBeyond(c[0], c[1], c[2])); }

double refinedReachPart(const Circles& c) {
  return hide(c[0], c[1]) ? 0 : part(2 * exactReach(c), refinedReach(c[0], c[1], c[2]));
}

Exact crossOf3(const Exact& a, const Exact& b) {
  return {a.y * b.s - a.s * b.y, a.s * b.x - a.x * b.s, a.x * b.y - a.y * b.x};
}

/// A homogeneous disc, exactly, of any scale.
struct ExactDisc {
  Real x, y, rho, w;
};

/// In the scale of discOf, relative to a circle of which a and b are the differences of the others.
ExactDisc exactDisc(const Exact& a, const Exact& b) {
  const Exact side(a.x - b.x, a.y - b.y, a.s - b.s);
  const Exact n = crossOf3(a, b);
  const Real g11 = coneOf(a, a), g22 = coneOf(b, b), g12 = coneOf(a, b);
  const Real root = sqrt(Real(g11 * g22 * coneOf(side, side)));
  const Real alpha = g22 * (g11 - g12), beta = g11 * (g22 - g12), k = coneOf(n, n);
  const int turn = k < 0 ? 1 : -1;
  return {turn * (alpha * a.x + beta * b.x + n.x * root), turn * (alpha * a.y + beta * b.y + n.y * root),
          turn * (n.s * root - alpha * a.s - beta * b.s), -2 * turn * k};
}

/// In the scale of refinedDiscOf: the direction and the offset of the tangent line after inversion (exact.cpp).
ExactDisc exactRefinedDisc(const Exact& a, const Exact& b) {
  const Real g11 = coneOf(a, a), g22 = coneOf(b, b);
  const Exact d(a.x * g22 - b.x * g11, a.y * g22 - b.y * g11, a.s * g22 - b.s * g11);
  const Exact n = crossOf3(a, b);
  const Real root = sqrt(coneOf(d, d));
  const Real w = 2 * (d.y * n.x - d.x * n.y + n.s * root);
  const int turn = w < 0 ? -1 : 1;
  return {turn * (-d.s * d.x - root * d.y), turn * (-d.s * d.y + root * d.x), turn * (d.x * d.x + d.y * d.y), turn * w};
}

/// The power of two by which refined discs and directions are divided, of the circles p and q as seen from o.
double magnitudeOf(const Circle& o, const Circle* p, const Circle* q) {
  const auto sizeOf = [&](const Circle* c) { return c == nullptr ? 0 : size(Difference(*c, o)); };
  const auto squareOf = [&](const Circle* c) { return c == nullptr ? 1 : tangentSquare(*c, o).square.value; };
  const double whole = sizeOf(p) * squareOf(q) + sizeOf(q) * squareOf(p);
  return whole > 0 ? std::ldexp(1, std::ilogb(whole)) : 1;
}

/// Checks the directions and distances to a disc from all its circles.
template <CornerDisc (*find)(const Circle&, const Circle&, const Circle&),
          ExactDisc (*exactly)(const Exact&, const Exact&)>
double discPart(const Circles& c) {
  if (hide(c[0], c[1]) || hide(c[1], c[2]) || hide(c[0], c[2])) return 0;
  const auto [disc, corner] = find(c[0], c[1], c[2]);
  if (!std::isfinite(disc.error)) return 0;
  const Circle& o = c[corner];
  const Circle& u = c[(corner + 1) % 3];
  const Circle& v = c[(corner + 2) % 3];
  const ExactDisc whole = exactly({u, o}, {v, o});
  const Real magnitude = find == refinedDiscOf ? magnitudeOf(o, &u, &v) : 1;
  const Real x = whole.x / magnitude, y = whole.y / magnitude, rho = whole.rho / magnitude, w = whole.w / magnitude;
  double worst = 0;
  for (int i = 0; i < 3; ++i) {
    const Exact shift(o, c[i]);
    const auto seen = [&](double from, double moved) { return from + disc.w * moved; };
    worst = std::max({worst, part(x + w * shift.x, seen(disc.x, o.x - c[i].x), disc.error),
                      part(y + w * shift.y, seen(disc.y, o.y - c[i].y), disc.error),
                      part(rho - w * shift.s, distanceOf(c[i], disc, o).value, distanceOf(c[i], disc, o).error)});
  }
  return worst;
}

Real squareOf(const Circle* a, const Circle* b) {
  if (a == nullptr || b == nullptr) return 1;
  const Exact d(*a, *b);
  return coneOf(d, d);
}

/// (x, y, s) of a circle seen from another, of infinity nothing.
Exact seenFrom(const Circle* c, const Circle& o) { return c == nullptr ? Exact(0, 0, 0) : Exact(*c, o); }

struct ExactAxis {
  Exact d;
  Real root;
};

ExactAxis axisOf(const Circle& o, const Circle* p, const Circle* q) {
  const Real gp = squareOf(p, &o), gq = squareOf(q, &o);
  const Exact u = seenFrom(p, o), v = seenFrom(q, o);
  return {{u.x * gq - v.x * gp, u.y * gq - v.y * gp, u.s * gq - v.s * gp}, sqrt(Real(gp * gq * squareOf(p, q)))};
}

/// The direction to a disc, times the squared length of the axis.
std::array<Real, 2> exactDirection(const ExactAxis& axis) {
  const auto& [d, root] = axis;
  return {-d.s * d.x - root * d.y, -d.s * d.y + root * d.x};
}

/// Faces (a, b, c) and (b, a, d) of the four circles, and with infinity as d, seen from a.
template <class Compare>
double worstOfTurns(const Circles& c, Compare compare) {
  for (std::size_t i = 0; i < c.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (hide(c[i], c[j])) return 0;
    }
  }
  const exact::Face one = {&c[0], &c[1], &c[2]};
  return std::max(compare(one, exact::Face{&c[1], &c[0], &c[3]}, c[0]),
                  compare(exact::Face{&c[1], &c[0], nullptr}, one, c[0]));
}

/// Checks the parts of refinedTurn.
template <Estimate RefinedTurn::*kPart>
double turnPartOf(const Circles& c) {
  return worstOfTurns(c, [](const exact::Face& first, const exact::Face& second, const Circle& from) {
    const RefinedTurn turn = refinedTurn(first, second, from);
    const auto [p, q] = exact::othersOf(first, &from);
    const auto [y, z] = exact::othersOf(second, &from);
    const ExactAxis d = axisOf(from, p, q);
    const ExactAxis e = axisOf(from, y, z);
    auto toFirst = exactDirection(d);
    for (Real& component : toFirst) component /= magnitudeOf(from, p, q);
    if constexpr (kPart == &RefinedTurn::cross) {
      const auto toSecond = exactDirection(e);
      return part((toFirst[0] * toSecond[1] - toFirst[1] * toSecond[0]) / magnitudeOf(from, y, z), turn.cross);
    } else if constexpr (kPart == &RefinedTurn::left) {
      return part(e.d.x * toFirst[1] - e.d.y * toFirst[0], turn.left);
    }
    const Circle* n = turn.added;
    const Exact u = seenFrom(p, from), v = seenFrom(q, from), w = seenFrom(n, from);
    const Real gp = squareOf(p, &from), gq = squareOf(q, &from), gn = squareOf(n, &from);
    const Exact vu = crossOf3(v, u), uw = crossOf3(u, w), wv = crossOf3(w, v);
    const Exact m(gn * vu.x + gq * uw.x + gp * wv.x, gn * vu.y + gq * uw.y + gp * wv.y,
                  gn * vu.s + gq * uw.s + gp * wv.s);
    if constexpr (kPart == &RefinedTurn::norm) {
      // Not in the form that refinedTurn has.
      return part(4 * coneOf(m, m), turn.norm);
    } else {
      const Real conjugate = m.x * d.d.y - m.y * d.d.x - m.s * d.root;
      return part(conjugate, turn.factor);
    }
  });
}

/// The circles in their directions, so that they touch the unit circle: what rounding leaves of the norm then shows its
/// error, which is far less than the last place of a norm of other circles.
double normPart(const Circles& c) {
  Circles touching = c;
  for (Circle& circle : touching) {
    const double l = length({circle.x, circle.y});
    if (l == 0) return 0;
    circle = {(1 + circle.r) * circle.x / l, (1 + circle.r) * circle.y / l, circle.r};
  }
  return turnPartOf<&RefinedTurn::norm>(touching);
}

/// N of a disc, relative to its corner.
Exact normalOf(const Circles& c, int corner) {
  const Exact a(c[(corner + 1) % 3], c[corner]);
  const Exact b(c[(corner + 2) % 3], c[corner]);
  return {a.y * b.s - a.s * b.y, a.s * b.x - a.x * b.s, a.x * b.y - a.y * b.x};
}

/// Inputs where N is so short that the bound of k hardly counts.
double flatDiscPart(const Circles& c) {
  const int corner = discOf(c[0], c[1], c[2]).corner;
  const Exact n = normalOf(c, corner);
  const double longest =
      std::sqrt(sizeSquared({c[(corner + 1) % 3], c[corner]}) * sizeSquared({c[(corner + 2) % 3], c[corner]}));
  return abs(n.x) + abs(n.y) + abs(n.s) < 0.01 * longest ? discPart<discOf, exactDisc>(c) : 0;
}

/// The share of k, which has to exceed its bound.
double turnPart(const Circles& c) {
  if (hide(c[0], c[1]) || hide(c[1], c[2]) || hide(c[0], c[2])) return 0;
  const auto [disc, corner] = discOf(c[0], c[1], c[2]);
  if (!std::isfinite(disc.error)) return 0;
  const Exact n = normalOf(c, corner);
  const Real k = coneOf(n, n);
  const Circle& o = c[corner];
  const Difference a(c[(corner + 1) % 3], o), b(c[(corner + 2) % 3], o);
  const Difference computed(a.y * b.s - a.s * b.y, a.s * b.x - a.x * b.s, a.x * b.y - a.y * b.x);
  const double value = lorentzDot(computed, computed);
  return part(k, value, std::abs(value));
}

/// Directions that are wrong by as much as they may be, each component either way.
template <class Compare>
double worstOfSigns(Random& random, Compare compare) {
  double worst = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const auto direction = [&] {
      const double size = random.logUniform(-20, 20);
      return Direction{size * random.uniform(-1, 1), size * random.uniform(-1, 1),
                       size * random.logUniform(-18, 0) * static_cast<double>(random.below(2))};
    };
    const Direction f = direction();
    const Direction g = direction();
    for (unsigned signs = 0; signs < 16; ++signs) {
      const auto moved = [&](double value, double error, unsigned bit) {
        return Real(value) + ((signs & bit) != 0 ? Real(error) : Real(-error));
      };
      const std::array<Real, 4> exact = {moved(f.x, f.error, 1), moved(f.y, f.error, 2), moved(g.x, g.error, 4),
                                         moved(g.y, g.error, 8)};
      worst = std::max(worst, compare(f, g, exact));
    }
  }
  return worst;
}

Circles randomCircles(Random& random, std::uint64_t kind) {
  Circles circles;
  for (Circle& c : circles) {
    c = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0, 0.6)};
    if (kind == 1) {  // nearly touching a large circle from inside
      const Vector v = random.direction();
      const double r = random.uniform(0, 1);
      const double distance = (1 - r) * (1 + random.uniform(-1e-3, 1e-3));
      c = {distance * v.x, distance * v.y, r};
    } else if (kind == 2) {  // nearly on a line
      c = {c.x, 0.3 * c.x + 1e-4 * c.y, 0.2 + 1e-4 * c.r};
    }
  }
  return circles;
}

void move(Circles& circles, Random& random) {
  for (std::size_t times = 1 + random.below(3); times > 0; --times) {
    Circle& c = circles[random.below(circles.size())];
    const double step = std::exp2(random.uniform(-52, -2)) * random.uniform(-1, 1);
    const std::size_t which = random.below(3);
    if (which == 0) c.x += step;
    if (which == 1) c.y += step;
    if (which == 2) c.r = std::abs(c.r + step);
  }
}

struct Bound {
  const char* name;
  double (*part)(const Circles& circles);
  double least = 0.1;  ///< of the bound: an error that large can be found
};

class EstimateBound : public testing::TestWithParam<Bound> {};

TEST_P(EstimateBound, IsNeitherTooSmallNorFarTooLarge) {
  const std::uint64_t seed = test::seedOr(1);
  double worst = 0;
  // A hill may end low: more than one start.
  for (std::uint64_t start = 0; start < 8 && worst < 1.2 * GetParam().least; ++start) {
    Random random(seed * 1'000'003 + start);
    Circles best = randomCircles(random, 0);
    double height = 0;
    const auto take = [&](const Circles& circles) {
      const double found = GetParam().part(circles);
      ASSERT_LE(found, 1) << test::describe(circles);
      if (found <= height) return;
      height = found;
      best = circles;
    };
    for (std::uint64_t trial = 0; trial < 2000; ++trial) take(randomCircles(random, trial % 3));
    for (int step = 0; step < 8000; ++step) {
      Circles circles = best;
      move(circles, random);
      take(circles);
    }
    worst = std::max(worst, height);
  }
  EXPECT_GT(worst, GetParam().least);
  RecordProperty("worst", std::to_string(worst));
}

INSTANTIATE_TEST_SUITE_P(Each, EstimateBound,
                         testing::Values(Bound{"Orientation", orientationPart}, Bound{"InCircle", inCirclePart<false>},
                                         Bound{"InCircleFine", inCirclePart<true>},
                                         Bound{"TangentLength", tangentLengthPart}, Bound{"Infinity", infinityPart},
                                         Bound{"Reach", reachPart}, Bound{"Disc", discPart<discOf, exactDisc>},
                                         Bound{"RefinedDisc", discPart<refinedDiscOf, exactRefinedDisc>},
                                         Bound{"RefinedReach", refinedReachPart},
                                         Bound{"RefinedCross", turnPartOf<&RefinedTurn::cross>},
                                         Bound{"RefinedLeft", turnPartOf<&RefinedTurn::left>},
                                         Bound{"RefinedFactor", turnPartOf<&RefinedTurn::factor>},
                                         Bound{"RefinedNorm", normPart, 0.03}, Bound{"FlatDisc", flatDiscPart, 0.06},
                                         Bound{"Turn", turnPart, 0.05}),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(Estimate, OfACrossProductCoversTheErrorsOfItsDirections) {
  Random random(test::seedOr(1));
  const double worst = worstOfSigns(random, [](const Direction& f, const Direction& g, const auto& exact) {
    return part(exact[0] * exact[3] - exact[1] * exact[2], crossOf(f, g));
  });
  EXPECT_LE(worst, 1);
  EXPECT_GT(worst, 0.1);
}

TEST(Estimate, OfAHeightCoversTheErrorOfItsDirection) {
  Random random(test::seedOr(1));
  const double worst = worstOfSigns(random, [](const Direction& f, const Direction&, const auto& exact) {
    return part(exact::kAxisX * exact[1] - exact::kAxisY * exact[0], heightOf(f));
  });
  EXPECT_LE(worst, 1);
  EXPECT_GT(worst, 0.1);
}

}  // namespace
}  // namespace circle_voronoi
