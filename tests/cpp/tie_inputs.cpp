// SPDX-License-Identifier: GPL-3.0-or-later
#include "tie_inputs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "rounded.h"

namespace circle_voronoi::test {
namespace {

double integer(Random& random, int low, int high) {
  return static_cast<double>(low + static_cast<int>(random.below(static_cast<std::size_t>(high - low + 1))));
}

/// x^2 + y^2 = z^2, turned and mirrored at random.
struct Pythagorean {
  double x, y, z;
};

Pythagorean pythagorean(Random& random) {
  static constexpr std::array<Pythagorean, 5> kTriples = {
      {{1, 0, 1}, {3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {20, 21, 29}}};
  Pythagorean p = kTriples[random.below(kTriples.size())];
  if (random.below(2) == 0) std::swap(p.x, p.y);
  if (random.below(2) == 0) p.x = -p.x;
  if (random.below(2) == 0) p.y = -p.y;
  return p;
}

std::vector<Circle> onGrid(std::size_t count, Random& random) {
  std::vector<Circle> circles;
  for (std::size_t i = 0; i < count; ++i)
    circles.push_back({integer(random, -4, 4), integer(random, -4, 4), integer(random, 0, 2)});
  return circles;
}

/// Centers at distance 5 * 13 * 17 * 29 from the origin.
std::vector<Circle> onOneCircle(std::size_t count, Random& random) {
  const double r = integer(random, 0, 9);
  std::vector<Circle> circles;
  for (std::size_t i = 0; i < count; ++i) {
    const Pythagorean p = pythagorean(random);
    const double f = 32045 / p.z;
    circles.push_back({p.x * f, p.y * f, r});
  }
  return circles;
}

/// At distance d from the origin with radius d - R: all touch the disc of radius R, which may be negative.
std::vector<Circle> touchingOneDisc(std::size_t count, Random& random) {
  const double radius = integer(random, -30, 30);
  std::vector<Circle> circles;
  while (circles.size() < count) {
    const Pythagorean p = pythagorean(random);
    const double f = integer(random, 1, 40);
    if (p.z * f >= radius) circles.push_back({p.x * f, p.y * f, p.z * f - radius});
  }
  return circles;
}

/// Above a line through the origin that they touch.
std::vector<Circle> touchingOneLine(std::size_t count, Random& random) {
  const Pythagorean p = pythagorean(random);
  std::vector<Circle> circles;
  for (std::size_t i = 0; i < count; ++i) {
    const double along = integer(random, -20, 20);
    const double r = integer(random, 0, 6);
    circles.push_back({p.x * along - p.y * r, p.y * along + p.x * r, p.z * r});
  }
  return circles;
}

/// The first of radius 58 touches all others, which lie inside it, or just miss lying inside it by one.
std::vector<Circle> touchingInside(std::size_t count, Random& random) {
  std::vector<Circle> circles = {{0, 0, 58}};
  while (circles.size() < count) {
    const Pythagorean p = pythagorean(random);
    const double f = integer(random, 1, 2);
    circles.push_back({p.x * f, p.y * f, 58 - p.z * f + integer(random, 0, 1)});
  }
  return circles;
}

std::vector<Circle> onOneLine(std::size_t count, Random& random) {
  const Pythagorean p = pythagorean(random);
  const double r = integer(random, 0, 3);
  std::vector<Circle> circles;
  for (std::size_t i = 0; i < count; ++i) {
    const double along = integer(random, -20, 20);
    circles.push_back({p.x * along, p.y * along, r});
  }
  return circles;
}

std::vector<Circle> inColumns(std::size_t count, Random& random) {
  std::vector<Circle> circles;
  for (std::size_t i = 0; i < count; ++i) {
    const double column = integer(random, 0, 4);
    circles.push_back({4 * column, 4 * integer(random, 0, 4), 1 + column / 8192});
  }
  return circles;
}

constexpr std::array<TieKind, 7> kKinds = {{
    {"grid", onGrid},
    {"one circle", onOneCircle},
    {"one disc", touchingOneDisc},
    {"one tangent line", touchingOneLine},
    {"touching inside", touchingInside},
    {"one line", onOneLine},
    {"columns", inColumns},
}};

double& number(Circle& c, std::size_t index) { return index == 0 ? c.x : index == 1 ? c.y : c.r; }

void moveToNext(std::vector<Circle>& circles, Random& random) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  for (std::size_t times = 1 + random.below(3); times > 0; --times) {
    double& value = number(circles[random.below(circles.size())], random.below(3));
    // The neighbors of zero are too small for the ties of larger numbers to notice.
    if (value == 0) continue;
    value = std::nextafter(value, random.below(2) == 0 ? kInfinite : -kInfinite);
  }
}

}  // namespace

std::span<const TieKind> tieKinds() { return kKinds; }

void disturb(std::vector<Circle>& circles, Disturbance disturbance, Random& random) {
  if (circles.empty()) return;
  switch (disturbance) {
    case Disturbance::none:
      break;
    case Disturbance::lastPlace:
      moveToNext(circles, random);
      break;
    case Disturbance::slight:
      for (Circle& c : circles) {
        for (std::size_t i = 0; i < 3; ++i) number(c, i) *= 1 + random.uniform(-1e-12, 1e-12);
      }
      break;
    case Disturbance::scaled: {
      const double factor = random.logUniform(-15, 23);
      for (Circle& c : circles) c = {c.x * factor, c.y * factor, c.r * factor};
      break;
    }
    case Disturbance::far: {
      const double distance = random.logUniform(7, 15);
      const double angle = random.uniform(-1, 1);
      for (Circle& c : circles) c = {c.x + distance, c.y + distance * angle, c.r};
      break;
    }
    case Disturbance::oneHuge: {
      Circle& c = circles[random.below(circles.size())];
      const double factor = std::ldexp(1.0, 20 + static_cast<int>(random.below(40)));
      c = {c.x * factor, c.y * factor, c.r * factor};
      break;
    }
    case Disturbance::oneTiny: {
      const Circle o = circles[random.below(circles.size())];
      const double factor = std::ldexp(1.0, -20 - static_cast<int>(random.below(70)));
      // Around the origin, where doubles are dense.
      for (Circle& c : circles) c = {c.x - o.x, c.y - o.y, c.r};
      Circle& c = circles[random.below(circles.size())];
      c = {c.x * factor, c.y * factor, c.r * factor};
      break;
    }
    case Disturbance::allTiny: {
      if (random.below(2) == 0) moveToNext(circles, random);
      circles = besideFarPoint(std::move(circles), random);
      break;
    }
  }
  for (Circle& c : circles) c = rounded(c);
}

std::vector<Circle> besideFarPoint(std::vector<Circle> circles, Random& random) {
  double largest = 0;
  for (const Circle& c : circles) largest = std::max({largest, std::abs(c.x), std::abs(c.y), c.r});
  const int exponent = largest > 0 ? std::ilogb(largest) : 0;
  const double factor = std::ldexp(1.0, -static_cast<int>(random.below(44)) - exponent);
  for (Circle& c : circles) c = rounded(Circle{c.x * factor, c.y * factor, c.r * factor});
  circles.push_back({random.below(2) == 0 ? -0x1p96 : 0x1p96, 0x1p96 * random.uniform(-1, 1), 0});
  return circles;
}

std::vector<Circle> nestedTightly(std::size_t count, Random& random) {
  const double slack = std::ldexp(1 + random.uniform(0, 1), -static_cast<int>(random.below(44)));
  std::vector<Circle> circles = {{-0x1p96, 0, 0}};
  double r = 4 * slack * static_cast<double>(count);
  Point p = {r, 0};
  for (std::size_t i = 0; i < count; ++i) {
    circles.push_back(rounded(Circle{p.x, p.y, r}));
    // Moves by less or more than the slack, so that some circles stick out.
    p = {p.x + slack * random.uniform(-1, 1), p.y + slack * random.uniform(-1, 1)};
    r -= slack;
  }
  return circles;
}

std::vector<Circle> onDyadicGrid(std::vector<Circle> circles) {
  double low = INFINITY;
  double extent = 0;
  for (const Circle& c : circles) low = std::min({low, c.x, c.y});
  for (const Circle& c : circles) extent = std::max({extent, c.x - low, c.y - low, c.r});
  const auto rounded = [&](double value) { return std::round(value / extent * 0x1p20) * 0x1p-10; };
  for (Circle& c : circles) c = {rounded(c.x - low), rounded(c.y - low), rounded(c.r)};
  return circles;
}

void forEachTie(std::uint64_t seed, std::uint64_t trials,
                const std::function<void(const std::vector<Circle>&, std::string_view kind)>& use) {
  for (const TieKind& kind : kKinds) {
    for (std::uint64_t trial = 0; trial < trials; ++trial) {
      Random random(seed * 1'000'003 + trial);
      auto circles = kind.make(2 + random.below(40), random);
      disturb(circles, Disturbance{static_cast<int>(trial % kDisturbances)}, random);
      use(circles, kind.name);
    }
  }
}

}  // namespace circle_voronoi::test
