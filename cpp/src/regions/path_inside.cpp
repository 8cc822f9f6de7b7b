// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

#include "at.h"
#include "circle_voronoi/cells.h"
#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/finder.h"
#include "circle_voronoi/limits.h"
#include "circle_voronoi/region_queries.h"
#include "clip.h"
#include "guarded.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

/// The relative error of places on curves.
constexpr double kSlackOfPlace = 1e-9;

/// Where a ray meets a piece: at a parameter of an edge, at a share of a segment.
struct Hit {
  std::size_t piece;
  double place;
  Point point;
};

/// A piece of the outline of a cell: a part of an edge in its direction, or a part of the boundary.
struct PathPiece {
  EdgeCurve curve;
  EdgeIndex edge;  ///< kNone on the boundary
  CircleIndex circle;
  std::vector<Hit> hits = {};
};

/// A link from one node to another.
struct PathLink {
  std::array<std::size_t, 2> nodes;
  EdgeCurve curve;
  EdgeIndex edge;
  double clearance = 0;
  double length = 0;
};

class PathGraph {
 public:
  PathGraph(const Diagram& diagram, const ClippedDiagram& clipped)
      : diagram_(diagram), ofCell_(diagram.circles.size()) {
    std::map<std::tuple<std::int32_t, double, double>, std::size_t> ofEdges;
    std::vector<Outline> outlines;
    for (std::size_t i = 0; i < diagram.circles.size(); ++i) {
      const auto circle = static_cast<std::int32_t>(i);
      outlines.push_back(clipped.outline(circle));
      for (const auto& loop : outlines.back()) {
        for (const OutlinePiece& piece : loop) ofCell_[i].push_back(pieceOf(piece, circle, ofEdges));
      }
    }
    for (std::size_t i = 0; i < outlines.size(); ++i) {
      for (const auto& loop : outlines[i]) {
        for (std::size_t k = 0; k < loop.size(); ++k) {
          const OutlinePiece& before = loop[(k + loop.size() - 1) % loop.size()];
          if (loop[k].side == kNone && before.side == kNone) {
            passCorner(static_cast<std::int32_t>(i), before.curve, loop[k].curve);
          }
        }
      }
    }
  }

  /// Follows the ray from the center of a circle through a point, from this point to where it leaves the cell, or the
  /// region. `least` is how far ahead that is, as a share of the distance from the center.
  std::optional<Point> shoot(CircleIndex circle, Point from, double least) {
    const Point center = centerOf(circle);
    const Vector toPoint = vectorTo(center, from);
    const bool isCenter = largestOf(toPoint) < kCoordinateStep;
    const Vector direction = isCenter ? Vector{1, 0} : measuredIn(lengthOf(toPoint), toPoint);
    std::optional<Hit> first;
    double nearest = kInfinite;
    for (const std::size_t piece : ofCell_[at(circle)]) {
      visitCrossings(piece, center, direction, [&](const Hit& hit) {
        const double ahead = dot(direction, vectorTo(from, hit.point));
        if (!(ahead >= least * lengthOf(vectorTo(center, hit.point)) && ahead < nearest)) return;
        nearest = ahead;
        first = hit;
      });
    }
    if (!first) return std::nullopt;
    pieces_[first->piece].hits.push_back(*first);
    return first->point;
  }

  /// Links the ends of pieces and the points between them that rays hit.
  void link() {
    for (PathPiece& piece : pieces_) {
      const bool isEdge = piece.edge != kNone;
      std::ranges::stable_sort(piece.hits, {}, &Hit::place);
      piece.hits.push_back({0, isEdge ? piece.curve.to : 1, piece.curve.end});
      Hit last = {0, isEdge ? piece.curve.from : 0, piece.curve.start};
      for (const Hit& next : piece.hits) {
        if (last.point != next.point) {
          EdgeCurve part = piece.curve;
          if (isEdge) {
            std::tie(part.from, part.to, part.start, part.end) =
                std::tie(last.place, next.place, last.point, next.point);
          } else {
            part = segment(last.point, next.point);
          }
          add(part, piece.edge, clearanceOf(part, isEdge, piece.circle));
        }
        last = next;
      }
    }
  }

