// SPDX-License-Identifier: GPL-3.0-or-later
#include "cell_polygons.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "at.h"
#include "flatten.h"
#include "ordered_sides.h"
#include "scale.h"
#include "vectors.h"

namespace circle_voronoi {
namespace {

/// As a share of coordinates: far above rounding errors, far below visible distances.
constexpr double kRoundingError = 0x1p-40;
/// The most rounds in which edges restore their unrounded points. Each round may reverse neighboring edges; few inputs
/// need two.
constexpr int kMostRounds = 8;

/// Whether the area of a counter-clockwise ring is more than what rounding of its points can make.
bool hasArea(const std::vector<Point>& ring) {
  if (ring.size() < 3) return false;
  double twice = 0;
  double length = 0;
  double size = 0;
  for (const Point& p : ring) size = std::max({size, std::abs(p.x), std::abs(p.y)});
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vector p = vectorTo(ring.front(), ring[k]);
    const Vector q = vectorTo(ring.front(), ring[(k + 1) % ring.size()]);
    twice += cross(p, q);
    length += std::abs(q.x - p.x) + std::abs(q.y - p.y);
  }
  return twice > kRoundingError * size * length;
}

/// Whether a ring neither crosses nor touches itself.
bool isSimple(const std::vector<Point>& ring) { return static_cast<bool>(Region::fromRings({{ring}})); }

void addPoint(std::vector<Point>& ring, Point p) {
  if (ring.empty() || p != ring.back()) ring.push_back(p);
}

void closeRing(std::vector<Point>& ring) {
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
}

/// Returns the point for each vertex. Vertices at one point share it.
std::vector<Point> sharedPlaces(const Diagram& diagram, const ClipFlattener& flattener) {
  std::vector<Point> places;
  places.reserve(diagram.vertices.size());
  for (const Vertex& vertex : diagram.vertices) places.push_back(flattener.placeOf({vertex.x, vertex.y}));
  return places;
}

void follow(const Edge& edge, const EdgeCurve& curve, EdgePoints& points) {
  if (curve.isStraight() || isOneStep(curve, points.frame.tolerance)) return;
  const auto all = pointsBetween(curve, points.placeOf(edge.start), points.placeOf(edge.end), points.frame.tolerance);
  if (all.size() > 2) points.inner.insert(points.inner.end(), all.begin() + 1, all.end() - 1);
}

}  // namespace

CellPolygons::CellPolygons(const ExportFrame& frame)
    : frame_(frame),
      flattener_(frame.clipped, frame.tolerance),
      points_(frame, sharedPlaces(frame.diagram, flattener_), follow) {
  roundPoints();
}

