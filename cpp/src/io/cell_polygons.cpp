// SPDX-License-Identifier: GPL-3.0-or-later
#include "cell_polygons.h"

#include <algorithm>
#include <cmath>

#include "arc_measure.h"
#include "chord.h"
#include "circle_arc.h"
#include "near_vertices.h"
#include "scale.h"
#include "vectors.h"

namespace circle_voronoi {
namespace {

/// Enough to halve the turn of any arc, of less than a full turn, to less than half a turn around both foci.
constexpr int kMostHalvings = 8;
/// Of coordinates: far above rounding errors, far below what can be seen.
constexpr double kRoundingError = 0x1p-40;
/// Rounds in which edges take back the rounding of their points, which may then turn edges beside them; few need two.
constexpr int kMostRounds = 8;

std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }

Vector vectorTo(Point p, Point q) { return {q.x - p.x, q.y - p.y}; }

/// Whether the triangle p, q, r is counter-clockwise.
bool isLeftTurn(Point p, Point q, Point r) { return turn(vectorTo(p, q), vectorTo(p, r)) > 0; }

/// Whether the step from p to q turns around both foci of an arc, by less than half a turn.
bool turnsAround(Point left, Point right, Point p, Point q) {
  return isLeftTurn(left, p, q) && isLeftTurn(right, q, p);
}

/// Adds points of the arc until each step turns around both foci, by less than half a turn. A cell is star-shaped from
/// its circle's centre, so a polygon of such steps is, too, and does not cross itself.
void refine(std::vector<Point>& points, const EdgeCurve& curve) {
  const Bisector& bisector = curve.bisector;
  const auto isCoarse = [&](Point p, Point q) { return !turnsAround(bisector.left, bisector.right, p, q); };
  for (int i = 0; i < kMostHalvings; ++i) {
    if (std::ranges::adjacent_find(points, isCoarse) == points.end()) return;
    std::vector<Point> finer = {points.front()};
    for (std::size_t k = 1; k < points.size(); ++k) {
      const Point p = points[k - 1];
      const Point q = points[k];
      const double middle = std::sqrt(parameterAt(bisector, p)) * std::sqrt(parameterAt(bisector, q));
      if (isCoarse(p, q)) finer.push_back(pointAt(bisector, middle));
      finer.push_back(q);
    }
    points = std::move(finer);
  }
}

/// The points of an arc from `start` to `end`, which are its ends but for rounding.
std::vector<Point> pointsBetween(const EdgeCurve& curve, Point start, Point end, double tolerance) {
  if (start == end) return {start};
  std::vector<Point> points = polyline(curve, tolerance);
  if (!curve.isStraight()) refine(points, curve);
  points.front() = start;
  points.back() = end;
  return points;
}

/// Whether pointsBetween has none but the ends.
bool isOneStep(const EdgeCurve& curve, Point start, Point end, double tolerance) {
  if (start == end) return true;
  return isNearChord(curve, tolerance) &&
         turnsAround(curve.bisector.left, curve.bisector.right, curve.start, curve.end);
}

/// Whether the area of a counter-clockwise ring is more than what rounding of its points can make.
bool hasArea(const std::vector<Point>& ring) {
  if (ring.size() < 3) return false;
  double twice = 0;
  double length = 0;
  double size = 0;
  for (const Point& p : ring) size = std::max({size, std::abs(p.x), std::abs(p.y)});
  const double unit = unitFor(size);
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vector p = measuredIn(unit, vectorTo(ring.front(), ring[k]));
    const Vector q = measuredIn(unit, vectorTo(ring.front(), ring[(k + 1) % ring.size()]));
    twice += cross(p, q);
    length += std::abs(q.x - p.x) + std::abs(q.y - p.y);
  }
  return twice > kRoundingError * (size / unit) * length;
}

void addPoint(std::vector<Point>& ring, Point p) {
  if (ring.empty() || p != ring.back()) ring.push_back(p);
}

void closeRing(std::vector<Point>& ring) {
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
}

}  // namespace

CellPolygons::CellPolygons(const ExportFrame& frame) : frame_(frame) {
  const Diagram& diagram = frame.diagram;
  const std::vector<std::int32_t> firstHere = firstVerticesHere(diagram);
  places_.reserve(firstHere.size());
  for (const Vertex& vertex : diagram.vertices) places_.push_back({vertex.x, vertex.y});
  // Of those that are one point the least, by x and then y: it does not depend on the order of the vertices.
  const auto isLess = [](Point p, Point q) { return std::pair(p.x, p.y) < std::pair(q.x, q.y); };
  for (std::size_t v = 0; v < places_.size(); ++v) {
    Point& place = places_[index(firstHere[v])];
    if (isLess(places_[v], place)) place = places_[v];
  }
  for (std::size_t v = 0; v < places_.size(); ++v) places_[v] = places_[index(firstHere[v])];
  followEdges();
  roundPoints(firstHere);
}

