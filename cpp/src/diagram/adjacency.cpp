// SPDX-License-Identifier: GPL-3.0-or-later
#include "adjacency.h"

#include <algorithm>
#include <utility>

namespace circle_voronoi {
namespace {

constexpr std::array<SideIndex, 3> kNoSides = {kNone, kNone, kNone};

class Linker {
 public:
  explicit Linker(const Diagram& diagram) : diagram_(diagram) {}

  std::optional<Links> run() {
    if (!hasValidIndices()) return std::nullopt;
    result_.nextSide.assign(2 * diagram_.edges.size(), kNone);
    result_.vertexSides.assign(diagram_.vertexCircles.size(), kNoSides);
    result_.firstSide.assign(diagram_.circles.size(), kNone);
    if (!placeSides() || !linkAtVertices() || !linkAtInfinity()) return std::nullopt;
    return std::move(result_);
  }

 private:
  using Step = std::pair<CircleIndex, CircleIndex>;

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

  /// Notes of each side where it begins.
  bool placeSides() {
    SideIndex side = 0;
    for (const auto& [left, right, start, end] : diagram_.edges) {
      if (!place(side, left, right, start) || !place(Diagram::twin(side), right, left, end)) return false;
      side = side + 2;
    }
    return true;
  }

  /// A side that leaves a vertex has its own circle on its left, and on its right the one before it around the vertex.
  bool place(SideIndex side, CircleIndex circle, CircleIndex neighbor, VertexIndex origin) {
    SideIndex& first = result_.firstSide[at(circle)];
    if (first == kNone) first = side;
    if (origin == kNone) {
      fromInfinity_.push_back({{circle, neighbor}, side});
      return true;
    }
    const auto& triple = diagram_.vertexCircles[at(origin)];
    const std::size_t slot = triple[0] == circle ? 0 : triple[1] == circle ? 1 : 2;
    if (triple[slot] != circle || triple[before(slot)] != neighbor) return false;
    SideIndex& place = result_.vertexSides[at(origin)][slot];
    if (place != kNone) return false;
    place = side;
    return true;
  }

  bool linkAtVertices() {
    for (const auto& sides : result_.vertexSides) {
      if (std::find(sides.begin(), sides.end(), kNone) != sides.end()) return false;
      for (std::size_t slot = 0; slot < sides.size(); ++slot) link(Diagram::twin(sides[slot]), sides[before(slot)]);
    }
    return true;
  }

  /// The side of circle i that begins at infinity next to circle j belongs to the hull's step from i to j, its twin
  /// ends there; each step occurs once.
  bool linkAtInfinity() {
    const auto& hull = diagram_.hull;
    const std::size_t steps = hull.size() > 1 ? hull.size() : 0;
    if (fromInfinity_.size() != steps) return false;
    std::sort(fromInfinity_.begin(), fromInfinity_.end());
    std::vector<SideIndex> sideOfStep;
    sideOfStep.reserve(steps);
    for (std::size_t k = 0; k < steps; ++k) {
      const Step step = {hull[k], hull[(k + 1) % steps]};
      const auto found = std::lower_bound(fromInfinity_.begin(), fromInfinity_.end(), std::pair(step, SideIndex(0)));
      if (found == fromInfinity_.end() || found->first != step) return false;
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
  std::vector<std::pair<Step, SideIndex>> fromInfinity_;
  Links result_;
};

}  // namespace

std::optional<Links> linksOf(const Diagram& diagram) { return Linker(diagram).run(); }

bool linkSides(Diagram& diagram) {
  auto found = linksOf(diagram);
  const bool fits = found.has_value();
  if (!fits) {
    found.emplace();
    found->nextSide.assign(2 * diagram.edges.size(), kNone);
    found->vertexSides.assign(diagram.vertexCircles.size(), kNoSides);
    found->firstSide.assign(diagram.circles.size(), kNone);
  }
  diagram.links = *std::move(found);
  return fits;
}

}  // namespace circle_voronoi
