// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/index.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

struct Diagram;

/// The first thing that keeps a diagram from being certified.
enum class Flaw {
  none,       ///< the diagram is right
  notJudged,  ///< no certificate was asked for
  badIndex,   ///< an index is out of range, or a triple, an edge or a hull names a circle twice or a hidden one
  hiddenWithoutHider,  ///< a circle is listed as hidden, but the circle it names does not contain it
  adjacency,           ///< edges, vertices and hull do not fit together
  eulerCount,          ///< the number of vertices and hull circles is not that of m visible circles
  vertexWithoutDisc,   ///< no disc touches the three circles of a vertex in that order
  vertexMisplaced,     ///< the disc that touches the three circles of a vertex is elsewhere
  edgeOutOfOrder,      ///< the ends of an edge are in the wrong order along their bisector
  cellNotClosed,       ///< the edges of a cell do not turn exactly once around its circle
  hullNotClosed,       ///< the tangent lines of the hull do not turn exactly once
};

/// The name of a flaw, as in the enumeration.
std::string_view flawName(Flaw flaw);

/// The outcome of judging a diagram: a proof that it is the Voronoi diagram, or the first thing that is wrong.
struct Certificate {
  Flaw flaw = Flaw::notJudged;
  CircleIndex circle = {};  ///< the circle concerned, kNone if there is none
  VertexIndex vertex = {};  ///< the vertex concerned
  EdgeIndex edge = {};      ///< the edge concerned
  std::string message;      ///< one sentence; empty if certified

  bool certified() const { return flaw == Flaw::none; }
};

/// Judges in linear time whether a diagram is the Voronoi diagram of its circles, however it was made. All signs are
/// exact: a diagram is certified if and only if its topology is right, zero-length edges in either direction of a tie
/// included, and its vertices are those of the circles up to rounding: the centre and the radius of each, as they are
/// given, touch its three circles to 40 bits, of the larger of the disc and the coordinates. A disc that has a
/// coordinate or a radius beyond the doubles has no such vertex. Topology is exact, coordinates are right to rounding:
/// two vertices that are apart may be given the same coordinates.
///
/// All but `stats` and the diagram's own `certificate` is looked at; sides must be linked as `linkSides` does. Of
/// Metric::centers radii play no part; for Metric::power there is no certificate.
/// Errors: those of `validate` (nonFinite, negativeRadius unless the diagram is one of weights, coordinateTooLarge,
/// tooManyCircles), badOption for Metric::power, and internal.
Result<Certificate> certify(const Diagram& diagram);

}  // namespace circle_voronoi
