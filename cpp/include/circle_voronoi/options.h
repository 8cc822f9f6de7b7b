// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/limits.h"
#include "circle_voronoi/method.h"
#include "circle_voronoi/metric.h"
#include "circle_voronoi/progress.h"
#include "circle_voronoi/trace.h"

namespace circle_voronoi {

inline constexpr int kDefaultDynamicSamples = 1;
inline constexpr int kDefaultUniformSamples = 50;

struct Options {
  /// The distance that defines the cells.
  Metric metric = Metric::circles;
  /// Whether the third number of a circle is its weight, which may be negative, instead of its radius: a point's
  /// distance from it is |p - c| - w, or |p - c|^2 - w for Metric::power.
  bool weights = false;
  Method method = Method::automatic;
  /// The number of threads that may work at the same time; 0 means one for each hardware thread. The result has the
  /// same bits for any number. WebAssembly uses one thread.
  int threads = 1;
  /// Used by the touching disc method only, like `samples` and `resample`.
  Candidates candidates = Candidates::dynamic;
  /// For dynamic candidates N_s, the number of samples inside each angle of a Delaunay face, 0 to kMaxSamples.
  /// For uniform candidates m, the number of samples on each circle, 1 to kMaxSamples.
  /// By default kDefaultDynamicSamples or kDefaultUniformSamples. Not used for allPairs.
  std::optional<int> samples = {};
  /// For dynamic candidates: if the diagram is not certified, take more samples around the flaw and try again.
  bool resample = false;
  /// Called for each event (trace.h). An empty observer costs nothing.
  Observer observer = {};
  /// Called as the computation proceeds. An empty one costs nothing.
  Progress progress = {};
};

}  // namespace circle_voronoi
