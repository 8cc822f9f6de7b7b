// SPDX-License-Identifier: GPL-3.0-or-later
#include "variants.h"

#include <algorithm>
#include <array>

#include "circle_voronoi/limits.h"

namespace circle_voronoi {
namespace {

using Circles = std::vector<Circle>;

/// The ratio of 1e9, a common sentinel, to the side of 60,000 circles at density 1.
constexpr double kFar = 4e6;

double extentOf(const Circles& circles) {
  if (circles.empty()) return 0;
  double low = circles[0].x;
  double high = low;
  for (const Circle& c : circles) {
    low = std::min({low, c.x - c.r, c.y - c.r});
    high = std::max({high, c.x + c.r, c.y + c.r});
  }
  return high - low;
}

Circles withOutlier(Family family, std::size_t count, std::uint64_t seed) {
  Circles circles = generate(family, count, seed);
  if (count > 0) circles[count / 2] = {std::min(kFar * extentOf(circles), kCoordinateLimit), 0, 0};
  return circles;
}

Circles withDuplicates(Family family, std::size_t count, std::uint64_t seed) {
  Circles circles = generate(family, count, seed);
  for (std::size_t i = 0; i < count; i += 4) circles[i] = circles[(i * 7 + 1) % count];
  return circles;
}

Circles inTwoClusters(Family family, std::size_t count, std::uint64_t seed) {
  Circles circles = generate(family, count / 2, seed);
  const double distance = std::min(1000 * kFar * extentOf(circles), kCoordinateLimit / 4);
  for (const Circle& c : generate(family, count - count / 2, seed + 1)) {
    circles.push_back({c.x + distance, c.y, c.r});
  }
  return circles;
}

constexpr std::array<Variant, 4> kVariants = {{
    {"", generate},
    {" + outlier", withOutlier},
    {" + duplicates", withDuplicates},
    {" in two clusters", inTwoClusters},
}};

}  // namespace

std::span<const Variant> variants() { return kVariants; }

}  // namespace circle_voronoi
