// SPDX-License-Identifier: GPL-3.0-or-later
// Circles that intersect or hide one another.
#include <cmath>

#include "generators.h"

namespace circle_voronoi {
namespace {

/// Circles at random places in a square with `density` centers a unit of area.
template <class Draw>
std::vector<Circle> scatter(std::size_t count, double density, Random& random, Draw drawRadius) {
  const double side = std::sqrt(static_cast<double>(count) / density);
  std::vector<Circle> circles(count);
  for (Circle& c : circles) {
    c.x = random.uniform(0, side);
    c.y = random.uniform(0, side);
    c.r = drawRadius();
  }
  return circles;
}

}  // namespace

std::vector<Circle> generateLightlyIntersecting(std::size_t count, Random& random) {
  return scatter(count, 1, random, [&] { return random.uniform(0.1, 0.3); });
}

std::vector<Circle> generateIntersecting(std::size_t count, Random& random) {
  return scatter(count, 1, random, [&] { return random.uniform(0.3, 0.8); });
}

std::vector<Circle> generateHidden(std::size_t count, Random& random) {
  return scatter(count, 1, random, [&] { return random.logUniform(-3, 0.2); });
}

std::vector<Circle> generateDuplicates(std::size_t count, Random& random) {
  std::vector<Circle> circles = scatter(count, 0.25, random, [&] { return random.uniform(0.3, 0.9); });
  const std::size_t originals = count - count / 4;
  for (std::size_t i = originals; i < count; ++i) {
    circles[i] = circles[random.below(originals)];
    if (i % 2 == 0) circles[i].r /= 2;
  }
  random.shuffle(circles);
  return circles;
}

std::vector<Circle> generateChaos(std::size_t count, Random& random) {
  std::vector<Circle> circles(count);
  for (Circle& c : circles) {
    const double distance = random.logUniform(-4.5, 4.5);
    const Vector direction = random.direction();
    c = {distance * direction.x, distance * direction.y, 0};
    if (random.below(10) != 0) c.r = distance * random.logUniform(-3, 0);
  }
  return circles;
}

}  // namespace circle_voronoi
