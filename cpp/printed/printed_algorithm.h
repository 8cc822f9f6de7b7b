// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "pair.h"
#include "vectors.h"

namespace circle_voronoi {

/// A directed edge of the paper's method: from circle a to circle b, its Voronoi segment to its right.
struct PrintedEdge {
  int a = 0;
  int b = 0;
  Vertex disc;   ///< its disc of R_min
  Vector fromA;  ///< from the center of a to its footpoint there, of any length
  Vector fromB;
  bool isAntipodal = true;
  int voronoiEdge = 0;
  bool isEnd = false;  ///< whether it leads to the end of its Voronoi edge, not to the start
  bool isAlive = true;
};

/// A Voronoi segment that was finished.
struct PrintedSegment {
  int a = 0;
  int b = 0;
  Vertex from;  ///< its disc of R_min
  Vertex to;    ///< its disc of R_max
};

struct PrintedResult {
  Diagram diagram;  ///< only vertices, their circles and edges
  std::vector<PrintedSegment> segments;
  std::vector<PrintedEdge> leftover;
};

/// The rules to apply as printed; the others are applied as corrected. Each alone makes a difference.
struct AsPrinted {
  /// A three-touch disc continues a directed edge if its center lies on the right side. The correct condition is that
  /// it comes later along the border than the start of the edge.
  bool side = true;
  /// The third directed edge of a three-touch disc is any edge between its circles. The correct choice is the last one
  /// behind the disc.
  bool third = true;
  /// Antipodal discs of intersecting circles count as empty, even if other circles reach into them.
  bool crossing = true;
  /// Three-touch discs inside circles do not count.
  bool inside = true;
};

/// Algorithms 2 to 4 of the paper as they are printed, on the candidates given, to be compared with `touch`. Where the
/// text is ambiguous, this code chooses the reading with fewer wrong results:
/// - antipodal discs have half the gap for radius (section 9 prints the gap); discs of intersecting circles are empty
///   ("assuming"), and their directed edges point from center to center;
/// - the directed edges of a three-touch disc are the ones it was formed of, if they exist, otherwise any of that name;
/// - angles within rounding are equal, and an endpoint is covered only inside an arc that is used;
/// - directed edges with a covered endpoint do not count as leftover.
PrintedResult runPrinted(std::span<const Circle> circles, std::span<const Pair> pairs, const AsPrinted& rules = {});

}  // namespace circle_voronoi
