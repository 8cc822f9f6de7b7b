// SPDX-License-Identifier: GPL-3.0-or-later
#include "clip_polygons.h"

#include <algorithm>
#include <cmath>

#include "at.h"
#include "circle_arc.h"
#include "clip_parts.h"
#include "flatten.h"
#include "in_circle.h"
#include "scale.h"
#include "with_key.h"

namespace circle_voronoi {
namespace {

/// So many times at most a chord is divided for a corner. The last time it takes the corner itself.
constexpr int kMostDivisions = 60;

Point centerOf(const Diagram& diagram, CircleIndex circle) {
  const Circle& c = diagram.circles[at(circle)];
  return {c.x, c.y};
}

/// Divides the step that a corner lies beyond, as `middle` says, until the corner is on the left of the steps. The steps
/// go counter-clockwise around the center, and the corner lies inside what they border.
template <class Middle>
void makeRoom(std::vector<Point>& points, Point center, Point corner, Middle middle) {
  for (int i = 0; i <= kMostDivisions; ++i) {
    std::size_t k = 1;
    const auto isAhead = [&](Point p) { return orientation(center, p, corner) >= 0; };
    while (k < points.size() && !(isAhead(points[k - 1]) && orientation(center, corner, points[k]) > 0)) ++k;
    if (k == points.size() || points[k - 1] == corner || points[k] == corner) return;
    if (orientation(points[k - 1], points[k], corner) > 0) return;
    const Point p = i < kMostDivisions ? middle(points[k - 1], points[k]) : corner;
    const bool isNew = p != points[k - 1] && p != points[k];
    points.insert(points.begin() + static_cast<std::ptrdiff_t>(k), isNew ? p : corner);
  }
}

}  // namespace

ClipFlattener::ClipFlattener(const ClippedDiagram& clipped, double tolerance)
    : clipped_(clipped), tolerance_(tolerance) {
  if (clipped.diagram().metric == Metric::circles) collectCorners();
}

void ClipFlattener::collectCorners() {
  const auto& parts = clipped_.parts();
  const Diagram& diagram = clipped_.diagram();
  double clearance = 0;  // how far the last point is from the border of its cell, at least
  Point last;
  const auto add = [&](CircleIndex cell, Point p) {
    clearance -= lengthOf(vectorTo(last, p));
    last = p;
    if (clearance > 2 * tolerance_) return;
    clearance = kInfinite;
    for (const SideIndex side : diagram.sides(cell)) {
      const CircleIndex neighbor = diagram.neighborOf(side);
      const double distance = lead(diagram, cell, neighbor, p) / 2;
      clearance = std::min(clearance, distance);
      if (distance > tolerance_ || diagram.circles[at(cell)].r == diagram.circles[at(neighbor)].r) continue;
      corners_.push_back({Diagram::edgeOf(side), p, cell});
    }
  };
  for (const auto& [cell, crossing] : parts.allCrossings()) {
    clearance = 0;
    last = parts.crossings.all[at(crossing)].point;
    parts.visitCorners(parts.stretchFrom(crossing), [&, cell = cell](RegionSideIndex side) {
      add(cell, parts.pointOf(parts.sideAfter(side)));
    });
  }
  for (const auto& [cell, ring] : parts.allRings()) {
    clearance = 0;
    last = parts.pointOf(parts.region.ringOffsets()[at(ring)]);
    for (std::int32_t k = parts.region.ringOffsets()[at(ring)]; k < parts.region.ringOffsets()[at(ring) + 1]; ++k) {
      add(cell, parts.pointOf(k));
    }
  }
  std::ranges::stable_sort(corners_, {}, [](const Corner& corner) { return std::int32_t{corner.edge}; });
}

std::vector<Point> ClipFlattener::pointsOf(EdgeIndex edge, const EdgeCurve& part) const {
  if (part.start == part.end) return {part.start};
  std::vector<Point> points = pointsBetween(part, part.start, part.end, tolerance_);
  const auto key = [](const Corner& corner) { return std::int32_t{corner.edge}; };
  const Diagram& diagram = clipped_.diagram();
  const Bisector& bisector = part.bisector;
  for (const Corner& corner : withKey(corners_, std::int32_t{edge}, key)) {
    const auto middle = [&](Point p, Point q) {
      const double from = parameterAt(bisector, p);
      const double to = parameterAt(bisector, q);
      const double s = parameterAt(bisector, corner.point);
      const bool isBetween = std::min(from, to) < s && s < std::max(from, to);
      return pointAt(bisector, isBetween ? s : std::sqrt(from) * std::sqrt(to));
    };
    const bool isLeft = corner.cell == diagram.edges[at(edge)].left;
    if (!isLeft) std::ranges::reverse(points);
    makeRoom(points, centerOf(diagram, corner.cell), corner.point, middle);
    if (!isLeft) std::ranges::reverse(points);
  }
  return points;
}

std::vector<Point> ClipFlattener::pointsOf(CircleIndex circle, const OutlinePiece& piece) const {
  const auto& parts = clipped_.parts();
  if (piece.isOnCircle()) return polyline(circleArc(piece), tolerance_);
  static_cast<void>(circle);
  EdgeCurve part = parts.curveOf(Diagram::edgeOf(piece.side));
  const bool isAlong = piece.side % 2 == 0;
  part.start = isAlong ? piece.curve.start : piece.curve.end;
  part.end = isAlong ? piece.curve.end : piece.curve.start;
  part.from = parameterAt(part.bisector, part.start);
  part.to = std::max(part.from, parameterAt(part.bisector, part.end));
  std::vector<Point> points = pointsOf(Diagram::edgeOf(piece.side), part);
  if (!isAlong) std::ranges::reverse(points);
  return points;
}

ClippedPolygons clipPolygons(const ClippedDiagram& clipped, double tolerance) {
  const ClipFlattener flattener(clipped, tolerance);
  const auto& diagram = clipped.diagram();
  ClippedPolygons result;
  const auto closePolygon = [&] {
    const auto rings = static_cast<std::int32_t>(result.pointOffsets.size()) - 1;
    if (result.ringOffsets.back() != rings) result.ringOffsets.push_back(rings);
  };
  for (std::size_t i = 0; i < diagram.circles.size(); ++i) {
    const auto circle = static_cast<std::int32_t>(i);
    const Outline outline = clipped.outline(circle);
    bool isOpen = false;  // whether the last polygon may get holes
    for (const auto& loop : outline) {
      const std::size_t first = result.points.size();
      const auto add = [&](Point p) {
        if (result.points.size() == first || result.points.back() != p) result.points.push_back(p);
      };
      for (const OutlinePiece& piece : loop) {
        if (piece.side == kNone && !piece.isOnCircle()) {
          add(piece.curve.start);
          continue;
        }
        const auto points = flattener.pointsOf(circle, piece);
        add(points.front());
        for (std::size_t k = 1; k + 1 < points.size(); ++k) add(points[k]);
      }
      while (result.points.size() > first + 1 && result.points.back() == result.points[first]) result.points.pop_back();
      const bool isHole = &loop != &outline.front() && area({loop}) < 0;
      const bool isKept = result.points.size() >= first + 3 && (!isHole || isOpen);
      if (!isHole) isOpen = isKept;
      if (!isKept) {
        result.points.resize(first);
        continue;
      }
      if (!isHole) closePolygon();
      result.pointOffsets.push_back(static_cast<std::int32_t>(result.points.size()));
    }
    closePolygon();
    result.polygonOffsets.push_back(static_cast<std::int32_t>(result.ringOffsets.size()) - 1);
  }
  return result;
}

}  // namespace circle_voronoi
