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

/// A diagram without coordinates, as in Diagram.
struct Topology {
  std::vector<std::array<CircleIndex, 3>> vertexCircles;
  std::vector<Edge> edges;
  std::vector<CircleIndex> hull;
};

/// The vertex that each face of a dual is, by its number among the finite ones; kNone if it is none.
std::vector<VertexIndex> verticesOf(const Dual& dual, Threads threads);

/// The finite faces of a dual become the vertices, in their order and each from its smallest corner on; its pairs of
/// half-edges between circles become the edges, and the neighbors of infinity the hull. `circleCount` says what a dual
/// without faces stands for. Fills `links`, if given.
Topology topologyOf(const Dual& dual, int circleCount, Links* links = nullptr, Threads threads = Threads());

/// The same, given verticesOf(dual).
Topology topologyOf(const Dual& dual, const std::vector<VertexIndex>& vertexOf, int circleCount, Links* links,
                    Threads threads);

/// Rotates a hull so that it starts with its smallest step: then it does not depend on how it was found.
void rotateHull(std::vector<CircleIndex>& hull);

/// Why a topology is not that of a triangulated sphere, and where.
struct Misfit {
  Flaw flaw = Flaw::adjacency;
  CircleIndex circle = {};
  VertexIndex vertex = {};
  EdgeIndex edge = {};
};

/// The dual whose face i, for i below the number of vertices, is vertex i; faces at infinity follow in the order of the
/// hull. Indices of circles must be below `circleCount`. Fills `links`, if given, where the topology fits.
std::variant<Dual, Misfit> dualOf(const Topology& topology, int circleCount, Links* links = nullptr);

}  // namespace circle_voronoi
