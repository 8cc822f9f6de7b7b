// SPDX-License-Identifier: GPL-3.0-or-later
#include "adjacency.h"

#include <algorithm>
#include <utility>

namespace circle_voronoi {
namespace {

constexpr std::array<SideIndex, 3> kNoSides = {kNone, kNone, kNone};

class Linker {
 public:
  explicit Linker(const Diagram& diagram)
      : diagram_(diagram), sideCount_(static_cast<std::int32_t>(2 * diagram.edges.size())) {}

  std::optional<Adjacency> run() {
    if (!hasValidIndices()) return std::nullopt;
    result_.nextSide.assign(2 * diagram_.edges.size(), kNone);
    result_.vertexSides.assign(diagram_.vertexCircles.size(), kNoSides);
    result_.firstSide.assign(diagram_.circles.size(), kNone);
    if (!linkAtVertices() || !linkAtInfinity()) return std::nullopt;
    for (SideIndex side = 0; side < sideCount_; ++side) {
      SideIndex& first = result_.firstSide[at(diagram_.circleOf(side))];
      if (first == kNone) first = side;
    }
    return std::move(result_);
  }

 private:
  static std::size_t at(std::int32_t index) { return static_cast<std::size_t>(index); }

  bool hasValidIndices() const {
    const auto isBelow = [](std::int32_t index, std::size_t count) { return index >= 0 && at(index) < count; };
    const auto isCircle = [&](CircleIndex i) { return isBelow(i, diagram_.circles.size()); };
    const auto isEnd = [&](VertexIndex v) { return v == kNone || isBelow(v, diagram_.vertexCircles.size()); };
    const auto isValid = [&](const Edge& edge) {
      return isCircle(edge.left) && isCircle(edge.right) && isEnd(edge.start) && isEnd(edge.end);
    };
    return diagram_.vertices.size() == diagram_.vertexCircles.size() &&
           std::all_of(diagram_.hull.begin(), diagram_.hull.end(), isCircle) &&
           std::all_of(diagram_.edges.begin(), diagram_.edges.end(), isValid);
  }

  /// A side that leaves a vertex has its own circle on its left, and on its right the one before it around the vertex.
  bool linkAtVertices() {
    for (SideIndex side = 0; side < sideCount_; ++side) {
      const VertexIndex origin = diagram_.originOf(side);
      if (origin == kNone) continue;
      const auto& triple = diagram_.vertexCircles[at(origin)];
      const auto slot =
          static_cast<std::size_t>(std::find(triple.begin(), triple.end(), diagram_.circleOf(side)) - triple.begin());
      if (slot == triple.size() || triple[before(slot)] != diagram_.neighborOf(side)) return false;
      SideIndex& place = result_.vertexSides[at(origin)][slot];
      if (place != kNone) return false;
      place = side;
    }
    for (const auto& sides : result_.vertexSides) {
      if (std::find(sides.begin(), sides.end(), kNone) != sides.end()) return false;
      for (std::size_t slot = 0; slot < sides.size(); ++slot) link(Diagram::twin(sides[slot]), sides[before(slot)]);
    }
    return true;
  }

  /// The side of circle i that begins at infinity next to circle j belongs to the hull's step from i to j, its twin
  /// ends there; each step occurs once.
  bool linkAtInfinity() {
    using Step = std::pair<CircleIndex, CircleIndex>;
    std::vector<std::pair<Step, SideIndex>> fromInfinity;
    for (SideIndex side = 0; side < sideCount_; ++side) {
      if (diagram_.originOf(side) != kNone) continue;
      fromInfinity.push_back({{diagram_.circleOf(side), diagram_.neighborOf(side)}, side});
    }
    const auto& hull = diagram_.hull;
    const std::size_t steps = hull.size() > 1 ? hull.size() : 0;
    if (fromInfinity.size() != steps) return false;
    std::sort(fromInfinity.begin(), fromInfinity.end());
    std::vector<SideIndex> sideOfStep;
    sideOfStep.reserve(steps);
    for (std::size_t k = 0; k < steps; ++k) {
      const Step step = {hull[k], hull[(k + 1) % steps]};
      const auto found = std::lower_bound(fromInfinity.begin(), fromInfinity.end(), std::pair(step, SideIndex(0)));
      if (found == fromInfinity.end() || found->first != step) return false;
      sideOfStep.push_back(found->second);
    }
    for (std::size_t k = 0; k < steps; ++k) {
      const SideIndex toInfinity = Diagram::twin(sideOfStep[k]);
      if (result_.nextSide[at(toInfinity)] != kNone) return false;
      link(toInfinity, sideOfStep[(k + 1) % steps]);
    }
    return true;
  }

  static std::size_t before(std::size_t slot) { return (slot + 2) % 3; }
  void link(SideIndex side, SideIndex next) { result_.nextSide[at(side)] = next; }

  const Diagram& diagram_;
  std::int32_t sideCount_;
  Adjacency result_;
};

}  // namespace

std::optional<Adjacency> adjacencyOf(const Diagram& diagram) { return Linker(diagram).run(); }

bool linkSides(Diagram& diagram) {
  auto found = adjacencyOf(diagram);
  const bool fits = found.has_value();
  if (!fits) {
    found.emplace();
    found->nextSide.assign(2 * diagram.edges.size(), kNone);
    found->vertexSides.assign(diagram.vertexCircles.size(), kNoSides);
    found->firstSide.assign(diagram.circles.size(), kNone);
  }
  diagram.nextSide = std::move(found->nextSide);
  diagram.vertexSides = std::move(found->vertexSides);
  diagram.firstSide = std::move(found->firstSide);
  return fits;
}

}  // namespace circle_voronoi