void CellPolygons::followEdges() {
  const auto& edges = frame_.diagram.edges;
  isInside_.reserve(edges.size());
  arcs_.reserve(edges.size() + 1);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const EdgeCurve curve = edgeCurve(frame_.diagram, static_cast<std::int32_t>(e));
    isInside_.push_back(circle_voronoi::isInside(frame_, edges[e], curve));
    arcs_.push_back({inner_.size()});
    if (!isInside_.back() || curve.isStraight()) continue;
    arcs_.back().beyond = momentsOverChord(curve, curve.start, 1).area;
    const Point start = placeOf(edges[e].start);
    const Point end = placeOf(edges[e].end);
    if (isOneStep(curve, start, end, frame_.tolerance)) continue;
    const auto points = pointsBetween(curve, start, end, frame_.tolerance);
    if (points.size() > 2) inner_.insert(inner_.end(), points.begin() + 1, points.end() - 1);
  }
  arcs_.push_back({inner_.size()});
}

/// Rounds what only edges inside the box have, and takes it back for edges that it turns around: then each step still
/// turns around both foci, and polygons of such steps do not cross themselves.
void CellPolygons::roundPoints(const std::vector<std::int32_t>& firstHere) {
  const auto& edges = frame_.diagram.edges;
  const std::vector<Point> exactPlaces = places_;
  const std::vector<Point> exactInner = inner_;
  for (Point& p : places_) p = frame_.round(p);
  for (Point& p : inner_) p = frame_.round(p);
  // What is taken back is so for the first of the vertices that are one point.
  std::vector<bool> isRestored(places_.size(), false);
  const auto firstOf = [&](VertexIndex vertex) { return index(firstHere[index(vertex)]); };
  const auto restorePlace = [&](VertexIndex vertex) {
    if (vertex == kNone) return;
    places_[firstOf(vertex)] = exactPlaces[firstOf(vertex)];
    isRestored[firstOf(vertex)] = true;
  };
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (isInside_[e]) continue;
    restorePlace(edges[e].start);
    restorePlace(edges[e].end);
  }
  bool isDone = false;
  for (int round = 0; !isDone && round < kMostRounds; ++round) {
    isDone = true;
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (!isInside_[e]) continue;
      const std::size_t start = firstOf(edges[e].start);
      const std::size_t end = firstOf(edges[e].end);
      // After the first round only edges at a place that was taken back can have changed.
      if (round > 0 && !isRestored[start] && !isRestored[end]) continue;
      const Point from = places_[start];
      const Point to = places_[end];
      if (start == end || turnsRight(static_cast<std::int32_t>(e), from, to)) continue;
      restorePlace(edges[e].start);
      restorePlace(edges[e].end);
      bool isChanged = from != places_[start] || to != places_[end];
      for (std::size_t k = arcs_[e].firstInner; k < arcs_[e + 1].firstInner; ++k) {
        isChanged = isChanged || inner_[k] != exactInner[k];
        inner_[k] = exactInner[k];
      }
      isDone = isDone && !isChanged;
    }
  }
  if (!isDone) {
    places_ = exactPlaces;
    inner_ = exactInner;
  }
  for (std::size_t v = 0; v < places_.size(); ++v) places_[v] = places_[index(firstHere[v])];
}

/// Whether each step of an edge, as its points are now, turns around both foci and is farther from them than rounding
/// can move it.
bool CellPolygons::turnsRight(EdgeIndex edge, Point start, Point end) const {
  const Edge& ends = frame_.diagram.edges[index(edge)];
  const auto& circles = frame_.diagram.circles;
  const Point left = {circles[index(ends.left)].x, circles[index(ends.left)].y};
  const Point right = {circles[index(ends.right)].x, circles[index(ends.right)].y};
  Point p = start;
  const auto isFar = [&](Point q) {
    const double least = 2 * frame_.grid.error();
    const auto isBeyond = [&](Vector v) { return std::max(std::abs(v.x), std::abs(v.y)) > least; };
    return isBeyond(vectorTo(left, q)) && isBeyond(vectorTo(right, q));
  };
  const auto stepsTo = [&](Point q) {
    const bool isRight = isFar(p) && isFar(q) && turnsAround(left, right, p, q);
    p = q;
    return isRight;
  };
  return std::ranges::all_of(innerPoints(edge), stepsTo) && stepsTo(end);
}

/// What prefetchPoints, isWhole, area and rings ask for first.
void CellPolygons::prefetchEdges(CircleIndex circle) const {
  for (const SideIndex side : frame_.diagram.sides(circle)) {
    prefetch(frame_.diagram.edges, index(Diagram::edgeOf(side)));
    prefetch(arcs_, index(Diagram::edgeOf(side)));
  }
}

void CellPolygons::prefetchPoints(CircleIndex circle) const {
  for (const SideIndex side : frame_.diagram.sides(circle)) {
    prefetch(inner_, arcs_[index(Diagram::edgeOf(side))].firstInner);
    const VertexIndex vertex = frame_.diagram.originOf(side);
    if (vertex == kNone) continue;
    prefetch(places_, index(vertex));
    prefetch(frame_.diagram.vertices, index(vertex));
  }
}

