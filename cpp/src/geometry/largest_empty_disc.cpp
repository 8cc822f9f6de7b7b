// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <optional>
#include <vector>

#include "circle_voronoi/cells.h"
#include "circle_voronoi/hull.h"
#include "circle_voronoi/queries.h"
#include "line_crossing.h"
#include "scale.h"
#include "tangent.h"

namespace circle_voronoi {
namespace {

/// Keeps the largest disc.
class Largest {
 public:
  void offer(const Vertex& disc, const std::array<CircleIndex, 3>& circles) {
    if (!best_ || disc.r > best_->disc.r) best_ = {disc, circles};
  }
  /// A disc that touches one circle, or two, around p.
  void offer(const Diagram& diagram, Point p, CircleIndex circle, CircleIndex other = kNone) {
    offer({p.x, p.y, distanceFrom(diagram, circle, p)}, {circle, other, kNone});
  }

  const std::optional<EmptyDisc>& best() const { return best_; }

 private:
  std::optional<EmptyDisc> best_;
};

}  // namespace

// The part of the diagram outside the hull, beyond the tangent segment from circle i to circle j, is a tree that hangs
// from infinity by an edge of i and j. Seen from there every circle's center is below the tangent line. So
//   - an edge is never parallel to the line: at such a point its two circles' centers would lie in one direction;
//   - at a vertex one edge leads up and two lead down: above it the nearest circle is one of the two whose centers lie
//     outermost, never the third, since the unit vectors from the centers to the vertex lie on a convex arc;
//   - no edge crosses the normals at the points where the segment touches i and j: they belong to the cells of i and j.
// So the edges that cross the segment are found by going down from infinity, each vertex outside once; the others are
// inside the hull.
std::optional<EmptyDisc> largestEmptyDiscCenteredInHull(const Diagram& diagram) {
  const auto& circles = diagram.circles;
  if (diagram.hull.empty()) return std::nullopt;
  Largest largest;
  const double growth = hullGrowth(diagram);
  const auto grown = [&](CircleIndex i) {
    const Circle& c = circles[static_cast<std::size_t>(i)];
    return Circle{c.x, c.y, c.r + growth};
  };
  if (diagram.hull.size() == 1) {
    const Point p = pointOn(grown(diagram.hull[0]), {1, 0});
    largest.offer({p.x, p.y, growth}, {diagram.hull[0], kNone, kNone});
    return largest.best();
  }

  std::vector<bool> isOutside(diagram.vertices.size(), false);
  std::vector<SideIndex> pending;
  for (SideIndex top = 0; top < static_cast<std::int32_t>(2 * diagram.edges.size()); ++top) {
    if (diagram.originOf(top) != kNone) continue;
    // The unbounded side of i next to j belongs to the hull's step from i to j.
    const CircleIndex i = diagram.circleOf(top);
    const CircleIndex j = diagram.neighborOf(top);
    const Circle circle = grown(i);
    const Vector normal = tangentNormal(circle, grown(j));
    const Point touch = pointOn(circle, normal);
    largest.offer({touch.x, touch.y, growth}, {i, kNone, kNone});
    pending.assign(1, top);
    while (!pending.empty()) {
      const SideIndex side = pending.back();
      pending.pop_back();
      const EdgeCurve curve = sideCurve(diagram, side);
      const LineCrossing crossing(curve.bisector, touch, {-normal.y, normal.x});
      std::vector<double> crossings(crossing.parameters().begin(), crossing.parameters().end());
      std::erase_if(crossings, [&](double s) { return s <= curve.from || s >= curve.to; });
      const VertexIndex target = diagram.targetOf(side);
      // An edge that crosses the line twice has come out of the hull again elsewhere.
      if (target != kNone && crossings.size() < 2) {
        const auto v = static_cast<std::size_t>(target);
        if (dot(normal, vectorTo(touch, {diagram.vertices[v].x, diagram.vertices[v].y})) > 0) {
          if (isOutside[v]) continue;  // only rounding leads to a vertex twice
          isOutside[v] = true;
          for (const SideIndex next : diagram.links.vertexSides[v]) {
            if (next != Diagram::twin(side)) pending.push_back(next);
          }
          continue;
        }
      }
      if (crossings.empty()) continue;
      largest.offer(diagram, pointAt(curve.bisector, crossings.front()), diagram.circleOf(side),
                    diagram.neighborOf(side));
    }
  }
  for (std::size_t v = 0; v < diagram.vertices.size(); ++v) {
    if (!isOutside[v]) largest.offer(diagram.vertices[v], diagram.vertexCircles[v]);
  }
  return largest.best();
}

}  // namespace circle_voronoi
