// SPDX-License-Identifier: GPL-3.0-or-later
#include "clip_polygons.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "at.h"
#include "circle_arc.h"
#include "clip_parts.h"
#include "disjoint_sets.h"
#include "distance_signs.h"
#include "flatten.h"
#include "in_circle.h"
#include "near_vertices.h"
#include "scale.h"
#include "sectors.h"
#include "shifted_signs.h"
#include "valid_polygons.h"
#include "with_key.h"

namespace circle_voronoi {
namespace {

/// Largest number of divisions of a chord for a corner. The last time it takes the corner itself.
constexpr int kMostDivisions = 60;
/// Points closer than this fraction of the lengths that they are computed from may be one point.
constexpr double kOnePlace = 0x1p-46;
/// But nothing is that is farther apart than this share of the region.
constexpr double kOneCorner = 0x1p-24;

/// The error bound of a point that is computed from a center.
double reachAt(Point p, Point center) {
  return kOnePlace * (lengthOf(vectorTo(center, p)) + std::abs(p.x) + std::abs(p.y));
}

std::pair<double, double> placeKey(Point p) { return {p.x, p.y}; }

Point centerOf(const Diagram& diagram, CircleIndex circle) {
  const Circle& c = diagram.circles[at(circle)];
  return {c.x, c.y};
}

/// Divides steps around a center that corners lie beyond until all corners are on the left of the steps. The steps go
/// counter-clockwise, and the corners lie inside the cell.
///
/// `Between` returns a point of the curve between two of its points, as near as possible to a corner beyond their step.
template <class Between>
class RoomMaker {
 public:
  RoomMaker(Point center, Between between) : between_(between), center_(center) {}

  std::vector<Point> run(const std::vector<Point>& points, std::vector<Point> corners) {
    std::erase(corners, center_);  // Each step has it on its left.
    // Around the center, from the start of the steps on.
    const Point start = points.front();
    const auto isInSecondHalf = [&](Point p) { return orientation(center_, start, p) < 0; };
    std::ranges::sort(corners, [&](Point p, Point q) {
      if (isInSecondHalf(p) != isInSecondHalf(q)) return isInSecondHalf(q);
      return orientation(center_, p, q) > 0;
    });
    result_ = {start};
    auto first = corners.begin();
    for (std::size_t k = 1; k < points.size(); ++k) {
      const auto isHere = [&](Point p) {
        return orientation(center_, points[k - 1], p) >= 0 && orientation(center_, p, points[k]) > 0;
      };
      // Each step turns by less than half a turn. Corners beyond the steps come last.
      const auto last = std::find_if_not(first, corners.end(), isHere);
      add(points[k - 1], points[k],
          std::span<const Point>(corners).subspan(static_cast<std::size_t>(first - corners.begin()),
                                                  static_cast<std::size_t>(last - first)),
          0);
      first = last;
    }
    return std::move(result_);
  }

 private:
  void add(Point from, Point to, std::span<const Point> corners, int depth) {
    const auto isBeyond = [&](Point p) { return p != from && p != to && orientation(from, to, p) <= 0; };
    const auto beyond = std::ranges::find_if(corners, isBeyond);
    if (beyond == corners.end()) {
      result_.push_back(to);
      return;
    }
    const Point middleCorner = isBeyond(corners[corners.size() / 2]) ? corners[corners.size() / 2] : *beyond;
    Point middle = between_(from, to, middleCorner);
    // Next to a corner the corner itself, so that rounding does not lead around it.
    const bool isAtCorner = lengthOf(vectorTo(middle, middleCorner)) <= reachAt(middle, center_);
    if (isAtCorner || depth >= kMostDivisions || middle == from || middle == to) middle = middleCorner;
    std::size_t split = 0;
    while (split < corners.size() && orientation(center_, middle, corners[split]) < 0) ++split;
    add(from, middle, corners.first(split), depth + 1);
    add(middle, to, corners.subspan(split), depth + 1);
  }

