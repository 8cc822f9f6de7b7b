// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/progress.h"
#include "circle_voronoi/trace.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

/// The largest coordinate or radius, in absolute value, that is accepted.
inline constexpr double kCoordinateLimit = 1e150;

/// How the diagram is built.
enum class Method {
  automatic,     ///< the fastest construction that leads to a certified diagram (ARCHITECTURE.md)
  touchingDisc,  ///< the paper's method: candidate pairs, then the event loop
  flip,          ///< edge flips from the Delaunay triangulation of the centres
};

/// Which pairs of circles get an antipodal disc.
enum class Candidates {
  dynamic,   ///< neighbours in the Delaunay graph of dynamically chosen samples (paper, section 5)
  uniform,   ///< the same with equally spaced samples on every circle (paper, section 4.1)
  allPairs,  ///< every pair (paper, section 3): quadratic time and memory
};

inline constexpr int kDefaultDynamicSamples = 1;
inline constexpr int kDefaultUniformSamples = 50;
inline constexpr int kMaxSamples = 1000;
/// The most circles that `allPairs` accepts: 50 million pairs.
inline constexpr std::size_t kMaxAllPairsCircles = 10000;

struct Options {
  /// Whether the radii are additive weights, which may be negative.
  bool weights = false;
  Method method = Method::automatic;
  /// For the touching disc method, as are the options below but the last two.
  Candidates candidates = Candidates::dynamic;
  /// dynamic: N_s, samples inside each angle of a Delaunay face, 0 to kMaxSamples.
  /// uniform: m, samples on each circle, 1 to kMaxSamples.
  /// -1: the default of the candidates chosen. allPairs takes none.
  int samples = -1;
  /// dynamic: if the diagram is not certified, take more samples around what is wrong and try again.
  bool resample = false;
  /// Told each event (trace.h); costs nothing when empty.
  Observer observer;
  /// Told how far the computation has come; costs nothing when empty.
  Progress progress;
};

/// The Voronoi diagram of `circles`.
///
/// Circles may be disjoint, intersecting, tangent, nested, equal or points, in any position, and any number from 0.
/// The same input gives the same bits on every platform.
/// Where more than three circles touch one disc, their faces depend on the places of their centres alone: neither on
/// the order of the circles nor on the method. The whole is scaled by a power of two first, which is exact unless a
/// number is smaller than the largest by a factor of 2^1100 (1e331): such a number is rounded to the nearest multiple
/// of 2^-1154 of the largest, and right is what is right for the rounded circles.
///
/// A point belongs to the circle of least distance less radius, so radii count by their differences alone, and with
/// `weights` they may have any sign. To add one number to all, where no sum is rounded and the scaling rounds nothing,
/// changes neither the topology nor a bit of the vertices' coordinates, though perhaps the order of vertices and edges;
/// of the vertices' radii it takes that number.
///
/// By `automatic` the diagram is certified, or there is an error. By the other methods the diagram comes with the
/// certificate's verdict and may be wrong where that says so.
/// Vertices are right to 36 bits of the distances between their centre and their circles. Where three circles lie so
/// nearly along a line that their vertex is beyond the doubles (1.8e308), there is an error: this takes circles whose
/// sizes and distances differ by more than a factor of 1e150.
/// Errors: nonFinite, negativeRadius (without `weights`), coordinateTooLarge (with the index of the first such circle),
/// badOption, tooManyCircles, notCertified, badArithmetic, internal.
Result<Diagram> compute(std::span<const Circle> circles, const Options& options = {});

}  // namespace circle_voronoi
