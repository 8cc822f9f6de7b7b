// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/certificate.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/index.h"
#include "circle_voronoi/metric.h"
#include "circle_voronoi/sides.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

/// A Voronoi vertex (branch point): the centre of the disc that touches its three circles from outside.
/// Its radius is signed: it is negative where the three circles overlap, and the centre is at distance r_i + r from the
/// centre of each circle i.
struct Vertex {
  double x = 0;
  double y = 0;
  double r = 0;

  friend bool operator==(const Vertex&, const Vertex&) = default;
};

/// An arc of the bisector of circles `left` and `right`, as seen when going from vertex `start` to vertex `end`.
/// An end at infinity is kNone. Two circles may share several edges.
struct Edge {
  CircleIndex left = {};
  CircleIndex right = {};
  VertexIndex start = {};
  VertexIndex end = {};

  friend bool operator==(const Edge&, const Edge&) = default;
};

/// A circle without a cell, and a circle that is not hidden itself and contains it: |c - c_by| <= r_by - r.
/// Of identical circles the first stays visible. Of several that contain it, `by` is the largest, of equal ones the
/// first.
struct HiddenCircle {
  CircleIndex circle = {};
  CircleIndex by = {};

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

/// The Voronoi diagram of circles, by indices.
///
/// A vertex that touches more than three circles appears as several vertices joined by edges of length zero
/// (paper, section 8), so every vertex has exactly three circles and three edges.
///
/// An edge seen from one of its two cells is a *side* of that cell: a half-edge. Side 2 e of edge e belongs to the left
/// circle and runs from start to end; side 2 e + 1, its twin, belongs to the right circle and runs back. So every side
/// has its own cell on its left, and the sides of a cell run counter-clockwise around it.
///
/// What functions promise of a diagram holds for one that is certified, or made by comparison.h.
struct Diagram {
  /// The input, hidden circles included.
  std::vector<Circle> circles;
  Metric metric = Metric::circles;
  /// Whether the radii are additive weights of any sign (Options::weights).
  bool weights = false;

  std::vector<Vertex> vertices;
  /// For each vertex its three circles, counter-clockwise around it.
  std::vector<std::array<CircleIndex, 3>> vertexCircles;
  std::vector<Edge> edges;
  /// Hidden circles in increasing order of `circle`.
  std::vector<HiddenCircle> hidden;
  /// The circles on the convex hull, counter-clockwise; a circle recurs if the hull touches it more than once.
  std::vector<CircleIndex> hull;

  // How these hang together, as linkSides finds it from them.

  /// For each side the one that follows it around its cell. Where the cell goes to infinity, the next side after one
  /// that ends there begins there.
  std::vector<SideIndex> nextSide;
  /// For each vertex the sides that begin there: the first belongs to the first of its circles, and so on.
  std::vector<std::array<SideIndex, 3>> vertexSides;
  /// For each circle the smallest of its sides; kNone if it has no cell, or its cell is the whole plane.
  std::vector<SideIndex> firstSide;

  Certificate certificate;
  Stats stats;

  /// Hidden circles have no cell.
  bool hasCell(CircleIndex circle) const {
    return firstSide[at(circle)] != kNone || (hull.size() == 1 && hull[0] == circle);
  }
  /// The sides of a cell, counter-clockwise; none if there is no cell, or it is the whole plane.
  Sides sides(CircleIndex circle) const { return {nextSide, firstSide[at(circle)]}; }

  static SideIndex twin(SideIndex side) { return side ^ 1; }
  static EdgeIndex edgeOf(SideIndex side) { return side / 2; }
  CircleIndex circleOf(SideIndex side) const { return side % 2 == 0 ? edgeAt(side).left : edgeAt(side).right; }
  /// The circle on the other side of the edge.
  CircleIndex neighborOf(SideIndex side) const { return circleOf(twin(side)); }
  /// The vertex where a side begins, or kNone.
  VertexIndex originOf(SideIndex side) const { return side % 2 == 0 ? edgeAt(side).start : edgeAt(side).end; }
  /// The vertex where a side ends, or kNone.
  VertexIndex targetOf(SideIndex side) const { return originOf(twin(side)); }

 private:
  static std::size_t at(std::int32_t index) { return static_cast<std::size_t>(index); }
  const Edge& edgeAt(SideIndex side) const { return edges[at(edgeOf(side))]; }
};

/// Fills `nextSide`, `vertexSides` and `firstSide` of a diagram that was put together otherwise, in linear time but for
/// sorting the hull. Returns whether the rest fits together; if it does not, no side has a next one, and `certify` says
/// what is wrong.
bool linkSides(Diagram& diagram);

}  // namespace circle_voronoi