  Between between_;
  Point center_;
  std::vector<Point> result_;
};

/// A point of a bisector between two of its points, near a corner: on a straight one the corner itself.
Point betweenOnBisector(const Bisector& bisector, Point from, Point to, Point corner) {
  if (bisector.a == 0) return corner;
  const double fromParameter = parameterAt(bisector, from);
  const double toParameter = parameterAt(bisector, to);
  const double s = parameterAt(bisector, corner);
  const bool isBetween = std::min(fromParameter, toParameter) < s && s < std::max(fromParameter, toParameter);
  return pointAt(bisector, isBetween ? s : std::sqrt(fromParameter) * std::sqrt(toParameter));
}

}  // namespace

ClipFlattener::ClipFlattener(const ClippedDiagram& clipped, double tolerance)
    : clipped_(clipped),
      tolerance_(tolerance),
      firstHere_(firstVerticesHere(clipped.diagram(), ClipParts::of(clipped).scope.edges,
                                   ClipParts::of(clipped).scope.vertices)) {
  collectPlaces();
  collectCorners();
}

/// Regions may be smaller than the rounding of vertices.
double ClipFlattener::mostReach() const {
  const Box& box = ClipParts::of(clipped_).bounds;
  return kOneCorner * std::max(box.maxX - box.minX, box.maxY - box.minY);
}

void ClipFlattener::collectPlaces() {
  const auto& parts = ClipParts::of(clipped_);
  const Diagram& diagram = clipped_.diagram();
  const auto& crossings = parts.crossings.all;
  // Sets of places: corners next to crossings, then vertices, then crossings. A corner stands for the others, and a
  // vertex for crossings.
  const Chosen& vertices = parts.scope.vertices;
  std::vector<std::int32_t> cornersNearby;
  for (const Crossing& crossing : crossings) {
    cornersNearby.insert(cornersNearby.end(), {crossing.side, parts.sideAfter(crossing.side)});
  }
  const Chosen corners(std::move(cornersNearby));
  const std::size_t vertexCount = vertices.size();
  const std::size_t firstVertex = corners.size();
  const std::size_t firstCrossing = firstVertex + vertexCount;
  DisjointSets sets(firstCrossing + crossings.size());
  const auto join = [&](std::size_t a, std::size_t b) {
    sets.join(static_cast<std::int32_t>(a), static_cast<std::int32_t>(b));
  };
  const auto sizeOf = [](Vector v) { return std::abs(v.x) + std::abs(v.y); };
  const auto vertexAt = [&](VertexIndex v) { return Point{diagram.vertices[at(v)].x, diagram.vertices[at(v)].y}; };
  const auto reachOf = [&](VertexIndex v) {
    const Point p = vertexAt(v);
    double reach = sizeOf({p.x, p.y});
    for (const CircleIndex circle : diagram.vertexCircles[at(v)])
      reach += sizeOf(vectorTo(centerOf(diagram, circle), p));
    return kOnePlace * reach;
  };
  const double most = mostReach();
  const auto isNear = [&](Point p, Point q, double reach) { return sizeOf(vectorTo(p, q)) <= std::min(reach, most); };
  for (std::size_t v = 0; v < vertexCount; ++v) {
    const std::size_t first = at(firstHere_[v]);
    if (isNear(vertexAt(vertices[v]), vertexAt(vertices[first]), kInfinite)) join(firstVertex + v, firstVertex + first);
  }
  for (std::size_t c = 0; c < crossings.size(); ++c) {
    const Crossing& crossing = crossings[c];
    const Edge& edge = diagram.edges[at(crossing.edge)];
    const Point p = crossing.point;
    for (const VertexIndex v : {edge.start, edge.end}) {
      if (v != kNone && isNear(p, vertexAt(v), reachOf(v)))
        join(firstCrossing + c, firstVertex + at(vertices.rowOf(v)));
    }
    const double reach = kOnePlace * (sizeOf({p.x, p.y}) + sizeOf(vectorTo(centerOf(diagram, edge.left), p)));
    for (const RegionSideIndex corner : {crossing.side, parts.sideAfter(crossing.side)}) {
      if (isNear(p, parts.pointOf(corner), reach)) join(firstCrossing + c, at(corners.rowOf(corner)));
    }
  }
  const auto pointOfPlace = [&](std::size_t place) {
    if (place < firstVertex) return parts.pointOf(corners[place]);
    return place < firstCrossing ? vertexAt(vertices[place - firstVertex]) : crossings[place - firstCrossing].point;
  };
  const auto first = std::move(sets).representatives();
  for (std::size_t place = firstVertex; place < first.size(); ++place) {
    const Point p = pointOfPlace(place);
    const Point q = pointOfPlace(at(first[place]));
    if (p != q) places_.emplace_back(p, q);
  }
  std::ranges::sort(places_, {}, [](const auto& pair) { return placeKey(pair.first); });
}

Point ClipFlattener::placeOf(Point p) const {
  const auto found =
      std::ranges::lower_bound(places_, placeKey(p), {}, [](const auto& pair) { return placeKey(pair.first); });
  return found != places_.end() && found->first == p ? found->second : p;
}

void ClipFlattener::collectCorners() {
  const auto& parts = ClipParts::of(clipped_);
  const Diagram& diagram = clipped_.diagram();
  double clearance = 0;  // how far the last point is from the border of its cell, at least
  Point last;
  const ShiftedSigns signs(diagram);
  Sectors sectors(diagram, signs);
  const auto add = [&](CircleIndex cell, Point p) {
    if (parts.maxDistance) collectRimCorner(cell, p);
    clearance -= lengthOf(vectorTo(last, p));
    last = p;
    if (clearance > 2 * tolerance_) return;
    clearance = kInfinite;
    sectors.setCell(cell);
    // A corner on a straight edge becomes a point of the edge, where the outline of a cell touches itself.
    const double rounding =
        kOnePlace * (std::abs(p.x) + std::abs(p.y) + lengthOf(vectorTo(centerOf(diagram, cell), p)));
    sectors.visitSidesNear(p, std::max(rounding, tolerance_), [&](SideIndex side) {
      const CircleIndex neighbor = diagram.neighborOf(side);
      const double distance = distanceDifference(diagram, cell, neighbor, p) / 2;
      clearance = std::min(clearance, distance);
      const bool isStraight =
          diagram.metric != Metric::circles || diagram.circles[at(cell)].r == diagram.circles[at(neighbor)].r;
      if (distance > (isStraight ? rounding : tolerance_)) return;
      const EdgeIndex edge = Diagram::edgeOf(side);
      corners_.push_back({edge, cell, heightOn(edge, p), p});
    });
    if (sectors.hasManySides()) clearance = 0;  // of the sides nearby
  };
  for (const auto& [cell, crossing] : parts.allCrossings()) {
    clearance = 0;
    last = parts.crossings.all[at(crossing)].point;
    parts.visitCorners(parts.stretchFrom(crossing),
                       [&, own = cell](RegionSideIndex side) { add(own, parts.pointOf(parts.sideAfter(side))); });
  }
  for (const auto& [cell, ring] : parts.allRings()) {
    clearance = 0;
    last = parts.pointOf(parts.region.ringOffsets()[at(ring)]);
    for (std::int32_t k = parts.region.ringOffsets()[at(ring)]; k < parts.region.ringOffsets()[at(ring) + 1]; ++k) {
      add(cell, parts.pointOf(k));
    }
  }
  std::ranges::stable_sort(corners_, {}, [](const Corner& corner) { return corner.key(); });
  std::ranges::stable_sort(rimCorners_, {}, [](const RimCorner& corner) { return std::int32_t{corner.cell}; });
}

/// Keeps a corner if a chord of the rim may cut it off.
void ClipFlattener::collectRimCorner(CircleIndex cell, Point corner) {
  const Point center = centerOf(clipped_.diagram(), cell);
  const double radius = DistanceSigns(clipped_.diagram(), *clipped_.maxDistance()).radius(cell);
  const double reached = lengthOf(vectorTo(center, corner));
  const double rounding = reachAt(corner, center);
  const double depth = std::max(tolerance_, kFinestPolyline * radius) + rounding;
  if (reached < radius - depth || reached > radius + rounding) return;
  rimCorners_.push_back({cell, corner});
}

/// The position of a point along the bisector of an edge, seen across it. All points between an arc and its chord have
/// positions between the positions of its ends.
double ClipFlattener::heightOn(EdgeIndex edge, Point p) const {
  const Edge& ends = clipped_.diagram().edges[at(edge)];
  const Point left = centerOf(clipped_.diagram(), ends.left);
  return cross(vectorTo(left, centerOf(clipped_.diagram(), ends.right)), vectorTo(left, p));
}

std::span<const ClipFlattener::Corner> ClipFlattener::cornersOn(EdgeIndex edge, CircleIndex cell, double low,
                                                                double high) const {
  const auto key = [](const Corner& corner) { return corner.key(); };
  const auto first = std::ranges::lower_bound(corners_, Corner{edge, cell, low, {}}.key(), {}, key);
  const auto last = std::ranges::upper_bound(corners_, Corner{edge, cell, high, {}}.key(), {}, key);
  if (first >= last) return {};
  return std::span(corners_).subspan(static_cast<std::size_t>(first - corners_.begin()),
                                     static_cast<std::size_t>(last - first));
}

std::vector<Point> ClipFlattener::pointsOf(EdgeIndex edge, const EdgeCurve& part) const {
  const Point start = placeOf(part.start);
  const Point end = placeOf(part.end);
  if (start == end) return {start};
  std::vector<Point> points = pointsBetween(part, part.start, part.end, tolerance_);
  points.front() = start;
  points.back() = end;
  const Edge& ends = clipped_.diagram().edges[at(edge)];
  const auto [low, high] = std::minmax({heightOn(edge, part.start), heightOn(edge, part.end)});
  const double rounding = kOnePlace * std::max(std::abs(low), std::abs(high));
  for (const CircleIndex cell : {ends.left, ends.right}) {
    for (std::size_t k = 1; k + 1 < points.size(); ++k) {
      const Point p = points[k];
      const double reach = std::min(reachAt(p, part.bisector.origin), mostReach());
      const double height = heightOn(edge, p);
      const double slack = reach * lengthOf(vectorTo(part.bisector.left, part.bisector.right)) + rounding;
      for (const Corner& corner : cornersOn(edge, cell, height - slack, height + slack)) {
        if (lengthOf(vectorTo(p, corner.point)) <= reach) points[k] = corner.point;
      }
    }
  }
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() == 1) return points;
  for (const CircleIndex cell : {ends.left, ends.right}) {
    std::vector<Point> its;
    for (const Corner& corner : cornersOn(edge, cell, low - rounding, high + rounding)) its.push_back(corner.point);
    if (its.empty()) continue;
    if (cell == ends.right) std::ranges::reverse(points);
    const auto between = [&](Point from, Point to, Point corner) {
      return betweenOnBisector(part.bisector, from, to, corner);
    };
    points = RoomMaker(centerOf(clipped_.diagram(), cell), between).run(points, std::move(its));
    if (cell == ends.right) std::ranges::reverse(points);
  }
  return points;
}

