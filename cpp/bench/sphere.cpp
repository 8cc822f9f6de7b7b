// SPDX-License-Identifier: GPL-3.0-or-later
#include "sphere.h"

#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

#include "circle_voronoi/compute.h"
#include "circle_voronoi/sphere.h"
#include "circle_voronoi_families/families.h"
#include "median.h"
#include "processor_seconds.h"

namespace circle_voronoi::bench {
namespace {

/// Caps of the unit sphere with the radii of the family uniform: 0.5 to 1 times one that lets them cover a quarter.
std::vector<Cap> uniformCaps(std::size_t count) {
  std::mt19937_64 random(1);
  const auto uniform = [&](double from, double to) { return from + (to - from) * (random() >> 11) * 0x1p-53; };
  const double radius = std::sqrt(12 / (7 * static_cast<double>(count)));
  std::vector<Cap> caps(count);
  for (Cap& cap : caps) {
    cap = {uniform(-180, 180), std::asin(uniform(-1, 1)) * 180 / std::numbers::pi, uniform(radius / 2, radius)};
  }
  return caps;
}

}  // namespace

void benchSphere(const std::vector<std::size_t>& sizes, int repetitions) {
  std::printf("%8s %10s %10s %8s\n", "n", "compute", "sphere", "ratio");
  for (const std::size_t size : sizes) {
    const std::vector<Circle> circles = generate(Family::uniform, size, 1);
    const std::vector<Cap> caps = uniformCaps(size);
    std::vector<double> plane;
    std::vector<double> sphere;
    std::vector<double> ratios;
    for (int i = 0; i < repetitions; ++i) {
      plane.push_back(processorSeconds([&] { (void)compute(circles).value(); }));
      sphere.push_back(processorSeconds([&] { (void)computeSphere(caps, {.radius = 1}).value(); }));
      ratios.push_back(sphere.back() / plane.back());
    }
    std::printf("%8zu %10.4f %10.4f %8.2f\n", size, median(plane), median(sphere), median(ratios));
    std::fflush(stdout);
  }
}

}  // namespace circle_voronoi::bench
