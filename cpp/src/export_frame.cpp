// SPDX-License-Identifier: GPL-3.0-or-later
#include "export_frame.h"

#include <algorithm>

namespace circle_voronoi {
namespace {

constexpr double kMargin = 0.05;
constexpr double kTolerance = 1e-5;

double sizeOf(const Box& box) { return std::max(box.maxX - box.minX, box.maxY - box.minY); }

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
      tolerance(options.tolerance ? *options.tolerance : kTolerance * sizeOf(box)) {}

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
    for (const OutlinePiece& piece : loop) {
      std::vector<Point> points = polyline(edgeDirection(frame.cells, piece), frame.tolerance);
      if (isAgainstEdge(piece)) std::ranges::reverse(points);
      for (const Point& p : points) {
        if (ring.empty() || p != ring.back()) ring.push_back(p);
      }
    }
    while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    if (ring.size() > 2) rings.push_back(std::move(ring));
  }
  return rings;
}

}  // namespace circle_voronoi
