// SPDX-License-Identifier: GPL-3.0-or-later
#include "method.h"

#include <stdexcept>

#include "centers.h"
#include "delaunay.h"

namespace circle_voronoi::results {

Diagram diagramOf(std::span<const Circle> circles, const Options& options) {
  auto diagram = compute(circles, options);
  if (!diagram) throw std::runtime_error(diagram.error().message);
  return std::move(diagram).value();
}

Samples dynamicSamples(std::span<const Circle> circles, int angular) {
  return sampleDynamically(circles, delaunay(centersOf(circles)).dual, std::vector<int>(circles.size(), angular));
}

namespace {

/// Returns the circles and a point, which becomes the smallest circle.
std::vector<Circle> withPoint(std::span<const Circle> circles) {
  std::vector<Circle> more(circles.begin(), circles.end());
  more.push_back({0, 0, 0});
  return more;
}

}  // namespace

Samples drawnDynamicSamples(std::span<const Circle> circles, int angular) {
  return sampleDynamically(withPoint(circles), delaunay(centersOf(circles)).dual,
                           std::vector<int>(circles.size() + 1, angular));
}

Samples drawnUniformSamples(std::span<const Circle> circles, int count) {
  Samples samples = sampleUniformly(withPoint(circles), count);
  samples.points.resize(circles.size() * count);
  samples.circles.resize(circles.size() * count);
  return samples;
}

std::vector<Pair> dynamicPairs(std::span<const Circle> circles, int angular) {
  return pairNeighbors(dynamicSamples(circles, angular), static_cast<int>(circles.size()));
}

}  // namespace circle_voronoi::results
