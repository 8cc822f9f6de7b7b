// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/clearest_path.h"

#include <algorithm>
#include <queue>

#include "circle_voronoi/cells.h"
#include "circle_voronoi/finder.h"
#include "circle_voronoi/limits.h"
#include "line_crossing.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

/// The point where the ray from a cell's center through a point leaves the cell.
struct Exit {
  EdgeIndex edge;        ///< kNone: never
  double parameter = 0;  ///< on the curve of the edge
  Point point;
};

Exit exitOf(const Diagram& diagram, CircleIndex circle, Point p) {
  const Circle& c = diagram.circles[static_cast<std::size_t>(circle)];
  // The point may lie anywhere. If it is nearer to the center than the step of all numbers, every direction is right.
  const Vector toPoint = vectorTo({c.x, c.y}, p);
  const double size = largestOf(toPoint);
  const Vector direction = size < kCoordinateStep ? Vector{1, 0} : measuredIn(unitFor(size), toPoint);
  // One side is crossed; which one rounding may leave open where two meet.
  constexpr double kTolerance = 1 + 1e-9;
  double leastMiss = kTolerance;
  Exit exit;
  for (const SideIndex side : diagram.sides(circle)) {
    const EdgeCurve curve = edgeCurve(diagram, Diagram::edgeOf(side));
    const LineCrossing ray(curve.bisector, {c.x, c.y}, direction);
    for (const double s : ray.parameters()) {
      const Point crossing = pointAt(curve.bisector, s);
      if (!(facing(direction, {crossing.x - c.x, crossing.y - c.y}) > 0)) continue;
      const double miss = s < curve.from ? curve.from / s : s > curve.to ? s / curve.to : 1;
      if (miss >= leastMiss) continue;
      leastMiss = miss;
      exit = {Diagram::edgeOf(side), std::clamp(s, curve.from, curve.to), crossing};
    }
  }
  return exit;
}

class PathFinder {
 public:
  explicit PathFinder(const Diagram& diagram) : diagram_(diagram), infinity_(diagram.vertices.size()) {
    for (std::size_t e = 0; e < diagram.edges.size(); ++e) {
      const Edge& edge = diagram.edges[e];
      if (edge.start == kNone || edge.end == kNone) toInfinity_.push_back(static_cast<std::int32_t>(e));
    }
  }

  ClearestPath run(Point p, Point q) {
    const Finder finder(diagram_);
    const CircleIndex fromCircle = finder.find(p);
    const CircleIndex toCircle = finder.find(q);
    const Exit from = exitOf(diagram_, fromCircle, p);
    const Exit to = exitOf(diagram_, toCircle, q);

    reach_.assign(infinity_ + 1, {});
    leave(from);
    settle();
    ClearestPath path = arrive(from, to);
    path.clearance =
        std::min({path.clearance, distanceFrom(diagram_, fromCircle, p), distanceFrom(diagram_, toCircle, q)});
    if (from.edge != kNone) path.entry = from.point;
    if (to.edge != kNone) path.exit = to.point;
    return path;
  }

 private:
  /// How clear the best path to a node is, and the edge by which it comes.
  struct Reach {
    double clearance = -kInfinite;
    EdgeIndex edge;
    std::int32_t before = kNone;  ///< the node it comes from; kNone: the start
  };

  std::size_t nodeOf(VertexIndex vertex) const {
    return vertex == kNone ? infinity_ : static_cast<std::size_t>(vertex);
  }
  const Edge& edgeAt(EdgeIndex edge) const { return diagram_.edges[static_cast<std::size_t>(edge)]; }

  /// The least distance from its circles along a part of an edge: at the apex if that is inside, else at an end.
  double clearanceOf(const EdgeCurve& curve, EdgeIndex edge, double from, double to) const {
    const auto at = [&](double s) { return distanceFrom(diagram_, edgeAt(edge).left, pointAt(curve.bisector, s)); };
    if (from <= 1 && 1 <= to) return at(1);
    return from > 1 ? at(from) : at(to);
  }

