// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/certificate.h"
#include "circle_voronoi/none.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

/// A Voronoi vertex (branch point): the centre of the disc that touches its three circles from outside.
/// `radius` is signed: it is negative where the three circles overlap, and the centre is at distance
/// r_i + radius from the centre of each circle i.
struct Vertex {
  double x = 0;
  double y = 0;
  double radius = 0;

  friend bool operator==(const Vertex&, const Vertex&) = default;
};

/// An arc of the bisector of circles `left` and `right`, as seen when going from vertex `start` to vertex `end`.
/// An end at infinity is kNone. Two circles may share several edges.
struct Edge {
  std::int32_t left = kNone;
  std::int32_t right = kNone;
  std::int32_t start = kNone;
  std::int32_t end = kNone;

  friend bool operator==(const Edge&, const Edge&) = default;
};

/// A circle without a cell, and a circle that is not hidden itself and contains it: |c - c_by| <= r_by - r.
/// Of identical circles the first stays visible. Of several that contain it, `by` is the largest, of equal ones the
/// first.
struct HiddenCircle {
  std::int32_t circle = kNone;
  std::int32_t by = kNone;

  friend bool operator==(const HiddenCircle&, const HiddenCircle&) = default;
};

/// How much each stage had to do.
struct Counts {
  std::int64_t circles = 0;          ///< input circles
  std::int64_t hidden = 0;           ///< of these, hidden ones
  std::int64_t samples = 0;          ///< sample points on circles (paper, section 5)
  std::int64_t antipodalDiscs = 0;   ///< candidate pairs, each with one antipodal disc (AD)
  std::int64_t threeTouchDiscs = 0;  ///< three-touch discs (TTDs) formed
  std::int64_t events = 0;           ///< discs taken from the queue
  std::int64_t leftoverCycles = 0;   ///< cycles of leftover directed edges; 1 in a right diagram of two circles or more
  std::int64_t resamplings = 0;      ///< times that more samples were taken (Options::resample)
  std::int64_t flips = 0;            ///< edges flipped
  std::int64_t repairs = 0;          ///< places where a local diagram was spliced in
  std::int64_t filtered = 0;         ///< predicates decided in floating point, with an error bound
  std::int64_t refined = 0;          ///< predicates decided so with twice the digits: near ties
  std::int64_t inCircle = 0;         ///< predicates decided by the exact in-circle test of centres (equal radii)
  std::int64_t exact = 0;            ///< predicates decided in integer arithmetic
};

/// Wall-clock seconds of each stage.
struct Seconds {
  double hide = 0;
  double sample = 0;
  double pair = 0;
  double touch = 0;
  double flip = 0;
  double repair = 0;
  double certify = 0;
  double total = 0;
};

struct Stats {
  std::string method;  ///< the method asked for
  std::string way;  ///< the construction that made the result: flip, repair, insert, apollonius-graph or touching-disc
  std::string candidates;
  Counts counts;
  Seconds seconds;
};

/// The Voronoi diagram of n circles by indices. Circle indices are those of the input.
///
/// A vertex that touches more than three circles appears as several vertices joined by edges of length zero
/// (paper, section 8), so every vertex has exactly three circles and three edges.
struct Diagram {
  std::vector<Vertex> vertices;
  /// For each vertex its three circles, counter-clockwise around it.
  std::vector<std::array<std::int32_t, 3>> vertexCircles;
  std::vector<Edge> edges;
  /// Hidden circles in increasing order of `circle`.
  std::vector<HiddenCircle> hidden;
  /// The circles on the convex hull, counter-clockwise; a circle recurs if the hull touches it more than once.
  std::vector<std::int32_t> hull;
  Certificate certificate;
  Stats stats;
};

}  // namespace circle_voronoi