  /// Returns the shortest of the clearest paths from one place to another.
  std::optional<std::vector<PathLink>> route(Point from, Point to) {
    const std::size_t start = nodeOf(from);
    const std::size_t goal = nodeOf(to);
    const auto clearest = best(
        start, kInfinite, [](double clearance, const PathLink& link) { return std::min(clearance, link.clearance); });
    const double clearance = clearest.keys[goal];
    if (!(clearance > -kInfinite)) return std::nullopt;
    const auto shortest = best(start, 0, [&](double length, const PathLink& link) {
      return link.clearance >= clearance ? length - link.length : -kInfinite;
    });
    std::vector<PathLink> links;
    for (std::size_t node = goal; node != start;) {
      PathLink link = links_[shortest.by[node]];
      const bool isForward = link.nodes[1] == node;
      node = link.nodes[isForward ? 0 : 1];
      if (!isForward) link.curve = reversed(link.curve);
      links.push_back(std::move(link));
    }
    std::ranges::reverse(links);
    return links;
  }

 private:
  Point centerOf(CircleIndex circle) const {
    const Circle& c = diagram_.circles[at(circle)];
    return {c.x, c.y};
  }

  /// Both cells of an edge have the same piece.
  std::size_t pieceOf(const OutlinePiece& piece, CircleIndex circle,
                      std::map<std::tuple<std::int32_t, double, double>, std::size_t>& ofEdges) {
    if (piece.side == kNone) {
      pieces_.push_back({piece.curve, kNone, circle});
      return pieces_.size() - 1;
    }
    const EdgeIndex edge = Diagram::edgeOf(piece.side);
    const EdgeCurve forward = piece.side % 2 == 1 ? reversed(piece.curve) : piece.curve;
    const auto [known, isNew] =
        ofEdges.try_emplace({static_cast<std::int32_t>(edge), forward.start.x, forward.start.y}, pieces_.size());
    if (isNew) pieces_.push_back({forward, edge, circle});
    return known->second;
  }

  /// Adds the ray from a center past a corner that reaches into its cell.
  void passCorner(CircleIndex circle, const EdgeCurve& before, const EdgeCurve& after) {
    const Point corner = after.start;
    const Vector along = vectorTo(before.start, before.end);
    const Vector onward = vectorTo(after.start, after.end);
    const Vector ray = vectorTo(centerOf(circle), corner);
    if (!(turn(along, onward) < 0) || !(turn(along, ray) > 0 || turn(onward, ray) > 0)) return;
    const auto hit = shoot(circle, corner, kSlackOfPlace);
    if (hit && *hit != corner) add(segment(corner, *hit), kNone, distanceFrom(diagram_, circle, corner));
  }

  /// Calls `visit` with each place where the ray from a center meets a piece.
  template <class Visit>
  void visitCrossings(std::size_t index, Point center, Vector direction, Visit visit) const {
    const EdgeCurve& curve = pieces_[index].curve;
    const auto offer = [&](double place, double first, double last, auto pointAtPlace) {
      const Point point = place == first ? curve.start : place == last ? curve.end : pointAtPlace(place);
      if (facing(direction, vectorTo(center, point)) > 0) visit({index, place, point});
    };
    if (pieces_[index].edge != kNone) {
      const double from = curve.from;
      const double to = curve.to;
      const LineCrossing line(curve.bisector, center, direction);
      for (const double s : line.parameters()) {
        if (!(s >= from * (1 - kSlackOfPlace) && s <= to * (1 + kSlackOfPlace))) continue;
        offer(std::clamp(s, from, to), from, to, [&](double place) { return pointAt(curve.bisector, place); });
      }
      return;
    }
    const Point start = curve.start;
    const Vector along = vectorTo(start, curve.end);
    const double share = cross(direction, vectorTo(start, center)) / cross(direction, along);
    const double place = std::clamp(share, 0.0, 1.0);
    if (!(std::abs(share - place) <= kSlackOfPlace)) return;
    offer(place, 0, 1, [&](double ahead) { return Point{start.x + ahead * along.x, start.y + ahead * along.y}; });
  }

  /// The least distance from a circle along a curve.
  double clearanceOf(const EdgeCurve& curve, bool isEdge, CircleIndex circle) const {
    if (isEdge) return distanceFrom(diagram_, circle, pointAt(curve.bisector, std::clamp(1.0, curve.from, curve.to)));
    const Vector along = vectorTo(curve.start, curve.end);
    const double size = lengthOf(along);
    const double share =
        std::clamp(dot(measuredIn(size, along), vectorTo(curve.start, centerOf(circle))) / size, 0.0, 1.0);
    return distanceFrom(diagram_, circle, {curve.start.x + share * along.x, curve.start.y + share * along.y});
  }