std::vector<Point> ClipFlattener::pointsOf(const OutlinePiece& piece) const {
  EdgeCurve part = ClipParts::of(clipped_).curveOf(Diagram::edgeOf(piece.side));
  const bool isAlong = piece.side % 2 == 0;
  part.start = isAlong ? piece.curve.start : piece.curve.end;
  part.end = isAlong ? piece.curve.end : piece.curve.start;
  part.from = parameterAt(part.bisector, part.start);
  part.to = std::max(part.from, parameterAt(part.bisector, part.end));
  std::vector<Point> points = pointsOf(Diagram::edgeOf(piece.side), part);
  if (!isAlong) std::ranges::reverse(points);
  return points;
}

std::vector<Point> ClipFlattener::pointsOfArc(CircleIndex cell, const OutlinePiece& arc) const {
  std::vector<Point> points = polyline(circleArc(arc), tolerance_);
  const auto corners =
      withKey(rimCorners_, std::int32_t{cell}, [](const RimCorner& corner) { return std::int32_t{corner.cell}; });
  if (corners.empty()) return points;
  const Point center = centerOf(clipped_.diagram(), cell);
  std::vector<Point> its;
  for (const RimCorner& corner : corners) {
    const Point p = corner.point;
    if (orientation(center, points.front(), p) >= 0 && orientation(center, p, points.back()) >= 0) its.push_back(p);
  }
  if (its.empty()) return points;
  const auto onRim = [&](Point p) {
    const Vector v = vectorTo(center, p);
    const double share = arc.r / lengthOf(v);
    return Point{center.x + share * v.x, center.y + share * v.y};
  };
  return RoomMaker(center, [&](Point, Point, Point corner) { return onRim(corner); }).run(points, std::move(its));
}

