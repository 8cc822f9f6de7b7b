// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/limits.h"
#include "circle_voronoi/method.h"
#include "circle_voronoi/progress.h"
#include "circle_voronoi/trace.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

inline constexpr int kDefaultDynamicSamples = 1;
inline constexpr int kDefaultUniformSamples = 50;

struct Options {
  /// Whether the radii are additive weights, which may be negative.
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
  Observer observer;
  /// Called as the computation proceeds. An empty one costs nothing.
  Progress progress;
};

/// Computes the Voronoi diagram of `circles`.
///
/// The circles may be disjoint, intersecting, tangent, nested, equal, or points, in any position. There may be none.
/// The same input gives the same bits on every platform.
///
/// Where more than three circles touch one disc, the way their face is divided depends only on the positions of their
/// centers. It depends neither on the order of the circles nor on the method.
///
/// The input is first scaled by a power of two. That is exact unless one number is smaller than the largest by a factor
/// of 2^1100 (1e331). Such a number is rounded to the nearest multiple of 2^-1154 of the largest, and the diagram is
/// that of the rounded circles.
///
/// A point belongs to the circle with the smallest distance minus radius, so only the differences of the radii matter.
/// With `weights` they may be negative. If you add the same number to all radii, the topology and the coordinates of
/// the vertices keep their bits, and the radii of the vertices decrease by that number. This requires that neither the
/// sums nor the scaling round. The order of vertices and edges may change.
///
/// With `automatic` the result is certified, or there is an error. With the other methods the diagram comes with its
/// certificate and may be wrong where the certificate says so.
///
/// Vertices are at their exact places to 36 bits of their distances from their circles (certify.h says why it asks for
/// 40). If a vertex lies beyond the largest double (1.8e308), there is an error. This takes three circles nearly along
/// a line, whose sizes and distances differ by more than a factor of 1e150.
///
/// Errors: nonFinite, negativeRadius (without `weights`), coordinateTooLarge (these three name the first such circle),
/// badOption, tooManyCircles, notCertified, badArithmetic, internal.
Result<Diagram> compute(std::span<const Circle> circles, const Options& options = {});

}  // namespace circle_voronoi
