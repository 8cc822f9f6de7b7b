// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "circle_voronoi/diagram.h"
#include "dual.h"
#include "threads.h"

namespace circle_voronoi {

/// A diagram without coordinates. The fields have the same meaning as in Diagram.
struct Topology {
  std::vector<std::array<CircleIndex, 3>> vertexCircles;
  std::vector<Edge> edges;
  std::vector<CircleIndex> hull;
};

/// Returns the vertex index of each face of a dual: its number among the finite faces, or kNone for a face at infinity.
std::vector<VertexIndex> verticesOf(const Dual& dual, Threads threads);

/// Returns the topology of a dual. The finite faces become the vertices, in the same order, and each triple starts with
/// its smallest corner. The pairs of half-edges between circles become the edges, and the neighbors of infinity become
/// the hull. If the dual has no faces, `circleCount` tells whether there is one circle.
Topology topologyOf(Dual dual, int circleCount);

/// Returns the topology of a dual, like the overload above, where `vertexOf` is verticesOf(dual). Sets `links`. Uses
/// the memory of the dual.
Topology topologyOf(Dual dual, const std::vector<VertexIndex>& vertexOf, int circleCount, Links& links,
                    Threads threads);

/// Rotates a hull so that it starts with its smallest pair of successive circles. Then the hull does not depend on how
/// it was found.
void rotateHull(std::vector<CircleIndex>& hull);

/// Moves a topology into a diagram, with its hull rotated as above.
void takeTopology(Diagram& diagram, Topology topology);

/// The reason why a topology is not that of a triangulated sphere, and the place.
struct TopologyFlaw {
  Flaw flaw = Flaw::adjacency;
  CircleIndex circle = {};
  VertexIndex vertex = {};
  EdgeIndex edge = {};
};

/// Returns the dual of a topology, or the flaw if there is none. Face i is vertex i, for i below the number of
/// vertices. Faces at infinity follow in the order of the hull. Indices of circles must be below `circleCount`. Fills
/// `links`, if given, where the topology fits.
std::variant<Dual, TopologyFlaw> dualOf(const Topology& topology, int circleCount, Links* links = nullptr);

}  // namespace circle_voronoi
