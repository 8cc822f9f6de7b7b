// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/clearest_path.h"

#include <algorithm>
#include <limits>
#include <queue>

#include "circle_voronoi/finder.h"
#include "clip.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Where the ray from a cell's centre through a point leaves the cell.
struct Exit {
  std::int32_t edge = kNone;  ///< kNone: never
  double parameter = 0;       ///< on the curve of the edge
  Point point;
};

Exit exitOf(const Cells& cells, std::int32_t circle, Point p) {
  const Circle& c = cells.circles()[static_cast<std::size_t>(circle)];
  Vector direction = {p.x - c.x, p.y - c.y};
  if (direction.x == 0 && direction.y == 0) direction = {1, 0};
  // One side is crossed; which one rounding may leave open where two meet.
  constexpr double kTolerance = 1 + 1e-9;
  double leastMiss = kTolerance;
  Exit exit;
  for (const std::int32_t side : cells.sides(circle)) {
    const EdgeCurve curve = edgeCurve(cells.circles(), cells.diagram(), side / 2);
    const LineCrossing ray(curve.bisector, {c.x, c.y}, direction);
    for (const double s : ray.parameters()) {
      const Point crossing = pointAt(curve.bisector, s);
      if (!(facing(direction, {crossing.x - c.x, crossing.y - c.y}) > 0)) continue;
      const double miss = s < curve.from ? curve.from / s : s > curve.to ? s / curve.to : 1;
      if (miss >= leastMiss) continue;
      leastMiss = miss;
      exit = {side / 2, std::clamp(s, curve.from, curve.to), crossing};
    }
  }
  return exit;
}

class PathFinder {
 public:
  explicit PathFinder(const Cells& cells)
      : cells_(cells), infinity_(static_cast<std::int32_t>(cells.diagram().vertices.size())) {
    const auto& edges = cells.diagram().edges;
    first_.assign(static_cast<std::size_t>(infinity_) + 2, 0);
    for (const Edge& edge : edges) {
      ++first_[nodeOf(edge.start) + 1];
      ++first_[nodeOf(edge.end) + 1];
    }
    for (std::size_t node = 1; node < first_.size(); ++node) first_[node] += first_[node - 1];
    incident_.resize(2 * edges.size());
    std::vector<std::size_t> place(first_.begin(), first_.end() - 1);
    for (std::size_t e = 0; e < edges.size(); ++e) {
      incident_[place[nodeOf(edges[e].start)]++] = static_cast<std::int32_t>(e);
      incident_[place[nodeOf(edges[e].end)]++] = static_cast<std::int32_t>(e);
    }
  }

  ClearestPath run(Point p, Point q) {
    const Finder finder(cells_);
    const std::int32_t fromCircle = finder.find(p);
    const std::int32_t toCircle = finder.find(q);
    const Exit from = exitOf(cells_, fromCircle, p);
    const Exit to = exitOf(cells_, toCircle, q);

    reach_.assign(static_cast<std::size_t>(infinity_) + 1, {});
    leave(from);
    settle();
    ClearestPath path = arrive(from, to);
    path.clearance = std::min({path.clearance, cells_.distance(fromCircle, p), cells_.distance(toCircle, q)});
    if (from.edge != kNone) path.entry = from.point;
    if (to.edge != kNone) path.exit = to.point;
    return path;
  }

 private:
  /// How clear the best path to a node is, and the edge by which it comes.
  struct Reach {
    double clearance = -kInfinite;
    std::int32_t edge = kNone;
    std::int32_t before = kNone;  ///< the node it comes from; kNone: the start
  };

  std::size_t nodeOf(std::int32_t vertex) const {
    return static_cast<std::size_t>(vertex == kNone ? infinity_ : vertex);
  }
  const Edge& edgeAt(std::int32_t edge) const { return cells_.diagram().edges[static_cast<std::size_t>(edge)]; }