/// Rounds the points that belong only to edges inside the box, and with digits the others, too. Restores the points of
/// edges that rounding reverses. Then each step still turns around both foci, and polygons of such steps do not cross
/// themselves.
void CellPolygons::roundPoints() {
  const auto& edges = frame_.diagram.edges;
  auto& places = points_.places;
  auto& inner = points_.inner;
  const std::vector<Point> exactPlaces = places;
  const std::vector<Point> exactInner = inner;
  const bool isOnGrid = frame_.hasDigits && frame_.isBox;
  for (Point& p : places) p = isOnGrid ? frame_.roundOnBoundary(p) : frame_.round(p);
  for (Point& p : inner) p = frame_.round(p);
  // A restored place is recorded for the first of the vertices at one point.
  std::vector<bool> isRestored(places.size(), false);
  const auto firstOf = [&](VertexIndex vertex) { return at(flattener_.firstHere()[at(vertex)]); };
  const auto restorePlace = [&](VertexIndex vertex) {
    if (vertex == kNone) return;
    places[firstOf(vertex)] = exactPlaces[firstOf(vertex)];
    isRestored[firstOf(vertex)] = true;
  };
  isExact_.assign(edges.size(), !frame_.hasDigits || !frame_.isBox);
  const auto restoreEnds = [&](std::size_t edge) {
    isExact_[edge] = true;
    restorePlace(edges[edge].start);
    restorePlace(edges[edge].end);
  };
  const auto sharePlaces = [&] {
    for (std::size_t v = 0; v < places.size(); ++v) places[v] = places[at(flattener_.firstHere()[v])];
  };
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (!points_.isInside[e] && isExact_[e]) restoreEnds(e);
  }
  bool isDone = false;
  for (int round = 0; !isDone && round < kMostRounds; ++round) {
    isDone = true;
    if (frame_.hasDigits) {
      sharePlaces();
      for (const EdgeIndex e : wronglyRounded()) {
        restoreEnds(at(e));
        isDone = false;
      }
    }
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (!points_.isInside[e]) continue;
      const std::size_t start = firstOf(edges[e].start);
      const std::size_t end = firstOf(edges[e].end);
      // After the first round only edges at a restored point can have changed.
      if (round > 0 && !isRestored[start] && !isRestored[end]) continue;
      const Point from = places[start];
      const Point to = places[end];
      if (start == end || turnsRight(static_cast<std::int32_t>(e), from, to)) continue;
      restorePlace(edges[e].start);
      restorePlace(edges[e].end);
      bool isChanged = from != places[start] || to != places[end];
      for (std::size_t k = points_.firstInner[e]; k < points_.firstInner[e + 1]; ++k) {
        isChanged = isChanged || inner[k] != exactInner[k];
        inner[k] = exactInner[k];
      }
      isDone = isDone && !isChanged;
    }
  }
  if (!isDone) {
    places = exactPlaces;
    inner = exactInner;
    isExact_.assign(edges.size(), true);
  }
  sharePlaces();
}

/// Edges that are not inside the box and that rounding turns around, or moves beyond other parts of a cell.
std::vector<EdgeIndex> CellPolygons::wronglyRounded() const {
  std::vector<EdgeIndex> wrong;
  const auto count = static_cast<std::int32_t>(frame_.diagram.edges.size());
  for (EdgeIndex e = 0; e < count; ++e) {
    if (!isInside(e) && !isExact_[at(e)] && !partsTurnRight(e)) wrong.push_back(e);
  }
  // The boundary of a cell that is cut need not turn around its center.
  for (CircleIndex i = 0; i < circleCount(); ++i) {
    if (points_.isWhole(i)) continue;
    for (const auto& loop : frame_.clipped.outline(i)) {
      if (isSimple(ringOf(i, loop, true))) continue;
      for (const OutlinePiece& piece : loop) {
        if (piece.side == kNone) continue;
        const EdgeIndex edge = Diagram::edgeOf(piece.side);
        if (!isInside(edge) && !isExact_[at(edge)]) wrong.push_back(edge);
      }
    }
  }
  return wrong;
}

/// Whether each step turns around both foci of an edge and is farther from them than rounding can move it.
bool CellPolygons::turnsRight(EdgeIndex edge, std::span<const Point> points) const {
  const Edge& ends = frame_.diagram.edges[at(edge)];
  const auto& circles = frame_.diagram.circles;
  const Point left = {circles[at(ends.left)].x, circles[at(ends.left)].y};
  const Point right = {circles[at(ends.right)].x, circles[at(ends.right)].y};
  const auto isFar = [&](Point q) {
    const double least = 2 * frame_.grid.error();
    const auto isBeyond = [&](Vector v) { return std::max(std::abs(v.x), std::abs(v.y)) > least; };
    return isBeyond(vectorTo(left, q)) && isBeyond(vectorTo(right, q));
  };
  const auto isWrong = [&](Point p, Point q) { return !turnsAround(left, right, p, q); };
  return std::ranges::all_of(points, isFar) && std::ranges::adjacent_find(points, isWrong) == points.end();
}

/// Whether an edge inside the box turns right at its current points.
bool CellPolygons::turnsRight(EdgeIndex edge, Point start, Point end) const {
  const auto inner = points_.innerOf(edge);
  if (inner.empty()) return turnsRight(edge, std::array{start, end});
  std::vector<Point> points = {start};
  points.insert(points.end(), inner.begin(), inner.end());
  points.push_back(end);
  return turnsRight(edge, points);
}