bool CellPolygons::isWhole(CircleIndex circle) const {
  const auto sides = frame_.diagram.sides(circle);
  return !sides.empty() && std::ranges::all_of(sides, [&](SideIndex side) { return isInside(Diagram::edgeOf(side)); });
}

/// Adds the points of a side of an edge inside the box, but for the last.
template <class Add>
void CellPolygons::addSide(SideIndex side, Add add) const {
  add(placeOf(frame_.diagram.originOf(side)));
  const auto points = innerPoints(Diagram::edgeOf(side));
  if (side % 2 == 0) {
    std::for_each(points.begin(), points.end(), add);
  } else {
    std::for_each(points.rbegin(), points.rend(), add);
  }
}

CellPolygons::Ring CellPolygons::wholeRing(CircleIndex circle) const {
  Ring ring;
  const auto add = [&](Point p) { addPoint(ring, p); };
  for (const SideIndex side : frame_.diagram.sides(circle)) addSide(side, add);
  closeRing(ring);
  return ring;
}

/// Where an end of a part of an edge is drawn: in its vertex, if it is there but for rounding.
Point CellPolygons::drawn(VertexIndex vertex, Point end) const {
  if (vertex == kNone) return end;
  const Vertex& place = frame_.diagram.vertices[index(vertex)];
  const double distance = std::abs(end.x - place.x) + std::abs(end.y - place.y);
  const bool isThere = distance <= kRoundingError * std::max(std::abs(place.x), std::abs(place.y));
  return isThere ? placeOf(vertex) : end;
}

/// The points of a piece of an edge in the direction of the outline, the same bits from either side.
CellPolygons::Ring CellPolygons::pointsOf(const OutlinePiece& piece) const {
  if (isInside(Diagram::edgeOf(piece.side))) {
    Ring points;
    addSide(piece.side, [&](Point p) { points.push_back(p); });
    points.push_back(placeOf(frame_.diagram.targetOf(piece.side)));
    return points;
  }
  const EdgeCurve curve = edgeDirection(frame_.diagram, piece);
  const Edge& edge = frame_.diagram.edges[index(Diagram::edgeOf(piece.side))];
  Ring points = pointsBetween(curve, drawn(edge.start, curve.start), drawn(edge.end, curve.end), frame_.tolerance);
  if (piece.side % 2 == 1) std::ranges::reverse(points);
  return points;
}

std::vector<CellPolygons::Ring> CellPolygons::rings(CircleIndex circle) const {
  std::vector<Ring> rings;
  const auto keep = [&](Ring ring) {
    if (hasArea(ring)) rings.push_back(std::move(ring));
  };
  if (isWhole(circle)) {
    keep(wholeRing(circle));
    return rings;
  }
  for (const auto& loop : outline(frame_.diagram, circle, frame_.limits)) {
    Ring ring;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const OutlinePiece& piece = loop[k];
      if (piece.side != kNone) {
        for (const Point& p : pointsOf(piece)) addPoint(ring, p);
        continue;
      }
      // A corner of the box, or a point of the circle. Where an edge meets these, the edge says where.
      if (loop[k == 0 ? loop.size() - 1 : k - 1].side == kNone) addPoint(ring, piece.curve.start);
      if (!piece.isOnCircle()) continue;
      const auto points = polyline(circleArc(piece), frame_.tolerance);
      for (std::size_t i = 1; i + 1 < points.size(); ++i) addPoint(ring, frame_.round(points[i]));
    }
    closeRing(ring);
    keep(std::move(ring));
  }
  return rings;
}

std::vector<CellPolygons::Ring> CellPolygons::polylines(EdgeIndex edge) const {
  if (isInside(edge)) return {pointsOf({{}, 2 * edge, kNone})};
  std::vector<Ring> lines;
  for (const Part& part : keptParts(frame_.diagram, edge, frame_.limits)) {
    lines.push_back(pointsOf({part.curve, 2 * edge, kNone}));
  }
  return lines;
}

double CellPolygons::area(CircleIndex circle) const {
  if (isWhole(circle)) {
    const auto& vertices = frame_.diagram.vertices;
    const auto sides = frame_.diagram.sides(circle);
    const auto vertexAt = [&](SideIndex side) {
      const Vertex& vertex = vertices[index(frame_.diagram.originOf(side))];
      return Point{vertex.x, vertex.y};
    };
    const Point reference = vertexAt(sides.front());
    Vector last{};
    double sum = 0;
    for (const SideIndex side : sides) {
      const Vector next = vectorTo(reference, vertexAt(side));
      const double beyond = arcs_[index(Diagram::edgeOf(side))].beyond;
      sum += cross(last, next) / 2 + (side % 2 == 0 ? beyond : -beyond);
      last = next;
    }
    if (isSafe(sum) && sum > 0) return sum;
  }
  return circle_voronoi::area(outline(frame_.diagram, circle, frame_.limits));
}

}  // namespace circle_voronoi
