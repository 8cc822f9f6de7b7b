// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/compute.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <string>

#include "delaunay.h"
#include "hide.h"
#include "pair.h"
#include "sample.h"
#include "three_touch_disc.h"
#include "touch.h"
#include "validate.h"

namespace circle_voronoi {
namespace {

/// Adds the time from its making to its end to a number of seconds.
class Stopwatch {
 public:
  explicit Stopwatch(double& seconds) : seconds_(seconds) {}
  ~Stopwatch() { seconds_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  double& seconds_;
  Clock::time_point start_ = Clock::now();
};

std::vector<Point> centresOf(std::span<const Circle> circles) {
  std::vector<Point> centres;
  centres.reserve(circles.size());
  for (const Circle& c : circles) centres.push_back({c.x, c.y});
  return centres;
}

int sampleCount(const Options& options) {
  if (options.samples != -1) return options.samples;
  return options.candidates == Candidates::uniform ? kDefaultUniformSamples : kDefaultDynamicSamples;
}

const char* nameOf(Candidates candidates) {
  switch (candidates) {
    case Candidates::dynamic:
      return "dynamic";
    case Candidates::uniform:
      return "uniform";
    case Candidates::allPairs:
      return "all-pairs";
  }
  return "";
}

/// An error if an option is out of its range for this many circles.
std::optional<Error> checkOptions(const Options& options, std::size_t circleCount) {
  if (options.candidates == Candidates::allPairs) {
    if (circleCount <= kMaxAllPairsCircles) return std::nullopt;
    return Error{ErrorCode::tooManyCircles, -1,
                 "All pairs of " + std::to_string(circleCount) + " circles are too many; the limit is " +
                     std::to_string(kMaxAllPairsCircles) + " circles."};
  }
  const int fewest = options.candidates == Candidates::uniform ? 1 : 0;
  const int samples = sampleCount(options);
  if (samples >= fewest && samples <= kMaxSamples) return std::nullopt;
  return Error{ErrorCode::badOption, -1,
               "The number of samples is " + std::to_string(samples) + "; with " + nameOf(options.candidates) +
                   " candidates it is from " + std::to_string(fewest) + " to " + std::to_string(kMaxSamples) + "."};
}

/// Translates the events of visible, scaled circles to those of the input.
Observer observerOfInput(const Observer& observer, const std::vector<int>& visible, double unit) {
  if (!observer) return {};
  return [&observer, &visible, unit](TraceEvent event) {
    event.disc = {event.disc.x * unit, event.disc.y * unit, event.disc.radius * unit};
    for (std::int32_t& circle : event.circles) {
      if (circle != kNone) circle = visible[circle];
    }
    observer(event);
  };
}

/// The disc of a vertex, the same bits for any rotation of its three circles: the smallest index goes first.
Vertex place(std::span<const Circle> circles, std::array<std::int32_t, 3>& triple) {
  std::rotate(triple.begin(), std::min_element(triple.begin(), triple.end()), triple.end());
  const auto& [i, j, k] = triple;
  const auto disc = threeTouchDisc(circles[i], circles[j], circles[k]);
  return disc ? disc->disc : Vertex{};
}

Diagram computeValid(const ScaledCircles& scaled, const Options& options) {
  const std::vector<Circle>& circles = scaled.circles;
  Diagram diagram;
  Counts& counts = diagram.stats.counts;
  Seconds& seconds = diagram.stats.seconds;
  diagram.stats.method = "touching-disc";
  diagram.stats.candidates = nameOf(options.candidates);
  counts.circles = static_cast<std::int64_t>(circles.size());

  // hide
  Delaunay centres;
  Visibility visibility;
  std::vector<Circle> sites;
  {
    const Stopwatch watch(seconds.hide);
    centres = delaunay(centresOf(circles));
    visibility = hide(circles, centres);
    for (const int i : visibility.visible) sites.push_back(circles[i]);
    if (sites.size() != circles.size()) centres = delaunay(centresOf(sites));
  }
  const std::vector<int>& visible = visibility.visible;
  const int siteCount = static_cast<int>(sites.size());

  // sample
  Samples samples;
  if (options.candidates != Candidates::allPairs) {
    const Stopwatch watch(seconds.sample);
    samples = options.candidates == Candidates::dynamic ? sampleDynamically(sites, centres.dual, sampleCount(options))
                                                        : sampleUniformly(sites, sampleCount(options));
  }

  // pair
  std::vector<Pair> pairs;
  {
    const Stopwatch watch(seconds.pair);
    pairs = options.candidates == Candidates::allPairs ? pairAll(siteCount) : pairNeighbors(samples, siteCount);
  }

  // touch
  TouchResult touched;
  {
    const Stopwatch watch(seconds.touch);
    touched = touch(sites, pairs, observerOfInput(options.observer, visible, scaled.unit));
  }

  diagram.vertexCircles = std::move(touched.topology.vertexCircles);
  diagram.edges = std::move(touched.topology.edges);
  diagram.hull = std::move(touched.topology.hull);
  diagram.vertices.reserve(diagram.vertexCircles.size());
  for (auto& triple : diagram.vertexCircles) {
    const Vertex vertex = place(sites, triple);
    diagram.vertices.push_back({vertex.x * scaled.unit, vertex.y * scaled.unit, vertex.radius * scaled.unit});
    for (std::int32_t& circle : triple) circle = visible[circle];
  }
  for (Edge& edge : diagram.edges) {
    edge.left = visible[edge.left];
    edge.right = visible[edge.right];
  }
  for (std::int32_t& circle : diagram.hull) circle = visible[circle];

  counts.hidden = static_cast<std::int64_t>(visibility.hidden.size());
  counts.samples = static_cast<std::int64_t>(samples.points.size());
  counts.antipodalDiscs = static_cast<std::int64_t>(pairs.size());
  counts.threeTouchDiscs = touched.threeTouchDiscs;
  counts.events = touched.events;
  counts.leftoverCycles = touched.leftoverCycles;
  diagram.hidden = std::move(visibility.hidden);
  return diagram;
}

}  // namespace

Result<Diagram> compute(std::span<const Circle> circles, const Options& options) {
  if (auto error = checkOptions(options, circles.size())) return *std::move(error);
  try {
    auto scaled = validate(circles);
    if (!scaled) return scaled.error();
    double total = 0;
    Diagram diagram;
    {
      const Stopwatch watch(total);
      diagram = computeValid(scaled.value(), options);
    }
    diagram.stats.seconds.total = total;
    return diagram;
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::tooManyCircles, -1, std::to_string(circles.size()) + " circles do not fit in memory."};
  }
}

}  // namespace circle_voronoi