/// Whether the parts of another edge turn right; they have to stay in the box.
bool CellPolygons::partsTurnRight(EdgeIndex edge) const {
  const auto isRight = [&](const EdgeCurve& part) {
    const Ring points = pointsOf({part, 2 * edge, kNone});
    const auto isIn = [&](Point p) { return frame_.hasInside(p); };
    return std::ranges::all_of(points, isIn) && turnsRight(edge, points);
  };
  return std::ranges::all_of(frame_.clipped.edgeParts(edge), isRight);
}

/// Adds the points of a side of an edge inside the box, but for the last.
template <class Add>
void CellPolygons::addSide(SideIndex side, Add add) const {
  add(placeOf(frame_.diagram.originOf(side)));
  points_.visitInner(side, [&](auto first, auto last) { std::for_each(first, last, add); });
}

/// Begins where the outline of the cell does, as all polygons.
CellPolygons::Ring CellPolygons::wholeRing(CircleIndex circle) const {
  Ring ring;
  const auto add = [&](Point p) { addPoint(ring, p); };
  std::vector<SideIndex> sides;
  orderedSides(frame_.diagram, circle, sides);
  for (const SideIndex side : sides) addSide(side, add);
  closeRing(ring);
  return ring;
}

/// Whether an end of a part of an edge is drawn in a vertex: if it is there but for rounding.
bool CellPolygons::isDrawnIn(VertexIndex vertex, Point end) const {
  if (vertex == kNone) return false;
  const Vertex& place = frame_.diagram.vertices[at(vertex)];
  const double distance = std::abs(end.x - place.x) + std::abs(end.y - place.y);
  return distance <= kRoundingError * std::max(std::abs(place.x), std::abs(place.y));
}

/// The points of a piece of an edge in the direction of the outline, the same bits from either side.
CellPolygons::Ring CellPolygons::pointsOf(const OutlinePiece& piece) const {
  const EdgeIndex edge = Diagram::edgeOf(piece.side);
  Ring points;
  if (isInside(edge)) {
    addSide(piece.side, [&](Point p) { points.push_back(p); });
    points.push_back(placeOf(frame_.diagram.targetOf(piece.side)));
    return points;
  }
  points = flattener_.pointsOf(piece);
  const auto draw = [&](Point& p, VertexIndex vertex, Point original) {
    if (isDrawnIn(vertex, original)) {
      p = placeOf(vertex);
    } else if (!isExact_[at(edge)]) {
      p = frame_.roundOnBoundary(p);
    }
  };
  draw(points.front(), frame_.diagram.originOf(piece.side), piece.curve.start);
  if (points.size() > 1) draw(points.back(), frame_.diagram.targetOf(piece.side), piece.curve.end);
  for (std::size_t k = 1; k + 1 < points.size(); ++k) draw(points[k], kNone, {});
  return points;
}

/// The points of arcs in a row around a circle, between two that are their ends but for rounding: rounded themselves
/// unless that turns a step around.
CellPolygons::Ring CellPolygons::pointsOfArcs(CircleIndex circle, std::span<const OutlinePiece> arcs, Point from,
                                              Point to, bool rounds) const {
  const auto isAhead = [&](Point p, Point q) { return isLeftTurn(centerOf(circle), p, q); };
  const auto isWrong = [&](Point p, Point q) { return p != q && !isAhead(p, q); };
  Ring exact = {from};
  std::size_t last = 0;  // where the last arc begins, of a quarter turn at most
  for (const OutlinePiece& arc : arcs) {
    const Ring points = flattener_.pointsOfArc(circle, arc);
    last = exact.size();
    exact.insert(exact.end(), points.begin() + (&arc == &arcs.front() ? 1 : 0), points.end() - 1);
  }
  exact.push_back(to);
  Ring points = exact;
  for (std::size_t k = 1; k + 1 < points.size(); ++k) points[k] = frame_.round(points[k]);
  if (!rounds || std::ranges::adjacent_find(points, isWrong) != points.end()) points = exact;
  Ring inner;
  for (std::size_t k = 1; k + 1 < points.size(); ++k) {
    const Point before = inner.empty() ? from : inner.back();
    if (isAhead(before, points[k]) && (k < last || isAhead(points[k], to))) inner.push_back(points[k]);
  }
  return inner;
}

