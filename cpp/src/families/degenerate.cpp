// SPDX-License-Identifier: GPL-3.0-or-later
// Centers or circles in special position: on lines, grids and circles.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "generators.h"

namespace circle_voronoi {
namespace {

/// Disjoint circles with centers on the x axis, in random order.
template <class Draw>
std::vector<Circle> makeRow(std::size_t count, Random& random, Draw drawRadius) {
  std::vector<Circle> circles(count);
  double end = 0;
  for (Circle& c : circles) {
    const double r = drawRadius();
    c = {end + r, 0, r};
    end = c.x + r + random.uniform(0.01, 1);
  }
  random.shuffle(circles);
  return circles;
}

/// The first circles of a square grid, row by row; `radiusOf` gives the radius in a column.
template <class RadiusOf>
std::vector<Circle> makeGrid(std::size_t count, double pitch, RadiusOf radiusOf) {
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
  std::vector<Circle> circles(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto column = static_cast<double>(i % columns);
    const auto row = static_cast<double>(i / columns);
    circles[i] = {pitch * column, pitch * row, radiusOf(column)};
  }
  return circles;
}

/// Circles tangent to the circle of radius `reference` around the origin, from outside.
Circle tangentCircle(double reference, double r, Vector direction) {
  return {(reference + r) * direction.x, (reference + r) * direction.y, r};
}

}  // namespace

std::vector<Circle> generateCollinear(std::size_t count, Random& random) {
  return makeRow(count, random, [] { return 0.5; });
}

std::vector<Circle> generateCollinearVaried(std::size_t count, Random& random) {
  return makeRow(count, random, [&] { return random.uniform(0, 1); });
}

std::vector<Circle> generateNearCollinear(std::size_t count, Random& random) {
  std::vector<Circle> circles = generateCollinearVaried(count, random);
  double length = 0;
  for (const Circle& c : circles) length = std::max(length, c.x);
  for (Circle& c : circles) c.y = random.uniform(0, 1e-3 * length);
  return circles;
}

std::vector<Circle> generateGrid(std::size_t count, Random&) {
  return makeGrid(count, 1, [](double) { return 0.25; });
}

std::vector<Circle> generateGridTangent(std::size_t count, Random&) {
  return makeGrid(count, 1, [](double) { return 0.5; });
}

std::vector<Circle> generateGridColumns(std::size_t count, Random&) {
  return makeGrid(count, 3, [](double column) { return 1.0001 + 0.0001 * column; });
}

std::vector<Circle> generateHexagonal(std::size_t count, Random&) {
  const double height = std::sqrt(3.0) / 2;
  std::vector<Circle> circles = makeGrid(count, 1, [](double) { return 0.5; });
  for (Circle& c : circles) {
    const bool isOdd = std::fmod(c.y, 2) == 1;
    c = {isOdd ? c.x + 0.5 : c.x, c.y * height, c.r};
  }
  return circles;
}

std::vector<Circle> generateCocircularVaried(std::size_t count, Random& random) {
  const double n = static_cast<double>(count);
  const double reference = std::max(10.0, n / 2);
  std::vector<Circle> circles(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double turns = (static_cast<double>(i) + random.uniform(0, 0.4)) / n;
    circles[i] = tangentCircle(reference, random.uniform(0.1, 0.9), directionAt(turns));
  }
  random.shuffle(circles);
  return circles;
}

std::vector<Circle> generateCocircularEqual(std::size_t count, Random& random) {
  const double n = static_cast<double>(count);
  const double reference = std::max(1.0, n / 2);
  std::vector<Circle> circles(count);
  for (std::size_t i = 0; i < count; ++i) {
    circles[i] = tangentCircle(reference, 1, directionAt(static_cast<double>(i) / n));
  }
  random.shuffle(circles);
  return circles;
}

}  // namespace circle_voronoi
