// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <numbers>
#include <random>

#include "region_shapes.h"
#include "report.h"
#include "steps.h"

namespace circle_voronoi::test {
namespace {

constexpr std::size_t kFactor = 4;

std::mt19937_64 randomFor(std::size_t size) { return std::mt19937_64(size); }

std::vector<Circle> randomCircles(std::size_t size, const Box& box, double radius) {
  std::mt19937_64 random = randomFor(size);
  std::uniform_real_distribution<double> x(box.minX, box.maxX);
  std::uniform_real_distribution<double> y(box.minY, box.maxY);
  std::uniform_real_distribution<double> r(0, radius);
  std::vector<Circle> circles(size);
  for (Circle& c : circles) c = {x(random), y(random), r(random)};
  return circles;
}

GrowthInput uniform(std::size_t size) {
  std::mt19937_64 random = randomFor(size);
  const double radius = 0.2 / std::sqrt(static_cast<double>(size));
  return {randomCircles(size, {}, radius), {{coastRing(random, {0.5, 0.5}, 0.3, size)}}};
}

GrowthInput hub(std::size_t size) {
  GrowthInput input = {{{0, 0, 10}}, {{{}}}};
  for (const Point& p : around(12, size)) input.circles.push_back({p.x, p.y, 0});
  Region::Ring& ring = input.polygons[0][0];
  ring = around(1, 2 * size, 0.25);
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const double scale = k % 2 == 0 ? 10.5 : 12.5;
    ring[k] = {scale * ring[k].x, scale * ring[k].y};
  }
  return input;
}

GrowthInput strips(std::size_t size) {
  GrowthInput input;
  const double step = 100 / static_cast<double>(size);
  for (std::size_t k = 0; k < size; ++k) {
    const double x = step * static_cast<double>(k);
    const double width = 0.4 * step;
    // The circle's cell is a band along the strip, so that each strip crosses few cells.
    input.circles.push_back({500 + x / 2, 500 - x / 2, 0});
    input.polygons.push_back({{{x, 0}, {x + width, 0}, {x + width + 1000, 1000}, {x + 1000, 1000}}});
  }
  return input;
}

GrowthInput comb(std::size_t size) {
  // The circles lie in a row, so that each tooth crosses few cells.
  const double length = static_cast<double>(size);
  return {randomCircles(size, {0, 0, length, 1}, 0.1), {{combRing({0, 0, length, 10}, size / 4)}}};
}

GrowthInput spiral(std::size_t size) {
  // Corners are as far apart as turns, and a circle lies between each two corners across the corridor.
  GrowthInput input = {{}, {{{}}}};
  Region::Ring inner;
  Region::Ring& ring = input.polygons[0][0];
  double angle = std::numbers::pi;
  for (std::size_t k = 0; k < size; ++k) {
    const auto at = [&](double r) { return Point{r * std::cos(angle), r * std::sin(angle)}; };
    inner.push_back(at(angle));
    ring.push_back(at(angle + 3));
    const Point middle = at(angle + 1.5);
    input.circles.push_back({middle.x, middle.y, 0});
    angle += 2 * std::numbers::pi / angle;
  }
  ring.insert(ring.end(), inner.rbegin(), inner.rend());
  return input;
}

GrowthInput holes(std::size_t size) {
  GrowthInput input = {{{0, 0, 1}}, {{around(100, size)}}};
  const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(size))));
  const double step = 100 / static_cast<double>(side);
  for (std::size_t k = 0; k < size; ++k) {
    const double x = (static_cast<double>(k % side) + 0.5) * step - 50;
    const double y = (static_cast<double>(k / side) + 0.5) * step - 50;
    const double d = step / 5;
    input.polygons[0].push_back({{x - d, y - d}, {x - d, y + d}, {x + d, y + d}, {x + d, y - d}});
  }
  return input;
}

}  // namespace

std::vector<Point> around(double radius, std::size_t count, double turn) {
  std::vector<Point> points(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double angle = 2 * std::numbers::pi * (static_cast<double>(k) + turn) / static_cast<double>(count);
    points[k] = {radius * std::cos(angle), radius * std::sin(angle)};
  }
  return points;
}

Region GrowthInput::region() const { return Region::fromPolygons(polygons).value(); }

const GrowthFamily kUniform = {"uniform", uniform};
const GrowthFamily kHub = {"hub", hub};
const GrowthFamily kStrips = {"strips", strips};
const GrowthFamily kComb = {"comb", comb};
const GrowthFamily kSpiral = {"spiral", spiral};
const GrowthFamily kHoles = {"holes", holes};

std::span<const GrowthFamily> growthFamilies() {
  static const std::array<GrowthFamily, 6> kAll = {kUniform, kHub, kStrips, kComb, kSpiral, kHoles};
  return kAll;
}

std::span<const GrowthFamily> circleFamilies() { return growthFamilies().first(5); }

std::ostream& operator<<(std::ostream& out, const Promise& promise) {
  return out << promise.function << " (" << promise.header << ')';
}

void expectGrowth(const Promise& promise) {
  for (const GrowthFamily& family : promise.families) {
    expectGrowth(
        family.name, promise.size,
        [&](std::size_t size) { return static_cast<double>(stepsOf(promise.prepare(family.make(size)))); },
        promise.mostGrowth);
  }
}

void expectGrowth(std::string_view input, std::size_t size, const std::function<double(std::size_t size)>& stepsAt,
                  double mostGrowth) {
  SCOPED_TRACE(input);
  const double few = stepsAt(size);
  const double many = stepsAt(kFactor * size);
  // A few steps more are no growth of next to nothing.
  const auto unit = static_cast<double>(size);
  const double growth = many / std::max(few, unit);
  std::cout << std::fixed << std::setprecision(1) << std::setw(24) << input << std::setw(12) << few / unit
            << std::setw(8) << growth << std::endl;
  EXPECT_LE(growth, mostGrowth);
}

}  // namespace circle_voronoi::test
