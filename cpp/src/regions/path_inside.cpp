// SPDX-License-Identifier: GPL-3.0-or-later
//
// Moving straight away from the nearest center never loses clearance, and it leads to an edge or to the boundary. So a
// path along edges and boundary is as clear as any, with one exception: where the ray from the center passes a corner
// that reaches into the cell, its end jumps. There the path may follow the ray.
//
// The graph of these paths is that of the clip: vertices, crossings and corners, linked by arcs and by parts of sides.
// Exact signs decide all that depends on the region, as if the region and the ends of the path were moved by a tiny
// shift (shifted_signs.h): which crossings and corners follow each other, which side a ray meets first, and between
// which crossings of an edge it ends. Rounding only decides what leads to the same result up to rounding: whether a ray
// ends on a side of the region or on the edge next to it, and where on the side.
#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <utility>
#include <vector>

#include "at.h"
#include "circle_voronoi/cells.h"
#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/finder.h"
#include "circle_voronoi/limits.h"
#include "circle_voronoi/region_queries.h"
#include "clip_parts.h"
#include "guarded.h"
#include "line_crossing.h"
#include "ray_sweep.h"
#include "refuse_clip.h"
#include "rounded.h"
#include "scale.h"
#include "sectors.h"
#include "sort_unique.h"
#include "with_key.h"

namespace circle_voronoi {
namespace {

/// A ray that leaves its cell within this share of the lengths around it before it meets a side ends on the side.
constexpr double kNearSide = 0x1p-40;
/// Parameters with a larger quotient belong to points in this order.
constexpr double kFarApart = 1 + 0x1p-20;

/// A place on a piece where a ray ends or a corner touches: a parameter of an edge, or a share of a side.
struct Stop {
  double place;
  std::size_t node;
};

/// A part of an edge in its direction, or a part of a side of the region in one cell.
struct PathPiece {
  std::int32_t edge;
  std::int32_t arc;   ///< for an edge that the boundary crosses, in Arcs::all()
  std::int32_t side;  ///< kNone for an edge
  CircleIndex cell;
  Stop start;
  Stop end;
  std::vector<Stop> stops = {};
};

/// A link from one node to another.
struct PathLink {
  std::array<std::size_t, 2> nodes;
  EdgeCurve curve;
  std::int32_t edge;  ///< kNone if the link is straight
  double clearance = 0;
  double length = 0;
  bool isRay = false;
};

class PathGraph {
 public:
  PathGraph(const ClipParts& parts, Point from, Point to)
      : parts_(parts), diagram_(parts.diagram), signs_(diagram_), given_{from, to} {
    addNodes();
    addEdges();
    addSides();
    castRays();
    for (const PathPiece& piece : pieces_) addLinks(piece);
    connect();
  }

  double clearanceAtEnd(std::size_t end) const { return distanceFrom(diagram_, cells_[end], given_[end]); }

