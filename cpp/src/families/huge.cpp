// SPDX-License-Identifier: GPL-3.0-or-later
// A few huge circles among small ones.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "disjoint_circles.h"
#include "generators.h"

namespace circle_voronoi {
namespace {

constexpr Circle kUnitCircle = {0, 0, 1};

/// The center at a distance from a circle's center. Random arguments are drawn before the call, because compilers
/// evaluate arguments in different orders.
Point at(const Circle& circle, double distance, Vector direction) {
  return {circle.x + distance * direction.x, circle.y + distance * direction.y};
}

/// The unit circle, and equal ones just around it at equal angles; `draw` gives each one's gap in units of its radius.
template <class Draw>
std::vector<Circle> makeRing(std::size_t count, Draw drawGap) {
  if (count == 0) return {};
  std::vector<Circle> circles = {kUnitCircle};
  const double n = static_cast<double>(count - 1);
  // They take three fifths of the circumference, unless they are very few.
  const double part = std::min(0.2, 0.6 * std::numbers::pi / n);
  const double r = part / (1 - 1.5 * part);
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const Point p = at(kUnitCircle, 1 + r * (1 + drawGap()), directionAt(static_cast<double>(i) / n));
    circles.push_back({p.x, p.y, r});
  }
  return circles;
}

}  // namespace

std::vector<Circle> generateOneHuge(std::size_t count, Random& random) {
  DisjointCircles circles(count);
  if (count > 0) circles.insert(kUnitCircle);
  std::vector<double> radii(count == 0 ? 0 : count - 1);
  const double n = static_cast<double>(count);
  for (double& r : radii) r = random.uniform(0, 0.5 / n);
  std::ranges::sort(radii, std::greater<>());
  for (const double r : radii) {
    Point p;
    do {
      const Vector direction = random.direction();
      p = at(kUnitCircle, 1 + r + random.logUniform(-2, 1) / n, direction);
    } while (!circles.insert({p.x, p.y, r}));
  }
  return std::move(circles).take();
}

std::vector<Circle> generateTwoHuge(std::size_t count, Random& random) {
  DisjointCircles circles(count);
  const double gap = random.uniform(0.02, 0.4);
  for (const int side : {-1, 1}) {
    const double r = random.uniform(0.9, 1.1);
    if (circles.size() < count) circles.insert({side * (r + gap / 2), 0, r});
  }
  std::vector<double> radii(count - circles.size());
  const double largest = 0.1 / std::sqrt(std::max(100.0, static_cast<double>(count)));
  for (double& r : radii) r = random.uniform(0, largest);
  std::ranges::sort(radii, std::greater<>());
  for (const double r : radii) {
    while (!circles.insert({random.uniform(-0.2, 0.2), random.uniform(-0.5, 0.5), r})) {
    }
  }
  return std::move(circles).take();
}

std::vector<Circle> generateRing(std::size_t count, Random&) {
  return makeRing(count, [] { return 0.5; });
}

std::vector<Circle> generateRingVaried(std::size_t count, Random& random) {
  return makeRing(count, [&] { return random.uniform(0.05, 1); });
}

std::vector<Circle> generateRows(std::size_t count, Random& random) {
  const std::size_t hugeCount = std::min(count, 1 + count / 50);
  const std::size_t smallCount = count - hugeCount;
  std::vector<Circle> circles;
  double width = 0;
  for (std::size_t i = 0; i < hugeCount; ++i) {
    const double r = random.uniform(50, 100);
    const double gap = random.logUniform(-2, 1);
    circles.push_back({width + gap + r, r + random.logUniform(0, 1), r});
    width += gap + 2 * r;
  }
  const double pitch = width / static_cast<double>(smallCount + 1);
  const double largest = std::min(0.5, 0.4 * pitch);
  for (std::size_t i = 0; i < smallCount; ++i) {
    const double x = (static_cast<double>(i) + random.uniform(0.4, 0.6)) * pitch;
    circles.push_back({x, 0, random.uniform(0.1, 1) * largest});
  }
  return circles;
}

std::vector<Circle> generateExtreme(std::size_t count, Random& random) {
  DisjointCircles circles(count);
  std::vector<Circle> huge = {kUnitCircle};
  const std::size_t hugeCount = 1 + random.below(3);
  while (huge.size() < std::min(count, hugeCount)) {
    const Circle& neighbor = huge[random.below(huge.size())];
    const double r = random.uniform(0.5, 1);
    const Vector direction = random.direction();
    const Point p = at(neighbor, neighbor.r + r + random.logUniform(-4, -1), direction);
    const auto isFree = [&](const Circle& c) { return length({c.x - p.x, c.y - p.y}) > c.r + r; };
    if (std::ranges::all_of(huge, isFree)) huge.push_back({p.x, p.y, r});
  }
  for (const Circle& c : huge) {
    if (circles.size() < count) circles.insert(c);
  }

  std::vector<double> radii(count - circles.size());
  const double crowd = std::max(1.0, static_cast<double>(count) / 14);
  for (double& r : radii) r = random.below(5) == 0 ? 0 : random.logUniform(-5, -1) / crowd;
  std::ranges::sort(radii, std::greater<>());
  for (const double r : radii) {
    Point p;
    do {
      const Circle& near = huge[random.below(huge.size())];
      const Vector direction = random.direction();
      p = at(near, near.r + r + random.logUniform(-5, 0), direction);
    } while (!circles.insert({p.x, p.y, r}));
  }
  std::vector<Circle> result = std::move(circles).take();
  random.shuffle(result);
  return result;
}

}  // namespace circle_voronoi
