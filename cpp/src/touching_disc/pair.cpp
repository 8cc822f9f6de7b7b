// SPDX-License-Identifier: GPL-3.0-or-later
#include "pair.h"

#include <algorithm>
#include <span>
#include <string>

#include "at.h"
#include "delaunay.h"
#include "guarded.h"

namespace circle_voronoi {
namespace {

/// Sorts pairs by a counting sort over the first index, then each run; drops repetitions.
std::vector<Pair> sortedUnique(const std::vector<Pair>& pairs, int circleCount, const ProgressCallback& progress) {
  std::vector<std::size_t> first(at(circleCount) + 1, 0);
  for (const auto& [i, j] : pairs) ++first[at(i + 1)];
  for (int i = 0; i < circleCount; ++i) first[at(i + 1)] += first[at(i)];
  std::vector<int> seconds(pairs.size());
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  forEachIndex(pairs.size(), partOf(progress, 0, 0.5), [&](std::size_t k) {
    const auto [i, j] = pairs[k];
    seconds[next[at(i)]++] = j;
  });

  std::vector<Pair> result;
  forEachIndex(at(circleCount), partOf(progress, 0.5, 1), [&](std::size_t circle) {
    const int i = static_cast<int>(circle);
    const auto begin = seconds.begin() + static_cast<std::ptrdiff_t>(first[at(i)]);
    const auto end = seconds.begin() + static_cast<std::ptrdiff_t>(first[at(i + 1)]);
    std::sort(begin, end);
    std::for_each(begin, std::unique(begin, end), [&](int j) { result.push_back({i, j}); });
  });
  return result;
}

}  // namespace

std::vector<Pair> pairNeighbors(const Samples& samples, int circleCount, const ProgressCallback& progress,
                                const Observer& observer) {
  // Approximate shares of the time.
  constexpr double kTriangulated = 0.91;
  constexpr double kShared = 0.915;
  constexpr double kCounted = 0.92;
  constexpr double kListed = 0.97;
  const DelaunayEdges graph = delaunayEdges(samples.points, partOf(progress, 0, kTriangulated));
  if (observer) {
    for (const auto& [s, t] : graph.edges) {
      observer({TraceKind::samplesJoined, {}, {samples.circles[at(s)], samples.circles[at(t)], kNone}, kNone, {s, t}});
    }
  }

  // Samples of several circles may coincide; each joins its circle to that of its representative and, by the
  // representative's edges, to the neighbors. Listing the circles at every representative ensures that no pair is
  // missed.
  std::vector<std::vector<int>> shared;  // circles at a point that several circles share
  std::vector<int> sharedAt(samples.points.size(), -1);
  forEachIndex(samples.points.size(), partOf(progress, kTriangulated, kShared), [&](std::size_t s) {
    const int point = graph.representative[s];
    const int circle = samples.circles[s];
    if (circle == samples.circles[at(point)]) return;
    if (sharedAt[at(point)] < 0) {
      sharedAt[at(point)] = static_cast<int>(shared.size());
      shared.push_back({samples.circles[at(point)]});
    }
    auto& circles = shared[at(sharedAt[at(point)])];
    if (std::find(circles.begin(), circles.end(), circle) == circles.end()) circles.push_back(circle);
  });
  const auto circlesAt = [&](int point) -> std::span<const int> {
    if (sharedAt[at(point)] < 0) return {&samples.circles[at(point)], 1};
    return shared[at(sharedAt[at(point)])];
  };

  std::size_t count = 0;
  for (const auto& circles : shared) count += circles.size() * (circles.size() - 1) / 2;
  forEachIndex(graph.edges.size(), partOf(progress, kShared, kCounted), [&](std::size_t e) {
    const auto [s, t] = graph.edges[e];
    count += circlesAt(s).size() * circlesAt(t).size();
  });
  if (count > kMaxPairs) {
    throw ThrownError{{ErrorCode::tooManyCircles, -1,
                       std::to_string(circleCount) + " circles would have " + std::to_string(count) +
                           " candidate pairs; at most " + std::to_string(kMaxPairs) + " are possible."}};
  }
  std::vector<Pair> pairs;
  pairs.reserve(count);
  const auto add = [&](int i, int j) {
    if (i != j) pairs.push_back({std::min(i, j), std::max(i, j)});
  };
  for (const auto& circles : shared) {
    for (std::size_t a = 0; a < circles.size(); ++a) {
      for (std::size_t b = a + 1; b < circles.size(); ++b) add(circles[a], circles[b]);
    }
  }
  forEachIndex(graph.edges.size(), partOf(progress, kCounted, kListed), [&](std::size_t e) {
    const auto [s, t] = graph.edges[e];
    for (const int i : circlesAt(s)) {
      for (const int j : circlesAt(t)) add(i, j);
    }
  });
  return sortedUnique(pairs, circleCount, partOf(progress, kListed, 1));
}

std::vector<Pair> pairAll(int circleCount) {
  std::vector<Pair> pairs;
  for (int i = 0; i < circleCount; ++i) {
    for (int j = i + 1; j < circleCount; ++j) pairs.push_back({i, j});
  }
  return pairs;
}

}  // namespace circle_voronoi