  /// Returns the shortest of the clearest paths between the given points.
  std::optional<std::vector<PathLink>> route() const {
    const auto [start, goal] = ends_;
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
  Point centerOf(CircleIndex circle) const { return {diagram_.circles[at(circle)].x, diagram_.circles[at(circle)].y}; }

  std::size_t vertexNode(VertexIndex vertex) const { return at(vertex); }
  std::size_t crossingNode(std::int32_t crossing) const { return diagram_.vertices.size() + at(crossing); }
  std::size_t cornerNode(RegionSideIndex corner) const { return cornerNodes_[at(corner)]; }
  std::size_t addNode(Point p) {
    points_.push_back(p);
    return points_.size() - 1;
  }

  /// Corners where rings touch are one node.
  void addNodes() {
    for (const Vertex& v : diagram_.vertices) points_.push_back({v.x, v.y});
    for (const Crossing& crossing : parts_.crossings.all) points_.push_back(crossing.point);
    std::vector<std::int32_t> order;
    for (std::size_t k = 0; k < parts_.region.sideCount(); ++k) order.push_back(static_cast<std::int32_t>(k));
    const auto pointOf = [&](std::int32_t corner) { return parts_.pointOf(corner); };
    std::ranges::sort(order, {}, [&](std::int32_t corner) { return std::pair(pointOf(corner).x, pointOf(corner).y); });
    cornerNodes_.resize(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
      const Point p = pointOf(order[k]);
      cornerNodes_[at(order[k])] = k > 0 && p == pointOf(order[k - 1]) ? points_.size() - 1 : addNode(p);
    }
  }

  void addEdges() {
    const auto arcs = parts_.arcs.all();
    const auto endOf = [&](std::int32_t crossing, VertexIndex vertex, double place) {
      if (crossing == kNone) return Stop{place, vertexNode(vertex)};
      return Stop{parts_.crossings.all[at(crossing)].parameter, crossingNode(crossing)};
    };
    for (std::size_t k = 0; k < arcs.size(); ++k) {
      const Edge& edge = diagram_.edges[at(arcs[k].edge)];
      const EdgeCurve curve = parts_.curveOf(arcs[k]);
      pieces_.push_back({arcs[k].edge, static_cast<std::int32_t>(k), kNone, edge.left,
                         endOf(arcs[k].start, edge.start, curve.from), endOf(arcs[k].end, edge.end, curve.to)});
    }
    wholeEdges_.assign(diagram_.edges.size(), kNone);
    for (std::size_t e = 0; e < diagram_.edges.size(); ++e) {
      const EdgeIndex index = static_cast<std::int32_t>(e);
      if (parts_.arcs.isCrossed(index) || !parts_.isInside(index)) continue;
      const Edge& edge = diagram_.edges[e];
      const EdgeCurve curve = parts_.curveOf(index);
      wholeEdges_[e] = static_cast<std::int32_t>(pieces_.size());
      pieces_.push_back(
          {index, kNone, kNone, edge.left, {curve.from, vertexNode(edge.start)}, {curve.to, vertexNode(edge.end)}});
    }
  }

  /// The share of the way along a side, from its first corner.
  double shareOf(const Crossing& crossing) const {
    const Point from = parts_.pointOf(crossing.side);
    const Point to = parts_.pointOf(parts_.sideAfter(crossing.side));
    const bool isForward = from.x < to.x || (from.x == to.x && from.y < to.y);
    return isForward ? crossing.share : 1 - crossing.share;
  }

  void addSides() {
    const auto& crossings = parts_.crossings;
    const auto add = [&](CircleIndex cell, RegionSideIndex side, Stop start, Stop end) {
      ofCells_.push_back({cell, side, pieces_.size()});
      pieces_.push_back({kNone, kNone, side, cell, start, end});
    };
    for (std::size_t c = 0; c < crossings.all.size(); ++c) {
      const CircleIndex cell = parts_.cellAfter(crossings.all[c]);
      const auto stretch = parts_.stretchFrom(static_cast<std::int32_t>(c));
      Stop start = {shareOf(crossings.all[c]), crossingNode(stretch.from)};
      parts_.visitCorners(stretch, [&](RegionSideIndex side) {
        const RegionSideIndex corner = parts_.sideAfter(side);
        corners_.push_back({cell, corner});
        add(cell, side, start, {1, cornerNode(corner)});
        start = {0, cornerNode(corner)};
      });
      const Crossing& end = crossings.all[at(stretch.to)];
      add(cell, end.side, start, {shareOf(end), crossingNode(stretch.to)});
    }
    for (const auto& [cell, ring] : crossings.rings) {
      for (std::int32_t k = parts_.region.ringOffsets()[at(ring)]; k < parts_.region.ringOffsets()[at(ring) + 1]; ++k) {
        corners_.push_back({cell, k});
        add(cell, k, {0, cornerNode(k)}, {1, cornerNode(parts_.sideAfter(k))});
      }
    }
    std::ranges::stable_sort(corners_, {}, &Corner::cell);
    // Along each side in its direction.
    std::ranges::stable_sort(ofCells_, {}, [&](const SidePiece& piece) {
      return std::tuple(std::int32_t{piece.cell}, std::int32_t{piece.side}, pieces_[piece.piece].start.place);
    });
  }

  void castRays() {
    const Finder finder(diagram_);
    RaySweep sweep(parts_.region, signs_);
    Sectors sectors(diagram_, signs_);
    for (std::size_t k = 0; k < 2; ++k) {
      sectors.setCellWith(given_[k], finder.find(given_[k]));
      cells_[k] = sectors.cell();
    }
    std::vector<CircleIndex> cells(cells_.begin(), cells_.end());
    for (const Corner& corner : corners_) {
      if (cells.back() != corner.cell) cells.push_back(corner.cell);
    }
    sortUnique(cells);
    std::vector<RegionSideIndex> sides;
    std::vector<RegionSideIndex> corners;
    for (const CircleIndex cell : cells) {
      sides.clear();
      corners.clear();
      for (const SidePiece& piece : withKey(ofCells_, cell, &SidePiece::cell)) {
        if (sides.empty() || sides.back() != piece.side) sides.push_back(piece.side);
      }
      for (const Corner& corner : withKey(corners_, cell, &Corner::cell)) corners.push_back(corner.corner);
      std::vector<Point> given;
      std::vector<std::size_t> whose;
      for (std::size_t k = 0; k < 2; ++k) {
        if (cells_[k] != cell) continue;
        given.push_back(given_[k]);
        whose.push_back(k);
      }
      sectors.setCell(cell);
      Sectors::Sector sector;
      sweep.run(cell, centerOf(cell), sides, corners, given, [&](const RayPlace& place) {
        const std::size_t node = place.corners.empty() ? addNode(place.point) : cornerNode(place.corners.front());
        for (const RegionSideIndex side : place.touching) {
          const Point from = parts_.pointOf(side);
          const Point to = parts_.pointOf(parts_.sideAfter(side));
          const Vector along = vectorTo(from, to);
          const double share = largestOf(along) == std::abs(along.x) ? (place.point.x - from.x) / along.x
                                                                     : (place.point.y - from.y) / along.y;
          const std::size_t met = stopOnSide(cell, side, share, place.point, node);
          if (met != node) addStraight(cell, node, met);
        }
        for (const std::int32_t k : place.given) ends_[whose[at(k)]] = node;
        if (!place.goesOn || !(place.isJump || !place.given.empty())) return;
        std::optional<SideIndex> exit;
        if (!sectors.sides().empty()) {
          sector = sectors.find(place.point, sector);
          if (sector.part <= Sectors::Sector::Part::afterApex) exit = sectors.sides()[sector.side];
        }
        cast(cell, place, node, exit);
      });
    }
  }

  /// Follows a ray to the first side, or to the edge across which it leaves the cell.
  void cast(CircleIndex cell, const RayPlace& place, std::size_t node, std::optional<SideIndex> exit) {
    if (place.first != kNone) {
      const Point from = parts_.pointOf(place.first);
      const Point to = parts_.pointOf(parts_.sideAfter(place.first));
      const double share = std::clamp(signs_.shareOnRay(cell, place.point, {from, to}), 0.0, 1.0);
      const Point end = {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
      if (!exit || !leavesBefore(end, *exit)) {
        addRay(cell, node, stopOnSide(cell, place.first, share, end, std::nullopt));
        return;
      }
    }
    if (!exit) refuseClip("A ray inside the region has no end.");
    addRay(cell, node, stopOnEdge(cell, place.point, *exit));
  }

  /// Returns whether a ray certainly leaves a cell across a side before it comes to a point.
  bool leavesBefore(Point p, SideIndex side) const {
    const CircleIndex own = diagram_.circleOf(side);
    const CircleIndex other = diagram_.neighborOf(side);
    const double size = largestOf(vectorTo(centerOf(own), p)) + largestOf(vectorTo(centerOf(other), p)) +
                        std::abs(p.x) + std::abs(p.y) +
                        std::abs(diagram_.circles[at(own)].r - diagram_.circles[at(other)].r);
    return distanceDifference(diagram_, own, other, p) < -kNearSide * size;
  }

  /// Returns a node on a side in a cell: a new one, or `node` if that is given.
  std::size_t stopOnSide(CircleIndex cell, RegionSideIndex side, double share, Point p,
                         std::optional<std::size_t> node) {
    const auto pieces =
        withKey(ofCells_, std::pair(std::int32_t{cell}, std::int32_t{side}),
                [](const SidePiece& piece) { return std::pair(std::int32_t{piece.cell}, std::int32_t{piece.side}); });
    if (pieces.empty()) refuseClip("A ray ends on a side of the region outside its cell.");
    // The piece with the place, or the nearest one.
    auto found = std::ranges::partition_point(
        pieces, [&](const SidePiece& its) { return pieces_[its.piece].end.place < share; });
    if (found == pieces.end()) --found;
    if (found != pieces.begin() && pieces_[found->piece].start.place > share) {
      const auto last = found - 1;
      if (share - pieces_[last->piece].end.place < pieces_[found->piece].start.place - share) found = last;
    }
    PathPiece& piece = pieces_[found->piece];
    if (share <= piece.start.place) return piece.start.node;
    if (share >= piece.end.place) return piece.end.node;
    const std::size_t stop = node ? *node : addNode(p);
    piece.stops.push_back({share, stop});
    return stop;
  }

  /// Returns the node where the ray from the center of a cell through a place leaves it across a side.
  std::size_t stopOnEdge(CircleIndex cell, Point through, SideIndex side) {
    const EdgeIndex edge = Diagram::edgeOf(side);
    const EdgeCurve whole = parts_.curveOf(edge);
    const double parameter = exitParameter(cell, through, whole);
    const bool isForward = side % 2 == 0;
    PathPiece* piece = nullptr;
    if (wholeEdges_[at(edge)] != kNone) {
      piece = &pieces_[at(wholeEdges_[at(edge)])];
    } else {
      if (!parts_.arcs.isCrossed(edge) || parts_.arcs.of(edge).empty()) refuseClip("A ray ends outside the region.");
      const auto arcs = parts_.arcs.of(edge);
      // The first arc, in the direction of the edge, that does not end before the ray.
      auto found = std::ranges::partition_point(arcs, [&](const Arc& arc) {
        return arc.end != kNone && isBefore(cell, through, arc.end, parameter, isForward);
      });
      if (found == arcs.end()) --found;
      piece = &pieces_[static_cast<std::size_t>(&*found - parts_.arcs.all().data())];
    }
    if (parameter <= piece->start.place) return piece->start.node;
    if (parameter >= piece->end.place) return piece->end.node;
    const std::size_t stop = addNode(pointAt(whole.bisector, parameter));
    piece->stops.push_back({parameter, stop});
    return stop;
  }

  /// Returns whether a crossing of an edge comes before a ray, in the direction of the edge. The ray meets the edge at
  /// a parameter, and the edge goes counter-clockwise around the center of the ray if `isForward`.
  bool isBefore(CircleIndex cell, Point through, std::int32_t index, double parameter, bool isForward) const {
    const Crossing& crossing = parts_.crossings.all[at(index)];
    if (crossing.parameter * kFarApart < parameter) return true;
    if (parameter * kFarApart < crossing.parameter) return false;
    const Edge& edge = diagram_.edges[at(crossing.edge)];
    const auto& [from, to] = crossing.isEntry ? std::pair(edge.left, edge.right) : std::pair(edge.right, edge.left);
    const ShiftedSigns::Line line = {parts_.pointOf(crossing.side), parts_.pointOf(parts_.sideAfter(crossing.side))};
    const int turn = signs_.turnFromRay(cell, through, from, to, line);
    return isForward ? turn < 0 : turn > 0;
  }

  double exitParameter(CircleIndex cell, Point through, const EdgeCurve& curve) const {
    const Point center = centerOf(cell);
    const Vector toPoint = vectorTo(center, through);
    const double size = largestOf(toPoint);
    const Vector direction = size == 0 ? Vector{1, 0} : measuredIn(powerOfTwoIn(size), toPoint);
    double least = kInfinite;
    double parameter = std::clamp(1.0, curve.from, curve.to);
    const LineCrossing ray(curve.bisector, center, direction);
    for (const double s : ray.parameters()) {
      if (!(facing(direction, vectorTo(center, pointAt(curve.bisector, s))) > 0)) continue;
      const double miss = s < curve.from ? curve.from / s : s > curve.to ? s / curve.to : 1;
      if (miss >= least) continue;
      least = miss;
      parameter = std::clamp(s, curve.from, curve.to);
    }
    return parameter;
  }

  void addLinks(const PathPiece& piece) {
    std::vector<Stop> stops = piece.stops;
    std::ranges::stable_sort(stops, {}, &Stop::place);
    stops.push_back(piece.end);
    Stop last = piece.start;
    for (const Stop& next : stops) {
      if (piece.side != kNone) {
        addStraight(piece.cell, last.node, next.node);
      } else {
        EdgeCurve part = piece.arc == kNone ? parts_.curveOf(EdgeIndex(piece.edge))
                                            : parts_.curveOf(parts_.arcs.all()[at(piece.arc)]);
        if (last.node != piece.start.node) part.from = last.place;
        if (next.node != piece.end.node) part.to = next.place;
        part.start = points_[last.node];
        part.end = points_[next.node];
        const Point lowest = pointAt(part.bisector, std::clamp(1.0, part.from, part.to));
        links_.push_back({{last.node, next.node},
                          part,
                          piece.edge,
                          distanceFrom(diagram_, piece.cell, lowest),
                          part.start == part.end ? 0 : arcLength(part)});
      }
      last = next;
    }
  }

  /// Adds a segment in a cell.
  void addStraight(CircleIndex cell, std::size_t from, std::size_t to) {
    const Point start = points_[from];
    const Point end = points_[to];
    if (start == end) {
      EdgeCurve curve;
      curve.start = curve.end = start;
      links_.push_back({{from, to}, curve, kNone, distanceFrom(diagram_, cell, start), 0});
      return;
    }
    const EdgeCurve curve = segment(start, end);
    const Vector along = vectorTo(start, end);
    const double size = lengthOf(along);
    const double share = std::clamp(dot(measuredIn(size, along), vectorTo(start, centerOf(cell))) / size, 0.0, 1.0);
    const Point nearest = {start.x + share * along.x, start.y + share * along.y};
    links_.push_back({{from, to}, curve, kNone, distanceFrom(diagram_, cell, nearest), size});
  }

  void addRay(CircleIndex cell, std::size_t from, std::size_t to) {
    addStraight(cell, from, to);
    links_.back().isRay = true;
  }

  void connect() {
    offsets_.assign(points_.size() + 1, 0);
    for (const PathLink& link : links_) {
      for (const std::size_t node : link.nodes) ++offsets_[node + 1];
    }
    for (std::size_t k = 0; k < points_.size(); ++k) offsets_[k + 1] += offsets_[k];
    linksOf_.resize(2 * links_.size());
    std::vector<std::size_t> next(offsets_.begin(), offsets_.end() - 1);
    for (std::size_t k = 0; k < links_.size(); ++k) {
      for (const std::size_t node : links_[k].nodes) linksOf_[next[node]++] = k;
    }
  }

  struct Best {
    std::vector<double> keys;
    std::vector<std::size_t> by;
  };

  /// For each node the largest key of a path from the start, and the last link of this path (Dijkstra).
  template <class KeyAlong>
  Best best(std::size_t start, double key, KeyAlong keyAlong) const;

  struct SidePiece {
    CircleIndex cell;
    RegionSideIndex side;
    std::size_t piece;
  };
  struct Corner {
    CircleIndex cell;
    RegionSideIndex corner;
  };

  const ClipParts& parts_;
  const Diagram& diagram_;
  ShiftedSigns signs_;
  std::array<Point, 2> given_;
  std::array<CircleIndex, 2> cells_;
  std::array<std::size_t, 2> ends_ = {};
  std::vector<Point> points_;  ///< of the nodes: vertices, crossings, corners, and where rays end
  std::vector<std::size_t> cornerNodes_;
  std::vector<PathPiece> pieces_;  ///< those of Arcs::all() first
  std::vector<std::int32_t> wholeEdges_;
  std::vector<SidePiece> ofCells_;
  std::vector<Corner> corners_;
  std::vector<PathLink> links_;
  std::vector<std::size_t> offsets_;  ///< for each node where its links begin in linksOf_
  std::vector<std::size_t> linksOf_;
};

template <class KeyAlong>
PathGraph::Best PathGraph::best(std::size_t start, double key, KeyAlong keyAlong) const {
  Best result = {std::vector<double>(points_.size(), -kInfinite), std::vector<std::size_t>(points_.size())};
  std::priority_queue<std::pair<double, std::size_t>> pending;
  result.keys[start] = key;
  pending.emplace(key, start);
  while (!pending.empty()) {
    const auto [here, node] = pending.top();
    pending.pop();
    if (here < result.keys[node]) continue;
    for (std::size_t k = offsets_[node]; k < offsets_[node + 1]; ++k) {
      const PathLink& link = links_[linksOf_[k]];
      const std::size_t other = link.nodes[link.nodes[0] == node ? 1 : 0];
      const double there = keyAlong(here, link);
      if (!(there > result.keys[other])) continue;
      result.keys[other] = there;
      result.by[other] = linksOf_[k];
      pending.emplace(there, other);
    }
  }
  return result;
}

Error outside(const char* which) {
  return {ErrorCode::badOption, kNone, std::string("The ") + which + " of the path lies outside the region."};
}

}  // namespace

Result<std::optional<ClearestPath>> clearestPath(const Diagram& diagram, Point p, Point q, const Region& region) {
  return guarded([&]() -> Result<std::optional<ClearestPath>> {
    if (diagram.metric != Metric::circles || diagram.circles.empty()) {
      return Error{ErrorCode::badOption, kNone, "A clearest path takes a diagram of one circle or more."};
    }
    if (!region.contains(p)) return outside("start");
    if (!region.contains(q)) return outside("end");
    const auto clipped = ClippedDiagram::from(diagram, region);
    if (!clipped) return clipped.error();
    // Regions round points (limits.h).
    const Point from = rounded(p);
    const Point to = rounded(q);
    const PathGraph graph(ClipParts::of(*clipped), from, to);
    const auto route = graph.route();
    if (!route) return std::optional<ClearestPath>();
    ClearestPath path;
    path.clearance = std::min(graph.clearanceAtEnd(0), graph.clearanceAtEnd(1));
    path.entry = p;
    path.exit = q;
    std::int32_t last = kNone;
    for (const PathLink& link : *route) {
      path.clearance = std::min(path.clearance, link.clearance);
      if (link.edge != kNone && link.edge != last) path.edges.emplace_back(link.edge);
      last = link.edge;
      if (link.curve.start == link.curve.end) continue;
      path.curves.push_back(link.curve);
      path.curveEdges.emplace_back(link.edge);
    }
    if (!route->empty() && route->front().isRay) path.entry = route->front().curve.end;
    if (!route->empty() && route->back().isRay) path.exit = route->back().curve.start;
    if (!path.curves.empty()) {
      path.curves.front().start = p;
      path.curves.back().end = q;
    }
    return std::optional<ClearestPath>(std::move(path));
  });
}

}  // namespace circle_voronoi