  void offer(std::size_t node, double clearance, EdgeIndex edge, std::int32_t before) {
    Reach& reach = reach_[node];
    if (!(clearance > reach.clearance)) return;
    reach = {clearance, edge, before};
    pending_.emplace(clearance, node);
  }

  void leave(const Exit& from) {
    if (from.edge == kNone) return offer(nodeOf(kNone), kInfinite, kNone, kNone);
    const EdgeCurve curve = edgeCurve(diagram_, from.edge);
    const Edge& edge = edgeAt(from.edge);
    offer(nodeOf(edge.start), clearanceOf(curve, from.edge, curve.from, from.parameter), from.edge, kNone);
    offer(nodeOf(edge.end), clearanceOf(curve, from.edge, from.parameter, curve.to), from.edge, kNone);
  }

  void settle() {
    while (!pending_.empty()) {
      const double clearance = pending_.top().first;
      const auto node = pending_.top().second;
      pending_.pop();
      if (clearance < reach_[node].clearance) continue;
      const auto follow = [&](EdgeIndex e) {
        const EdgeCurve curve = edgeCurve(diagram_, e);
        const double along = std::min(clearance, clearanceOf(curve, e, curve.from, curve.to));
        const auto before = static_cast<std::int32_t>(node);
        offer(nodeOf(edgeAt(e).start), along, e, before);
        offer(nodeOf(edgeAt(e).end), along, e, before);
      };
      if (node == infinity_) {
        std::ranges::for_each(toInfinity_, follow);
      } else {
        for (const SideIndex side : diagram_.links.vertexSides[node]) follow(Diagram::edgeOf(side));
      }
    }
  }

  ClearestPath arrive(const Exit& from, const Exit& to) const {
    if (to.edge == kNone) return pathTo(nodeOf(kNone), kInfinite, kNone);
    const EdgeCurve curve = edgeCurve(diagram_, to.edge);
    const Edge& edge = edgeAt(to.edge);
    const double byStart = clearanceOf(curve, to.edge, curve.from, to.parameter);
    const double byEnd = clearanceOf(curve, to.edge, to.parameter, curve.to);
    const double throughStart = std::min(byStart, reach_[nodeOf(edge.start)].clearance);
    const double throughEnd = std::min(byEnd, reach_[nodeOf(edge.end)].clearance);
    if (from.edge == to.edge) {
      const auto [low, high] = std::minmax(from.parameter, to.parameter);
      const double direct = clearanceOf(curve, to.edge, low, high);
      if (direct >= throughStart && direct >= throughEnd) return {direct, {to.edge}, {}, {}, {}};
    }
    return throughStart >= throughEnd ? pathTo(nodeOf(edge.start), byStart, to.edge)
                                      : pathTo(nodeOf(edge.end), byEnd, to.edge);
  }

  /// The path to a node, and on along a last edge.
  ClearestPath pathTo(std::size_t node, double clearance, EdgeIndex last) const {
    ClearestPath path;
    path.clearance = std::min(clearance, reach_[node].clearance);
    if (last != kNone) path.edges.push_back(last);
    for (auto at = static_cast<std::int32_t>(node); at != kNone; at = reach_[static_cast<std::size_t>(at)].before) {
      const EdgeIndex edge = reach_[static_cast<std::size_t>(at)].edge;
      if (edge != kNone) path.edges.push_back(edge);
    }
    std::ranges::reverse(path.edges);
    return path;
  }

  const Diagram& diagram_;
  std::size_t infinity_;
  std::vector<EdgeIndex> toInfinity_;
  std::vector<Reach> reach_;
  std::priority_queue<std::pair<double, std::size_t>> pending_;
};

}  // namespace

ClearestPath clearestPath(const Diagram& diagram, Point p, Point q) { return PathFinder(diagram).run(p, q); }

}  // namespace circle_voronoi
