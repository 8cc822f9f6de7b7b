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
/// Numbers are at most 2^96 (7.9e28) in absolute value. Each is rounded once to a multiple of 2^-96 (1.3e-29), as every
/// number from 2^-44 (5.7e-14) up already is. The circles of the diagram are the rounded ones, and so is the
/// certificate about them. If the largest number is not 0 and below 2^-56 (1.4e-17), there is an error.
///
/// A point belongs to the circle with the smallest distance minus radius, so only the differences of the radii matter.
/// With `weights` they may be negative. If you add the same number to all radii, the topology and the coordinates of
/// the vertices keep their bits, and the radii of the vertices decrease by that number. This requires that the sums do
/// not round. The order of vertices and edges may change.
///
/// With `automatic` the result is certified, or there is an error. With the other methods the diagram comes with its
/// certificate and may be wrong where the certificate says so.
///
/// `automatic` takes about n log n steps for n circles.
///
/// Vertices are at their exact places to 36 bits of their distances from their circles (certify.h says why it asks for
/// 40).
///
/// Errors: nonFinite, negativeRadius (without `weights`), coordinateTooLarge (these three name the first such circle),
/// coordinateTooSmall, badOption, tooManyCircles, notCertified, badArithmetic, internal.
Result<Diagram> compute(std::span<const Circle> circles, const Options& options = {});

}  // namespace circle_voronoi
