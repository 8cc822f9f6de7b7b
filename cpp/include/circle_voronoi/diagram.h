// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/certificate.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/index.h"
#include "circle_voronoi/metric.h"
#include "circle_voronoi/sides.h"
#include "circle_voronoi/stats.h"
#include "circle_voronoi/vertex.h"

namespace circle_voronoi {

/// An arc of the bisector of the circles `left` and `right`, which lie left and right of it when you walk from vertex
/// `start` to vertex `end`. An end at infinity is kNone. Two circles may share several edges.
struct Edge {
  CircleIndex left = {};
  CircleIndex right = {};
  VertexIndex start = {};
  VertexIndex end = {};

  friend bool operator==(const Edge&, const Edge&) = default;
};

/// A circle without a cell, and a visible circle `by` that contains it: |c - c_by| <= r_by - r. Among identical
/// circles, the first stays visible. If several visible circles contain the circle, `by` is the largest, or the first
/// of the largest.
struct HiddenCircle {
  CircleIndex circle = {};
  CircleIndex by = {};

  friend bool operator==(const HiddenCircle&, const HiddenCircle&) = default;
};

/// The half-edge structure of a diagram: how its sides are connected. `linkSides` derives it from the other data.
struct Links {
  /// For each side the next side around its cell. If the cell is unbounded, the side that ends at infinity is followed
  /// by the side that begins there.
  std::vector<SideIndex> nextSide;
  /// For each vertex the three sides that begin there. The first one belongs to the first of the vertex's circles, and
  /// so on.
  std::vector<std::array<SideIndex, 3>> vertexSides;
  /// For each circle the smallest of its sides; kNone if it has no cell, or its cell is the whole plane.
  std::vector<SideIndex> firstSide;

  friend bool operator==(const Links&, const Links&) = default;
};

/// The Voronoi diagram of circles, by indices.
///
/// A vertex that touches more than three circles appears as several vertices joined by edges of length zero (paper,
/// section 8). So every vertex has exactly three circles and three edges.
///
/// An edge seen from one of its two cells is a *side* of that cell, a half-edge. Side 2 e of edge e belongs to the left
/// circle and runs from start to end. Side 2 e + 1, its twin, belongs to the right circle and runs from end to start.
/// So each side has its cell on its left, and the sides of a cell run counter-clockwise around it.
///
/// The functions that take a diagram keep their promises for certified diagrams.
struct Diagram {
  /// The circles of the input, hidden ones included.
  std::vector<Circle> circles;
  /// The distance that defines the cells.
  Metric metric = Metric::circles;
  /// Whether the radii are additive weights, which may be negative (Options::weights).
  bool weights = false;

  std::vector<Vertex> vertices;
  /// For each vertex its three circles, counter-clockwise. Two vertices may share all three.
  std::vector<std::array<CircleIndex, 3>> vertexCircles;
  std::vector<Edge> edges;
  /// The hidden circles, in increasing order of `circle`.
  std::vector<HiddenCircle> hidden;
  /// The circles on the convex hull, counter-clockwise. A circle recurs if the hull touches it more than once.
  std::vector<CircleIndex> hull;

  /// Derived from the data above.
  Links links;
  /// Whether the data above are proven to be right.
  Certificate certificate;
  /// Statistics of the computation.
  Stats stats;

  /// Returns whether a circle has a cell. Hidden circles have none.
  [[nodiscard]] bool hasCell(CircleIndex circle) const {
    return links.firstSide[at(circle)] != kNone || (hull.size() == 1 && hull[0] == circle);
  }
  /// Returns the sides of a cell, counter-clockwise. The range is empty if there is no cell, or it is the whole plane.
  [[nodiscard]] Sides sides(CircleIndex circle) const { return {links.nextSide, links.firstSide[at(circle)]}; }

  [[nodiscard]] static SideIndex twin(SideIndex side) { return side ^ 1; }
  [[nodiscard]] static EdgeIndex edgeOf(SideIndex side) { return side / 2; }
  /// Returns the circle whose cell has this side.
  [[nodiscard]] CircleIndex circleOf(SideIndex side) const {
    return side % 2 == 0 ? edgeAt(side).left : edgeAt(side).right;
  }
  /// Returns the circle on the other side of the edge.
  [[nodiscard]] CircleIndex neighborOf(SideIndex side) const { return circleOf(twin(side)); }
  /// Returns the vertex where a side begins, or kNone.
  [[nodiscard]] VertexIndex originOf(SideIndex side) const {
    return side % 2 == 0 ? edgeAt(side).start : edgeAt(side).end;
  }
  /// Returns the vertex where a side ends, or kNone.
  [[nodiscard]] VertexIndex targetOf(SideIndex side) const { return originOf(twin(side)); }

 private:
  static std::size_t at(std::int32_t index) { return static_cast<std::size_t>(index); }
  const Edge& edgeAt(SideIndex side) const { return edges[at(edgeOf(side))]; }
};

/// Fills the links of a diagram from its other data. Linear time, except that the hull is sorted.
///
/// Returns whether vertices, edges and hull fit together. If they do not, all links are kNone, and `certify` describes
/// the problem.
CIRCLE_VORONOI_API bool linkSides(Diagram& diagram);

}  // namespace circle_voronoi