/// Adds a loop of the outline of a cell. Points that belong to no edge are rounded if rounding is on.
CellPolygons::Ring CellPolygons::ringOf(CircleIndex circle, std::vector<OutlinePiece> loop, bool rounds) const {
  const auto isOnCircle = [](const OutlinePiece& piece) { return piece.isOnCircle(); };
  // Rotates the loop so that consecutive arcs stay together, unless all pieces are arcs.
  std::rotate(loop.begin(), std::find_if_not(loop.begin(), loop.end(), isOnCircle), loop.end());
  // The disc is hardly larger than the rounding of its points.
  if (loop.front().isOnCircle() && loop.front().r < 4 * frame_.grid.error()) rounds = false;
  const std::size_t count = loop.size();
  const auto before = [&](std::size_t k) { return (k + count - 1) % count; };
  const auto arcsFrom = [&](std::size_t first) {
    std::size_t last = first;
    while (last + 1 < count && loop[last + 1].isOnCircle()) ++last;
    return std::span<const OutlinePiece>(loop).subspan(first, last + 1 - first);
  };
  std::vector<Ring> pieces(count);
  for (std::size_t k = 0; k < count; ++k) {
    const bool goesOn = loop[k].isOnCircle() && loop[before(k)].isOnCircle() && k > 0;
    if (loop[k].side != kNone) {
      pieces[k] = pointsOf(loop[k]);
    } else if (loop[before(k)].side == kNone && !goesOn) {
      // A corner of the region, or a point of the circle. If an edge ends there, its end is used.
      const Point start = flattener_.placeOf(loop[k].curve.start);
      pieces[k] = {rounds ? frame_.roundOnBoundary(start) : start};
    }
  }
  Ring ring;
  for (std::size_t k = 0; k < count; ++k) {
    for (const Point& p : pieces[k]) addPoint(ring, p);
    if (!loop[k].isOnCircle()) continue;
    const std::span arcs = arcsFrom(k);
    const Point from = pieces[k].empty() ? pieces[before(k)].back() : pieces[k].front();
    const Point to = pieces[(k + arcs.size()) % count].front();
    for (const Point& p : pointsOfArcs(circle, arcs, from, to, rounds)) addPoint(ring, p);
    k += arcs.size() - 1;
  }
  closeRing(ring);
  // The ring begins where the loop does, whose first point may be the end of its last piece.
  if (!ring.empty() && pieces.front().empty()) std::rotate(ring.begin(), ring.end() - 1, ring.end());
  return ring;
}

std::vector<CellPolygons::Polygon> CellPolygons::polygons(CircleIndex circle) const {
  if (points_.isWhole(circle)) {
    Ring ring = wholeRing(circle);
    if (!hasArea(ring)) return {};
    return {{std::move(ring)}};
  }
  std::vector<PointLoop> loops;
  const Outline outline = frame_.clipped.outline(circle);
  for (const auto& loop : outline) {
    const bool isHole = &loop != &outline.front() && circle_voronoi::area({loop}) < 0;
    Ring ring = ringOf(circle, loop, frame_.isBox);
    if (frame_.isBox && !(hasArea(ring) && isSimple(ring))) ring = ringOf(circle, loop, false);
    loops.push_back({std::move(ring), isHole});
  }
  return validPolygons(std::move(loops));
}

std::vector<CellPolygons::Ring> CellPolygons::polylines(EdgeIndex edge) const {
  if (isInside(edge)) return {pointsOf({{}, 2 * edge, kNone})};
  std::vector<Ring> lines;
  for (const EdgeCurve& part : frame_.clipped.edgeParts(edge)) lines.push_back(pointsOf({part, 2 * edge, kNone}));
  return lines;
}

}  // namespace circle_voronoi
