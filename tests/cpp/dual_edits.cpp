// SPDX-License-Identifier: GPL-3.0-or-later
#include "dual_edits.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "three_touch_disc.h"
#include "topology.h"

namespace circle_voronoi::test {
namespace {

int addFace(Dual& dual, int a, int b, int c) {
  dual.origin.insert(dual.origin.end(), {a, b, c});
  dual.twin.insert(dual.twin.end(), {kNone, kNone, kNone});
  return dual.faceCount() - 1;
}

}  // namespace

int flipRandomEdges(Dual& dual, int count, Random& random) {
  int flips = 0;
  for (int i = 0; i < count; ++i) {
    const auto h = static_cast<int>(random.below(static_cast<std::size_t>(dual.halfEdgeCount())));
    if (dual.origin[Dual::previous(h)] == dual.origin[Dual::previous(dual.twin[h])]) continue;
    dual.flip(h);
    ++flips;
  }
  return flips;
}

void insertInFace(Dual& dual, int face, int circle) {
  const int ab = 3 * face;
  const int a = dual.origin[ab];
  const int b = dual.origin[ab + 1];
  const int c = dual.origin[ab + 2];
  const int beyondBc = dual.twin[ab + 1];
  const int beyondCa = dual.twin[ab + 2];
  dual.origin[ab + 2] = circle;  // (a, b, circle)
  const int bc = 3 * addFace(dual, b, c, circle);
  const int ca = 3 * addFace(dual, c, a, circle);
  dual.link(bc, beyondBc);
  dual.link(ca, beyondCa);
  dual.link(ab + 1, bc + 2);
  dual.link(bc + 1, ca + 2);
  dual.link(ca + 1, ab + 2);
}

void insertOnEdge(Dual& dual, int h, int circle) {
  const int t = dual.twin[h];
  const int a = dual.origin[h];
  const int b = dual.origin[t];
  const int left = 3 * addFace(dual, b, a, circle);   // beyond h
  const int right = 3 * addFace(dual, a, b, circle);  // beyond t
  dual.link(h, left);
  dual.link(t, right);
  dual.link(left + 1, right + 2);
  dual.link(left + 2, right + 1);
}

Dual dualOf(const Diagram& diagram, std::size_t circleCount) {
  return std::get<Dual>(circle_voronoi::dualOf(Topology{diagram.vertexCircles, diagram.edges, diagram.hull},
                                               static_cast<int>(circleCount)));
}

void replaceTopology(Diagram& diagram, const Dual& dual, std::span<const Circle> circles) {
  takeTopology(diagram, topologyOf(dual, static_cast<int>(circles.size())));
  diagram.vertices.clear();
  for (auto& triple : diagram.vertexCircles) {
    std::rotate(triple.begin(), std::min_element(triple.begin(), triple.end()), triple.end());
    const auto& [i, j, k] = triple;
    diagram.vertices.push_back(vertexOf(circles[i], circles[j], circles[k]).value_or(Vertex{}));
  }
}

}  // namespace circle_voronoi::test