  void add(const EdgeCurve& curve, EdgeIndex edge, double clearance) {
    const std::array<std::size_t, 2> nodes = {nodeOf(curve.start), nodeOf(curve.end)};
    for (const std::size_t node : nodes) linksOf_[node].push_back(links_.size());
    links_.push_back({nodes, curve, edge, clearance, arcLength(curve)});
  }

  std::size_t nodeOf(Point p) {
    const auto [known, isNew] = nodes_.try_emplace({p.x, p.y}, nodes_.size());
    if (isNew) linksOf_.emplace_back();
    return known->second;
  }

  struct Best {
    std::vector<double> keys;
    std::vector<std::size_t> by;
  };

  /// For each node the largest key of a path from the start, and the last link of this path (Dijkstra).
  template <class KeyAlong>
  Best best(std::size_t start, double key, KeyAlong keyAlong) const {
    Best result = {std::vector<double>(linksOf_.size(), -kInfinite), std::vector<std::size_t>(linksOf_.size())};
    std::priority_queue<std::pair<double, std::size_t>> pending;
    result.keys[start] = key;
    pending.emplace(key, start);
    while (!pending.empty()) {
      const auto [here, node] = pending.top();
      pending.pop();
      if (here < result.keys[node]) continue;
      for (const std::size_t index : linksOf_[node]) {
        const PathLink& link = links_[index];
        const std::size_t next = link.nodes[link.nodes[0] == node ? 1 : 0];
        const double there = keyAlong(here, link);
        if (!(there > result.keys[next])) continue;
        result.keys[next] = there;
        result.by[next] = index;
        pending.emplace(there, next);
      }
    }
    return result;
  }

  const Diagram& diagram_;
  std::vector<PathPiece> pieces_;
  std::vector<std::vector<std::size_t>> ofCell_;
  std::map<std::pair<double, double>, std::size_t> nodes_;
  std::vector<PathLink> links_;
  std::vector<std::vector<std::size_t>> linksOf_;
};

Error outside(const char* which) {
  return {ErrorCode::badOption, kNone, std::string("The ") + which + " of the path lies outside the region."};
}

}  // namespace

// To move straight away from the nearest center never loses clearance. It leads to an edge or to the boundary. So a
// path along edges and boundary is as clear as any, with one exception: where the ray from the center passes a corner
// that reaches into the cell, the place that it leads to jumps. There the path may follow the ray.
Result<std::optional<ClearestPath>> clearestPath(const Diagram& diagram, Point p, Point q, const Region& region) {
  return guarded([&]() -> Result<std::optional<ClearestPath>> {
    if (diagram.metric != Metric::circles || diagram.circles.empty()) {
      return Error{ErrorCode::badOption, kNone, "A clearest path takes a diagram of one circle or more."};
    }
    if (!region.contains(p)) return outside("start");
    if (!region.contains(q)) return outside("end");
    auto clipped = ClippedDiagram::from(diagram, region);
    if (!clipped) return clipped.error();
    PathGraph graph(diagram, *clipped);
    const Finder finder(diagram);
    const CircleIndex fromCircle = finder.find(p);
    const CircleIndex toCircle = finder.find(q);
    const auto entry = graph.shoot(fromCircle, p, -kSlackOfPlace);
    const auto exit = graph.shoot(toCircle, q, -kSlackOfPlace);
    if (!entry || !exit) return std::optional<ClearestPath>();
    graph.link();
    const auto route = graph.route(*entry, *exit);
    if (!route) return std::optional<ClearestPath>();
    ClearestPath path;
    path.clearance = std::min(distanceFrom(diagram, fromCircle, p), distanceFrom(diagram, toCircle, q));
    path.entry = *entry;
    path.exit = *exit;
    if (p != *entry) path.curves.push_back(segment(p, *entry));
    for (const PathLink& link : *route) {
      path.clearance = std::min(path.clearance, link.clearance);
      path.curves.push_back(link.curve);
      if (link.edge != kNone) path.edges.push_back(link.edge);
    }
    if (q != *exit) path.curves.push_back(segment(*exit, q));
    return std::optional<ClearestPath>(std::move(path));
  });
}

}  // namespace circle_voronoi
