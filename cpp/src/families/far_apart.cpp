// SPDX-License-Identifier: GPL-3.0-or-later
// Circles whose distances differ by many orders of magnitude: what one spatial order does not part.
#include <algorithm>

#include "generators.h"
#include "rounded.h"

namespace circle_voronoi {
namespace {

/// Adds uniform circles around a place far from the origin. Radii are reduced by the rounding of the coordinates there,
/// so that the circles stay disjoint.
void addCluster(std::vector<Circle>& circles, std::size_t count, Point place, Random& random) {
  const double rounding = 0x1p-51 * std::max(place.x, place.y);
  for (const Circle& c : generateUniform(count, random)) {
    circles.push_back({place.x + c.x, place.y + c.y, c.r - rounding});
  }
}

/// Uniform circles and one point on the x axis, in random order.
std::vector<Circle> withPointAt(double x, std::size_t count, Random& random) {
  if (count == 0) return {};
  std::vector<Circle> circles = generateUniform(count - 1, random);
  circles.push_back({x, 0, 0});
  random.shuffle(circles);
  return circles;
}

/// Circles with centers on the x axis whose radii grow from 10^-28 to the limit of numbers, in random order.
/// `gapBefore(i, r)` is how far circle i, of radius r, stays away from the circle before it.
template <class Gap>
std::vector<Circle> makeGrowingRow(std::size_t count, Random& random, Gap gapBefore) {
  constexpr double kFirstDecade = -28;
  // The more circles have about the same size, the smaller is the last, so that the row ends within the limit.
  double decades = 56;
  for (std::size_t rest = count; rest > 100; rest /= 10) --decades;
  std::vector<Circle> circles(count);
  double end = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double r =
        rounded(powerOfTen(kFirstDecade + decades * (static_cast<double>(i + 1) / static_cast<double>(count))));
    circles[i] = {end + rounded(gapBefore(i, r)) + r, 0, r};
    end = circles[i].x + r;
  }
  random.shuffle(circles);
  return circles;
}

}  // namespace

std::vector<Circle> generateTwoClusters(std::size_t count, Random& random) {
  std::vector<Circle> circles;
  addCluster(circles, count - count / 2, {0, 0}, random);
  addCluster(circles, count / 2, {1e12, 0}, random);
  random.shuffle(circles);
  return circles;
}

std::vector<Circle> generateFarClusters(std::size_t count, Random& random) {
  constexpr std::size_t kClusters = 20;
  constexpr std::size_t kColumns = 5;
  constexpr double kPitch = 1e6;
  std::vector<Circle> circles;
  for (std::size_t i = 0; i < kClusters; ++i) {
    const double column = static_cast<double>(i % kColumns) + random.uniform(0, 0.4);
    const double row = static_cast<double>(i / kColumns) + random.uniform(0, 0.4);
    const std::size_t members = (count + i) / kClusters;
    addCluster(circles, members, {kPitch * column, kPitch * row}, random);
  }
  random.shuffle(circles);
  return circles;
}

std::vector<Circle> generateOutlier(std::size_t count, Random& random) { return withPointAt(1e9, count, random); }

std::vector<Circle> generateLineAndHuge(std::size_t count, Random& random) {
  if (count == 0) return {};
  std::vector<Circle> circles = generateCollinearVaried(count - 1, random);
  double length = 1;
  for (const Circle& c : circles) length = std::max(length, c.x);
  const double distance = 1e6 * length;
  circles.push_back({random.unit() * length, distance, random.uniform(0.2, 0.8) * distance});
  random.shuffle(circles);
  return circles;
}

std::vector<Circle> generateFarOutlier(std::size_t count, Random& random) { return withPointAt(1e28, count, random); }

std::vector<Circle> generateGrowingLine(std::size_t count, Random& random) {
  return makeGrowingRow(count, random, [&](std::size_t i, double r) { return i % 2 == 0 ? random.unit() * r : 0; });
}

std::vector<Circle> generateTangentChain(std::size_t count, Random& random) {
  return makeGrowingRow(count, random, [](std::size_t, double) { return 0.0; });
}

}  // namespace circle_voronoi
