// SPDX-License-Identifier: GPL-3.0-or-later
// Disjoint circles of comparable or different sizes.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "disjoint_circles.h"
#include "generators.h"

namespace circle_voronoi {
namespace {

/// Returns circles with these radii at random places in a square. `covered` is the fraction of the square that they
/// cover.
DisjointCircles place(std::vector<double> radii, double covered, Random& random) {
  std::ranges::sort(radii, std::greater<>());
  double area = 0;
  for (const double r : radii) area += std::numbers::pi * r * r;
  const double side = std::sqrt(area / covered);
  DisjointCircles circles(radii.size());
  for (const double r : radii) {
    while (!circles.insert({random.uniform(0, side), random.uniform(0, side), r})) {
    }
  }
  return circles;
}

template <class Draw>
std::vector<Circle> placeShuffled(std::size_t count, double covered, Random& random, Draw drawRadius) {
  std::vector<double> radii(count);
  for (double& r : radii) r = drawRadius();
  std::vector<Circle> circles = place(std::move(radii), covered, random).take();
  random.shuffle(circles);
  return circles;
}

/// Circles around the origin whose distances from it grow geometrically from 10^first on, from one to the next by a
/// golden turn.
std::vector<Circle> makeSpiral(std::size_t count, double first, double decades, Random& random) {
  constexpr double kGoldenTurn = 2 - std::numbers::phi;
  // Seen in logarithmic polar coordinates the centers are a lattice with this spacing.
  const double n = static_cast<double>(count);
  const double spacing = std::sqrt(2 * std::numbers::pi * decades * std::numbers::ln10 / n);
  const double start = random.unit();
  std::vector<Circle> circles(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double k = static_cast<double>(i);
    const double distance = powerOfTen(decades * (k / n) + first);
    const Vector direction = directionAt(start + k * kGoldenTurn);
    circles[i] = {distance * direction.x, distance * direction.y,
                  distance * std::min(0.3, random.uniform(0.2, 0.3) * spacing)};
  }
  return circles;
}

}  // namespace

std::vector<Circle> generateUniform(std::size_t count, Random& random) {
  return placeShuffled(count, 0.25, random, [&] { return random.uniform(0.5, 1); });
}

std::vector<Circle> generateLogUniform(std::size_t count, Random& random) {
  return placeShuffled(count, 0.3, random, [&] { return random.logUniform(-3, 0); });
}

std::vector<Circle> generatePoints(std::size_t count, Random& random) {
  const double side = std::sqrt(static_cast<double>(count));
  std::vector<Circle> circles(count);
  for (Circle& c : circles) c = {random.uniform(0, side), random.uniform(0, side), 0};
  return circles;
}

std::vector<Circle> generateMixed(std::size_t count, Random& random) {
  std::size_t index = 0;
  return placeShuffled(count, 0.25, random, [&] { return index++ % 2 == 0 ? random.uniform(0.1, 1) : 0; });
}

std::vector<Circle> generateDense(std::size_t count, Random& random) {
  constexpr double kLargest = 1;
  const double side = std::sqrt(2.0 * static_cast<double>(count));
  DisjointCircles circles(count, kLargest);
  while (circles.size() < count) {
    const Point center = {random.uniform(0, side), random.uniform(0, side)};
    const double r = circles.room(center, kLargest);
    // Without this reduction, rounding would make some circles overlap.
    if (r > 0) circles.insert({center.x, center.y, r * (1 - 0x1p-48)});
  }
  return std::move(circles).take();
}

std::vector<Circle> generateClustered(std::size_t count, Random& random) {
  constexpr std::size_t kMembers = 40;
  const std::size_t clusterCount = count / kMembers + 1;
  const double spread = 0.6 * std::sqrt(static_cast<double>(kMembers));
  const double side = 12 * spread * std::sqrt(static_cast<double>(clusterCount));
  std::vector<Point> centers(clusterCount);
  for (Point& p : centers) p = {random.uniform(0, side), random.uniform(0, side)};

  std::vector<double> radii(count);
  for (double& r : radii) r = random.logUniform(-2, -0.3);
  std::ranges::sort(radii, std::greater<>());
  DisjointCircles circles(count);
  for (const double r : radii) {
    const Point& near = centers[random.below(clusterCount)];
    while (!circles.insert({near.x + spread * random.gaussian(), near.y + spread * random.gaussian(), r})) {
    }
  }
  std::vector<Circle> result = std::move(circles).take();
  random.shuffle(result);
  return result;
}

std::vector<Circle> generateSpiral(std::size_t count, Random& random) { return makeSpiral(count, -4.5, 9, random); }

std::vector<Circle> generateLongSpiral(std::size_t count, Random& random) { return makeSpiral(count, -15, 40, random); }

std::vector<Circle> generateChaosDisjoint(std::size_t count, Random& random) {
  // At this distance all circles fit beside each other even if they have the same size and distance.
  const double nearest = std::sqrt(static_cast<double>(count));
  std::vector<double> radii(count);
  for (double& r : radii) r = random.logUniform(-4, 2);
  std::ranges::sort(radii, std::greater<>());
  DisjointCircles circles(count);
  for (const double r : radii) {
    Vector v;
    do {
      const double distance = r * nearest * random.logUniform(0, 3);
      const Vector direction = random.direction();
      v = {distance * direction.x, distance * direction.y};
    } while (!circles.insert({v.x, v.y, r}));
  }
  std::vector<Circle> result = std::move(circles).take();
  random.shuffle(result);
  return result;
}

std::vector<Circle> generateFarFromOrigin(std::size_t count, Random& random) {
  std::vector<Circle> circles = generateUniform(count, random);
  for (Circle& c : circles) c = {c.x + 1e7, c.y + 1e7, c.r};
  return circles;
}

std::vector<Circle> generateTiny(std::size_t count, Random& random) {
  std::vector<Circle> circles = generateUniform(count, random);
  for (Circle& c : circles) c = {c.x * 1e-9, c.y * 1e-9, c.r * 1e-9};
  return circles;
}

}  // namespace circle_voronoi
