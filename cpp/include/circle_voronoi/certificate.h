// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/index.h"

namespace circle_voronoi {

/// The first reason why a diagram is not certified.
enum class Flaw {
  none,       ///< the diagram is right
  notJudged,  ///< no certificate was requested
  badIndex,   ///< an index is out of range, or a triple, an edge or the hull names a circle twice or a hidden one
  hiddenWithoutHider,  ///< a circle is listed as hidden, but the circle named as its hider does not contain it
  adjacency,           ///< edges, vertices and hull do not fit together
  eulerCount,          ///< the numbers of vertices and hull circles contradict Euler's formula
  vertexWithoutDisc,   ///< no disc touches the three circles of a vertex in that order
  vertexMisplaced,     ///< the disc that touches the three circles of a vertex lies elsewhere
  edgeOutOfOrder,      ///< the ends of an edge are in the wrong order along their bisector
  cellNotClosed,       ///< the edges of a cell do not turn exactly once around its circle
  hullNotClosed,       ///< the tangent lines of the hull do not turn exactly once
};

/// Returns the name of a flaw, as in the enumeration.
[[nodiscard]] CIRCLE_VORONOI_API std::string_view flawName(Flaw flaw);

/// The outcome of judging a diagram: either the diagram is proven to be the Voronoi diagram, or the certificate names
/// the first thing that is wrong.
struct Certificate {
  Flaw flaw = Flaw::notJudged;
  CircleIndex circle = {};  ///< the circle concerned, or kNone
  VertexIndex vertex = {};  ///< the vertex concerned, or kNone
  EdgeIndex edge = {};      ///< the edge concerned, or kNone
  std::string message;      ///< one sentence; empty if certified

  [[nodiscard]] bool certified() const { return flaw == Flaw::none; }
};

}  // namespace circle_voronoi
