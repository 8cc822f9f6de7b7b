// SPDX-License-Identifier: GPL-3.0-or-later
#include "carlson.h"

#include <algorithm>
#include <cmath>

namespace circle_voronoi {

Carlson carlson(double rootX, double rootY, double rootZ) {
  // The series leave out sixth powers. From ratios of 2^1000 it takes some fifteen steps.
  constexpr double kNear = 1e-3;
  constexpr int kMostSteps = 50;
  double x = rootX * rootX;
  double y = rootY * rootY;
  double z = rootZ * rootZ;
  double sum = 0;
  double power = 1;
  for (int step = 0; step < kMostSteps; ++step) {
    const double mean = (x + y + z) / 3;
    if (std::max({std::abs(mean - x), std::abs(mean - y), std::abs(mean - z)}) <= kNear * mean) break;
    const double lambda = rootX * rootY + rootZ * (rootX + rootY);
    sum += power / (rootZ * (z + lambda));
    power /= 4;
    x = (x + lambda) / 4;
    y = (y + lambda) / 4;
    z = (z + lambda) / 4;
    rootX = std::sqrt(x);
    rootY = std::sqrt(y);
    rootZ = std::sqrt(z);
  }
  const double mean = (x + y + z) / 3;
  const double u = 1 - x / mean;
  const double v = 1 - y / mean;
  const double e2 = u * v - (u + v) * (u + v);
  const double e3 = -u * v * (u + v);
  const double first = 1 - e2 / 10 + e3 / 14 + e2 * e2 / 24 - 3 * e2 * e3 / 44;

  const double weighted = (x + y + 3 * z) / 5;
  const double p = 1 - x / weighted;
  const double q = 1 - y / weighted;
  const double r = -(p + q) / 3;
  const double d2 = p * q - 6 * r * r;
  const double d3 = (3 * p * q - 8 * r * r) * r;
  const double d4 = 3 * (p * q - r * r) * r * r;
  const double d5 = p * q * r * r * r;
  const double second = 1 - 3 * d2 / 14 + d3 / 6 + 9 * d2 * d2 / 88 - 3 * d4 / 22 - 9 * d2 * d3 / 52 + 3 * d5 / 26;
  return {first / std::sqrt(mean), power * second / (weighted * std::sqrt(weighted)) + 3 * sum};
}

}  // namespace circle_voronoi
