// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "at.h"
#include "guarded.h"
#include "rounded.h"

namespace circle_voronoi {
namespace {

Vector unit(Vector v) {
  const double size = length(v);
  return {v.x / size, v.y / size};
}

/// The unit vector that divides the counter-clockwise angle (at most pi) from unit vector `from` to `to` in the
/// proportion part : whole, by repeated halving; sums and square roots only, so it is the same on every platform.
Vector divideAngle(Vector from, Vector to, int part, int whole) {
  constexpr int kHalvings = 53;
  constexpr double kStraight = 1e-20;  // the square of the sum of two unit vectors that are opposite but for rounding
  for (int i = 0; i < kHalvings && part != 0; ++i) {
    const Vector sum = {from.x + to.x, from.y + to.y};
    // The sum vanishes for a straight angle, whose bisector is the perpendicular.
    const Vector middle = dot(sum, sum) > kStraight ? unit(sum) : Vector{-from.y, from.x};
    if (2 * part < whole) {
      part = 2 * part;
      to = middle;
    } else {
      part = 2 * part - whole;
      from = middle;
    }
  }
  return from;
}

double smallestRadius(std::span<const Circle> circles) {
  double smallest = circles.empty() ? 0 : circles[0].r;
  for (const Circle& c : circles) smallest = std::min(smallest, c.r);
  return smallest;
}

/// Appends the point of circle i, less the smallest radius, in a direction given by a unit vector.
class Sampler {
 public:
  /// `count` is the number of samples to come.
  Sampler(std::span<const Circle> circles, std::int64_t count, const ProgressCallback& progress)
      : circles_(circles), smallest_(smallestRadius(circles)), count_(count), progress_(progress) {
    if (count > kMaxSamplePoints) {
      throw ThrownError{{ErrorCode::tooManyCircles, -1,
                         std::to_string(circles.size()) + " circles would have " + std::to_string(count) +
                             " samples; at most " + std::to_string(kMaxSamplePoints) + " are possible."}};
    }
    samples_.points.reserve(static_cast<std::size_t>(count));
    samples_.circles.reserve(static_cast<std::size_t>(count));
  }

  void add(int i, Vector direction) {
    constexpr std::size_t kSamplesPerReport = 1 << 16;
    const Circle& c = circles_[at(i)];
    const double r = c.r - smallest_;
    // The exact predicates take rounded points only.
    samples_.points.push_back(rounded(Point{c.x + r * direction.x, c.y + r * direction.y}));
    samples_.circles.push_back(i);
    if (progress_ && samples_.circles.size() % kSamplesPerReport == 0) {
      progress_(static_cast<double>(samples_.circles.size()) / static_cast<double>(count_));
    }
  }

  Samples take() && { return std::move(samples_); }

 private:
  std::span<const Circle> circles_;
  double smallest_;
  std::int64_t count_;
  const ProgressCallback& progress_;
  Samples samples_;
};

/// Returns how many samples sampleDynamically takes.
std::int64_t countDynamically(const Dual& centers, std::span<const int> angular) {
  std::int64_t count = 0;
  for (int h = 0; h < centers.halfEdgeCount(); ++h) {
    const int i = centers.origin[at(h)];
    if (i == kPointAtInfinity || centers.target(h) == kPointAtInfinity) continue;
    count += centers.isFinite(h / 3) ? 1 + angular[at(i)] : 1;
  }
  return count;
}

}  // namespace

Samples sampleDynamically(std::span<const Circle> circles, const Dual& centers, std::span<const int> angular,
                          const ProgressCallback& progress) {
  Sampler sampler(circles, countDynamically(centers, angular), progress);
  for (int h = 0; h < centers.halfEdgeCount(); ++h) {
    const int i = centers.origin[at(h)];
    const int j = centers.target(h);
    if (i == kPointAtInfinity || j == kPointAtInfinity) continue;
    const Vector along = unit(between(circles[at(i)], circles[at(j)]));
    sampler.add(i, along);
    if (!centers.isFinite(h / 3)) continue;
    const int k = centers.origin[at(Dual::previous(h))];
    const Vector across = unit(between(circles[at(i)], circles[at(k)]));
    for (int part = 1; part <= angular[at(i)]; ++part)
      sampler.add(i, divideAngle(along, across, part, angular[at(i)] + 1));
  }
  return std::move(sampler).take();
}

Samples sampleUniformly(std::span<const Circle> circles, int count, const ProgressCallback& progress) {
  constexpr Vector kQuadrants[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}};
  std::vector<Vector> directions;
  for (int k = 0; k < count; ++k) {
    const int quadrant = 4 * k / count;
    directions.push_back(divideAngle(kQuadrants[quadrant], kQuadrants[quadrant + 1], 4 * k - quadrant * count, count));
  }
  Sampler sampler(circles, static_cast<std::int64_t>(circles.size()) * count, progress);
  for (int i = 0; i < static_cast<int>(circles.size()); ++i) {
    for (const Vector direction : directions) sampler.add(i, direction);
  }
  return std::move(sampler).take();
}

}  // namespace circle_voronoi
