// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>

#include "circle_voronoi/finder.h"
#include "circle_voronoi/queries.h"
#include "clip.h"
#include "far_view.h"
#include "scale.h"
#include "tangent.h"

namespace circle_voronoi {
namespace {

/// Keeps the largest disc.
class Largest {
 public:
  void offer(const Vertex& disc, const std::array<std::int32_t, 3>& circles) {
    if (!best_ || disc.radius > best_->disc.radius) best_ = {disc, circles};
  }
  /// A disc that touches one circle, or two, around p.
  void offer(const Cells& cells, Point p, std::int32_t circle, std::int32_t other = kNone) {
    offer({p.x, p.y, cells.distance(circle, p)}, {circle, other, kNone});
  }

  double radius() const { return best_ ? best_->disc.radius : -std::numeric_limits<double>::infinity(); }
  const std::optional<EmptyDisc>& best() const { return best_; }

 private:
  std::optional<EmptyDisc> best_;
};

Vector vectorTo(Point p, Point q) { return {q.x - p.x, q.y - p.y}; }

/// The three sides that begin at each vertex.
std::vector<std::array<std::int32_t, 3>> departures(const Cells& cells) {
  const auto& diagram = cells.diagram();
  std::vector<std::array<std::int32_t, 3>> sides(diagram.vertices.size(), {kNone, kNone, kNone});
  for (std::int32_t side = 0; side < static_cast<std::int32_t>(2 * diagram.edges.size()); ++side) {
    const std::int32_t origin = cells.originOf(side);
    if (origin == kNone) continue;
    auto& slots = sides[static_cast<std::size_t>(origin)];
    *std::ranges::find(slots, kNone) = side;
  }
  return sides;
}

}  // namespace

std::optional<EmptyDisc> largestEmptyDiscCentredIn(const Cells& cells, const ConvexPolygon& region) {
  const Diagram& diagram = cells.diagram();
  Largest largest;
  const Finder finder(cells);
  std::int32_t nearest = kNone;
  for (const Point& corner : region.corners()) {
    nearest = finder.find(corner, nearest);
    if (nearest != kNone) largest.offer(cells, corner, nearest);
  }
  for (std::size_t v = 0; v < diagram.vertices.size(); ++v) {
    const Vertex& vertex = diagram.vertices[v];
    if (region.contains({vertex.x, vertex.y})) largest.offer(vertex, diagram.vertexCircles[v]);
  }
  for (std::int32_t e = 0; e < static_cast<std::int32_t>(diagram.edges.size()); ++e) {
    const auto& [left, right, start, end] = diagram.edges[static_cast<std::size_t>(e)];
    const auto radiusAt = [&](std::int32_t v) {
      return v == kNone ? std::numeric_limits<double>::infinity()
                        : diagram.vertices[static_cast<std::size_t>(v)].radius;
    };
    // Along an edge the distance is largest at one of its ends.
    if (std::max(radiusAt(start), radiusAt(end)) <= largest.radius()) continue;
    for (const auto& [piece, cutFrom, cutTo] : partsInside(edgeCurve(cells.circles(), diagram, e), region)) {
      if (cutFrom != kNone) largest.offer(cells, piece.start, left, right);
      if (cutTo != kNone) largest.offer(cells, piece.end, left, right);
    }
  }
  return largest.best();
}

// What of the diagram lies outside the hull, beyond the tangent segment from circle i to circle j, is a tree that hangs
// from infinity by an edge of i and j. Seen from there every circle's centre is below the tangent line. So
//   - an edge is never parallel to the line: at such a point its two circles' centres would lie in one direction;
//   - at a vertex one edge leads up and two lead down: above it the nearest circle is one of the two whose centres lie
//     outermost, never the third, since the unit vectors from the centres to the vertex lie on a convex arc;
//   - no edge crosses the normals at the points where the segment touches i and j: they belong to the cells of i and j.
// So the edges that cross the segment are found by going down from infinity, each vertex outside once; the others are
// inside the hull.
std::optional<EmptyDisc> largestEmptyDiscCentredInHull(const Cells& cells) {
  const Diagram& diagram = cells.diagram();
  const auto circles = cells.circles();
  if (diagram.hull.empty()) return std::nullopt;
  Largest largest;
  const Circle& onHull = circles[static_cast<std::size_t>(diagram.hull[0])];
  if (diagram.hull.size() == 1) {
    const Point p = pointOn(onHull, {1, 0});
    largest.offer({p.x, p.y, 0}, {diagram.hull[0], kNone, kNone});
    return largest.best();
  }

  const auto sidesFrom = departures(cells);
  std::vector<bool> isOutside(diagram.vertices.size(), false);
  std::vector<std::int32_t> pending;
  for (std::int32_t top = 0; top < static_cast<std::int32_t>(2 * diagram.edges.size()); ++top) {
    if (cells.originOf(top) != kNone) continue;
    // The unbounded side of i next to j belongs to the hull's step from i to j.
    const std::int32_t i = cells.circleOf(top);
    const std::int32_t j = cells.neighborOf(top);
    const Circle& circle = circles[static_cast<std::size_t>(i)];
    const Vector normal = tangentNormal(circle, circles[static_cast<std::size_t>(j)]);
    const Point touch = pointOn(circle, normal);
    largest.offer({touch.x, touch.y, 0}, {i, kNone, kNone});
    pending.assign(1, top);
    while (!pending.empty()) {
      const std::int32_t side = pending.back();
      pending.pop_back();
      const EdgeCurve whole = cells.curveOf(side);
      const EdgeCurve curve = seenFrom(whole, largestOf(vectorTo(whole.bisector.origin, touch)));
      const LineCrossing crossing(curve.bisector, touch, {-normal.y, normal.x});
      std::vector<double> crossings = crossing.parameters();
      std::erase_if(crossings, [&](double s) { return s <= curve.from || s >= curve.to; });
      const std::int32_t target = cells.targetOf(side);
      // An edge that crosses the line twice has come out of the hull again elsewhere.
      if (target != kNone && crossings.size() < 2) {
        const auto v = static_cast<std::size_t>(target);
        if (dot(normal, vectorTo(touch, {diagram.vertices[v].x, diagram.vertices[v].y})) > 0) {
          if (isOutside[v]) continue;  // only rounding leads to a vertex twice
          isOutside[v] = true;
          for (const std::int32_t next : sidesFrom[v]) {
            if (next != (side ^ 1)) pending.push_back(next);
          }
          continue;
        }
      }
      if (crossings.empty()) continue;
      largest.offer(cells, pointAt(curve.bisector, crossings.front()), cells.circleOf(side), cells.neighborOf(side));
    }
  }
  for (std::size_t v = 0; v < diagram.vertices.size(); ++v) {
    if (!isOutside[v]) largest.offer(diagram.vertices[v], diagram.vertexCircles[v]);
  }
  return largest.best();
}

}  // namespace circle_voronoi
