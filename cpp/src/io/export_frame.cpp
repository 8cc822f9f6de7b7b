// SPDX-License-Identifier: GPL-3.0-or-later
#include "export_frame.h"

#include <algorithm>
#include <cmath>

#include "circle_voronoi/merged.h"

namespace circle_voronoi {
namespace {

constexpr double kMargin = 0.05;
constexpr double kTolerance = 1e-5;

/// Enough to halve the turn of any arc, of less than a full turn, to less than half a turn around both foci.
constexpr int kMostHalvings = 8;
/// Of coordinates: far above rounding errors, far below what can be seen.
constexpr double kRoundingError = 0x1p-40;

double sizeOf(const Box& box) { return std::max(box.maxX - box.minX, box.maxY - box.minY); }

std::vector<Point> placesOf(std::span<const Circle> circles, const Diagram& diagram) {
  const MergedDiagram merged = mergeVertices(circles, diagram);
  std::vector<Point> places;
  for (const std::int32_t v : merged.mergedVertex) {
    const Vertex& vertex = merged.vertices[static_cast<std::size_t>(v)];
    places.push_back({vertex.x, vertex.y});
  }
  return places;
}

/// Twice the area of the triangle p, q, r: positive if it is counter-clockwise.
double turn(Point p, Point q, Point r) { return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x); }

/// Adds points of the arc until each step turns around both foci, by less than half a turn. A cell is star-shaped from
/// its circle's centre, so a polygon of such steps is, too, and does not cross itself.
void refine(std::vector<Point>& points, const EdgeCurve& curve) {
  const Bisector& bisector = curve.bisector;
  for (int i = 0; i < kMostHalvings; ++i) {
    std::vector<Point> finer = {points.front()};
    for (std::size_t k = 1; k < points.size(); ++k) {
      const Point p = points[k - 1];
      const Point q = points[k];
      const bool turns = turn(bisector.left, p, q) > 0 && turn(bisector.right, q, p) > 0;
      if (!turns) finer.push_back(pointAt(bisector, std::sqrt(parameterAt(bisector, p) * parameterAt(bisector, q))));
      finer.push_back(q);
    }
    if (finer.size() == points.size()) return;
    points = std::move(finer);
  }
}

/// Where an end of a piece of an edge is drawn: in its vertex, if it is there but for rounding.
Point placeOf(const ExportFrame& frame, std::int32_t v, Point end) {
  if (v == kNone) return end;
  const Vertex& vertex = frame.cells.diagram().vertices[static_cast<std::size_t>(v)];
  const double distance = std::abs(end.x - vertex.x) + std::abs(end.y - vertex.y);
  const bool isThere = distance <= kRoundingError * std::max(std::abs(vertex.x), std::abs(vertex.y));
  return isThere ? frame.places[static_cast<std::size_t>(v)] : end;
}

/// The points of a piece of an edge in the direction of the outline, the same bits from either side.
std::vector<Point> pointsOf(const ExportFrame& frame, const OutlinePiece& piece) {
  const EdgeCurve curve = edgeDirection(frame.cells, piece);
  const Edge& edge = frame.cells.diagram().edges[static_cast<std::size_t>(piece.side / 2)];
  const Point start = placeOf(frame, edge.start, curve.start);
  const Point end = placeOf(frame, edge.end, curve.end);
  if (start == end) return {start};
  std::vector<Point> points = polyline(curve, frame.tolerance);
  if (!curve.isStraight()) refine(points, curve);
  points.front() = start;
  points.back() = end;
  if (isAgainstEdge(piece)) std::ranges::reverse(points);
  return points;
}

/// Whether the area of a counter-clockwise ring is more than what rounding of its points can make.
bool hasArea(const std::vector<Point>& ring) {
  if (ring.size() < 3) return false;
  double twice = 0;
  double length = 0;
  double size = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point p = ring[k];
    const Point q = ring[(k + 1) % ring.size()];
    twice += turn(ring.front(), p, q);
    length += std::abs(q.x - p.x) + std::abs(q.y - p.y);
    size = std::max({size, std::abs(p.x), std::abs(p.y)});
  }
  return twice > kRoundingError * size * length;
}

}  // namespace

Box exportBox(std::span<const Circle> circles) {
  if (circles.empty()) return {0, 0, 1, 1};
  const auto reach = [&](auto coordinate) { return std::ranges::max(circles, {}, coordinate); };
  const auto right = [](const Circle& c) { return c.x + c.r; };
  const auto left = [](const Circle& c) { return -(c.x - c.r); };
  const auto top = [](const Circle& c) { return c.y + c.r; };
  const auto bottom = [](const Circle& c) { return -(c.y - c.r); };
  Box box = {-left(reach(left)), -bottom(reach(bottom)), right(reach(right)), top(reach(top))};
  const double margin = sizeOf(box) > 0 ? kMargin * sizeOf(box) : 1;
  return {box.minX - margin, box.minY - margin, box.maxX + margin, box.maxY + margin};
}

ExportFrame::ExportFrame(std::span<const Circle> circles, const Diagram& diagram, const ExportOptions& options)
    : cells(circles, diagram),
      box(options.box ? *options.box : exportBox(circles)),
      tolerance(options.tolerance ? *options.tolerance : kTolerance * sizeOf(box)),
      places(placesOf(circles, diagram)) {}

EdgeCurve edgeDirection(const Cells& cells, const OutlinePiece& piece) {
  if (piece.side == kNone) return piece.curve;
  EdgeCurve curve = edgeCurve(cells.circles(), cells.diagram(), piece.side / 2, cells.metric());
  curve.start = isAgainstEdge(piece) ? piece.curve.end : piece.curve.start;
  curve.end = isAgainstEdge(piece) ? piece.curve.start : piece.curve.end;
  curve.from = parameterAt(curve.bisector, curve.start);
  curve.to = std::max(curve.from, parameterAt(curve.bisector, curve.end));
  return curve;
}

std::vector<std::vector<Point>> ringsOf(const ExportFrame& frame, std::int32_t circle) {
  std::vector<std::vector<Point>> rings;
  for (const auto& loop : outline(frame.cells, circle, frame.box)) {
    std::vector<Point> ring;
    const auto add = [&](Point p) {
      if (ring.empty() || p != ring.back()) ring.push_back(p);
    };
    for (std::size_t k = 0; k < loop.size(); ++k) {
      if (loop[k].side != kNone) {
        std::ranges::for_each(pointsOf(frame, loop[k]), add);
      } else if (loop[k == 0 ? loop.size() - 1 : k - 1].side == kNone) {
        // A corner of the box. Where an edge meets the box, the edge says where.
        add(loop[k].curve.start);
      }
    }
    while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    if (hasArea(ring)) rings.push_back(std::move(ring));
  }
  return rings;
}

}  // namespace circle_voronoi
