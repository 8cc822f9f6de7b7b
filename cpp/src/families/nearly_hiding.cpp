// SPDX-License-Identifier: GPL-3.0-or-later
// Circles that nearly hide one another, or are nested: most of their signs are ties or nearly so.
#include <algorithm>
#include <cmath>

#include "generators.h"

namespace circle_voronoi {
namespace {

Circle circleAt(double distance, Vector direction, double r) {
  return {distance * direction.x, distance * direction.y, r};
}

/// Makes one circle in each of `count` well separated directions, in random order.
template <class Make>
std::vector<Circle> allAround(std::size_t count, Random& random, Make make) {
  const double n = static_cast<double>(count);
  std::vector<Circle> circles(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double turns = (static_cast<double>(i) + random.uniform(0, 0.4)) / n;
    circles[i] = make(directionAt(turns));
  }
  random.shuffle(circles);
  return circles;
}

}  // namespace

std::vector<Circle> generateTangentInside(std::size_t count, Random& random) {
  return allAround(count, random, [&](Vector direction) {
    const double distance = random.uniform(0.1, 0.9);
    return circleAt(distance, direction, 1 - distance);
  });
}

std::vector<Circle> generateTangentOutside(std::size_t count, Random& random) {
  return allAround(count, random, [&](Vector direction) {
    const double r = random.logUniform(-3, 3);
    return circleAt(1 + r, direction, r);
  });
}

std::vector<Circle> generateTangentLine(std::size_t count, Random& random) {
  std::vector<Circle> circles(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = static_cast<double>(i) + random.uniform(0, 0.4);
    const double r = random.logUniform(-1, 2);
    circles[i] = {x, r, r};
  }
  random.shuffle(circles);
  return circles;
}

std::vector<Circle> generateCommonPoint(std::size_t count, Random& random) {
  return allAround(count, random, [&](Vector direction) {
    const double distance = random.logUniform(-1, 1);
    return circleAt(distance, direction, distance);
  });
}

std::vector<Circle> generateNearNested(std::size_t count, Random& random) {
  const double n = static_cast<double>(count);
  std::vector<Circle> circles(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double distance = 0.9 * (static_cast<double>(i) + random.uniform(0, 0.4)) / n;
    circles[i] = {(1 + 1e-6) * distance, 0, 1 - distance};
  }
  random.shuffle(circles);
  return circles;
}

std::vector<Circle> generateNestedTangent(std::size_t count, Random& random) {
  const Vector direction = random.direction();
  std::vector<Circle> circles(count);
  for (Circle& c : circles) {
    const double distance = random.unit();
    c = circleAt(distance, direction, 1 - distance);
  }
  return circles;
}

std::vector<Circle> generateConcentric(std::size_t count, Random& random) {
  const Vector direction = random.direction();
  std::vector<Circle> circles(count);
  for (Circle& c : circles) c = circleAt(1, direction, random.unit());
  return circles;
}

std::vector<Circle> generateCocircularLarge(std::size_t count, Random& random) {
  // They differ by less than their distances, so that none hides another.
  const double difference = 1 / static_cast<double>(std::max<std::size_t>(count, 1));
  return allAround(count, random, [&](Vector direction) {
    const double r = random.uniform(10, 10 + difference);
    return circleAt(1, direction, r);
  });
}

std::vector<Circle> generateOnRim(std::size_t count, Random& random) {
  if (count == 0) return {};
  std::vector<Circle> circles = {{0, 0, 1}};
  const double largest = 2 / static_cast<double>(count);
  while (circles.size() < count) {
    const Vector direction = random.direction();
    circles.push_back(circleAt(1, direction, random.uniform(0, largest)));
  }
  random.shuffle(circles);
  return circles;
}

std::vector<Circle> generateWedge(std::size_t count, Random& random) {
  std::vector<Circle> circles(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double k = static_cast<double>(i + 1);
    circles[i] = {k, 0.001 * k, 0.499 * k};
  }
  random.shuffle(circles);
  return circles;
}

std::vector<Circle> generateTwoCommonPoints(std::size_t count, Random& random) {
  std::vector<Circle> circles(count);
  for (Circle& c : circles) {
    // Through (0, -1) and (0, 1).
    const double x = random.uniform(-10, 10);
    c = {x, 0, std::sqrt(x * x + 1)};
  }
  return circles;
}

std::vector<Circle> generateBarelyOut(std::size_t count, Random& random) {
  if (count == 0) return {};
  std::vector<Circle> circles = allAround(count - 1, random, [&](Vector direction) {
    const double distance = random.uniform(0.1, 0.9);
    return circleAt(distance * (1 + 1e-15), direction, 1 - distance);
  });
  circles.push_back({0, 0, 1});
  random.shuffle(circles);
  return circles;
}

}  // namespace circle_voronoi