  /// The least distance from its circles along a part of an edge: at the apex if that is inside, else at an end.
  double clearanceOf(const EdgeCurve& curve, std::int32_t edge, double from, double to) const {
    const auto at = [&](double s) { return cells_.distance(edgeAt(edge).left, pointAt(curve.bisector, s)); };
    if (from <= 1 && 1 <= to) return at(1);
    return from > 1 ? at(from) : at(to);
  }

  void offer(std::size_t node, double clearance, std::int32_t edge, std::int32_t before) {
    Reach& reach = reach_[node];
    if (!(clearance > reach.clearance)) return;
    reach = {clearance, edge, before};
    pending_.emplace(clearance, node);
  }

  void leave(const Exit& from) {
    if (from.edge == kNone) return offer(nodeOf(kNone), kInfinite, kNone, kNone);
    const EdgeCurve curve = edgeCurve(cells_.circles(), cells_.diagram(), from.edge);
    const Edge& edge = edgeAt(from.edge);
    offer(nodeOf(edge.start), clearanceOf(curve, from.edge, curve.from, from.parameter), from.edge, kNone);
    offer(nodeOf(edge.end), clearanceOf(curve, from.edge, from.parameter, curve.to), from.edge, kNone);
  }

  void settle() {
    while (!pending_.empty()) {
      const auto [clearance, node] = pending_.top();
      pending_.pop();
      if (clearance < reach_[node].clearance) continue;
      for (std::size_t k = first_[node]; k < first_[node + 1]; ++k) {
        const std::int32_t e = incident_[k];
        const EdgeCurve curve = edgeCurve(cells_.circles(), cells_.diagram(), e);
        const double along = std::min(clearance, clearanceOf(curve, e, curve.from, curve.to));
        const auto before = static_cast<std::int32_t>(node);
        offer(nodeOf(edgeAt(e).start), along, e, before);
        offer(nodeOf(edgeAt(e).end), along, e, before);
      }
    }
  }

  ClearestPath arrive(const Exit& from, const Exit& to) const {
    if (to.edge == kNone) return pathTo(nodeOf(kNone), kInfinite, kNone);
    const EdgeCurve curve = edgeCurve(cells_.circles(), cells_.diagram(), to.edge);
    const Edge& edge = edgeAt(to.edge);
    const double byStart = clearanceOf(curve, to.edge, curve.from, to.parameter);
    const double byEnd = clearanceOf(curve, to.edge, to.parameter, curve.to);
    const double throughStart = std::min(byStart, reach_[nodeOf(edge.start)].clearance);
    const double throughEnd = std::min(byEnd, reach_[nodeOf(edge.end)].clearance);
    if (from.edge == to.edge) {
      const auto [low, high] = std::minmax(from.parameter, to.parameter);
      const double direct = clearanceOf(curve, to.edge, low, high);
      if (direct >= throughStart && direct >= throughEnd) return {direct, {to.edge}, {}, {}};
    }
    return throughStart >= throughEnd ? pathTo(nodeOf(edge.start), byStart, to.edge)
                                      : pathTo(nodeOf(edge.end), byEnd, to.edge);
  }

  /// The path to a node, and on along a last edge.
  ClearestPath pathTo(std::size_t node, double clearance, std::int32_t last) const {
    ClearestPath path;
    path.clearance = std::min(clearance, reach_[node].clearance);
    if (last != kNone) path.edges.push_back(last);
    for (auto at = static_cast<std::int32_t>(node); at != kNone; at = reach_[static_cast<std::size_t>(at)].before) {
      const std::int32_t edge = reach_[static_cast<std::size_t>(at)].edge;
      if (edge != kNone) path.edges.push_back(edge);
    }
    std::ranges::reverse(path.edges);
    return path;
  }

  const Cells& cells_;
  std::int32_t infinity_;
  /// The edges at each vertex and at infinity: those from first_[node] to first_[node + 1] in incident_.
  std::vector<std::size_t> first_;
  std::vector<std::int32_t> incident_;
  std::vector<Reach> reach_;
  std::priority_queue<std::pair<double, std::size_t>> pending_;
};

}  // namespace

ClearestPath clearestPath(const Cells& cells, Point p, Point q) { return PathFinder(cells).run(p, q); }

}  // namespace circle_voronoi