ClippedPolygons clipPolygons(const ClippedDiagram& clipped, const Chosen& circles, double tolerance) {
  const ClipFlattener flattener(clipped, tolerance);
  ClippedPolygons result;
  for (std::size_t row = 0; row < circles.size(); ++row) {
    const Outline outline = clipped.outline(circles[row]);
    std::vector<PointLoop> loops;
    for (const auto& pieces : outline) {
      PointLoop& loop = loops.emplace_back();
      loop.isHole = &pieces != &outline.front() && area({pieces}) < 0;
      for (const OutlinePiece& piece : pieces) {
        if (piece.side == kNone && !piece.isOnCircle()) {
          loop.points.push_back(flattener.placeOf(piece.curve.start));
          continue;
        }
        const auto points = piece.isOnCircle() ? flattener.pointsOfArc(circles[row], piece) : flattener.pointsOf(piece);
        loop.points.insert(loop.points.end(), points.begin(), points.size() > 1 ? points.end() - 1 : points.end());
      }
    }
    for (const auto& polygon : validPolygons(std::move(loops))) {
      for (const PointRing& ring : polygon) {
        result.points.insert(result.points.end(), ring.begin(), ring.end());
        result.pointOffsets.push_back(static_cast<std::int32_t>(result.points.size()));
      }
      result.ringOffsets.push_back(static_cast<std::int32_t>(result.pointOffsets.size()) - 1);
    }
    result.polygonOffsets.push_back(static_cast<std::int32_t>(result.ringOffsets.size()) - 1);
  }
  return result;
}

}  // namespace circle_voronoi
