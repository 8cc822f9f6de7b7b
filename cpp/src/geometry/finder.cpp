// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/finder.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numeric>

#include "beginning_of.h"
#include "bucket_grid.h"
#include "circle_voronoi/cells.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

/// The largest number of sides for which asking every neighbor is faster. The nearest neighbor then makes the longest
/// step.
constexpr std::size_t kFewSides = 24;

}  // namespace

class Finder::Walker {
 public:
  explicit Walker(const Diagram& diagram);
  CircleIndex find(Point p, CircleIndex hint) const;
  std::vector<std::uint32_t> inOrderOfBuckets(std::span<const Point> points) const;

 private:
  CircleIndex nearerNeighbor(CircleIndex circle, CircleIndex of, Point p) const;
  CircleIndex across(CircleIndex circle, Point p) const;
  /// The sides of a cell, in order around a point of the cell from which all of it is seen.
  struct Sides {
    Point middle;
    std::span<const SideIndex> sides;
  };
  Sides manySides(CircleIndex circle) const;
  Point middleOf(CircleIndex circle) const;

  const Diagram& diagram_;
  BucketGrid starts_;  ///< a visible circle for each bucket
  /// Cells with many sides, in increasing order. The k-th has the sides from firstOfMany_[k] to before firstOfMany_[k +
  /// 1].
  std::vector<CircleIndex> many_;
  std::vector<Point> middleOfMany_;
  std::vector<std::size_t> firstOfMany_ = {0};
  std::vector<SideIndex> sidesOfMany_;
};

Finder::Walker::Walker(const Diagram& diagram) : diagram_(diagram) {
  const auto& circles = diagram.circles;
  std::vector<BucketGrid::Item> starts;
  for (std::size_t i = 0; i < circles.size(); ++i) {
    const auto circle = static_cast<std::int32_t>(i);
    if (diagram.hasCell(circle)) starts.push_back({{circles[i].x, circles[i].y}, circle});
  }
  if (starts.empty()) return;
  starts_ = BucketGrid(starts);

  std::vector<std::uint32_t> sideCount(circles.size(), 0);
  for (const Edge& edge : diagram.edges) {
    ++sideCount[static_cast<std::size_t>(edge.left)];
    ++sideCount[static_cast<std::size_t>(edge.right)];
  }
  for (std::size_t i = 0; i < circles.size(); ++i) {
    if (sideCount[i] <= kFewSides) continue;
    const auto circle = static_cast<std::int32_t>(i);
    many_.push_back(circle);
    middleOfMany_.push_back(middleOf(circle));
    std::ranges::copy(diagram.sides(circle), std::back_inserter(sidesOfMany_));
    firstOfMany_.push_back(sidesOfMany_.size());
  }
}

/// The center of a cell, or the mean of its vertices for Metric::power, where the center may lie outside.
Point Finder::Walker::middleOf(CircleIndex circle) const {
  const Circle& c = diagram_.circles[static_cast<std::size_t>(circle)];
  if (diagram_.metric != Metric::power) return {c.x, c.y};
  std::vector<VertexIndex> vertices;
  for (const SideIndex side : diagram_.sides(circle)) {
    if (diagram_.originOf(side) != kNone) vertices.push_back(diagram_.originOf(side));
  }
  Point middle = {0, 0};
  for (const VertexIndex vertex : vertices) {
    const Vertex& v = diagram_.vertices[static_cast<std::size_t>(vertex)];
    middle.x += v.x / static_cast<double>(vertices.size());
    middle.y += v.y / static_cast<double>(vertices.size());
  }
  return middle;
}

/// The sides of a cell with more than kFewSides; none of another.
Finder::Walker::Sides Finder::Walker::manySides(CircleIndex circle) const {
  const auto found = std::ranges::lower_bound(many_, circle);
  if (found == many_.end() || *found != circle) return {};
  const auto k = static_cast<std::size_t>(found - many_.begin());
  return {middleOfMany_[k], std::span(sidesOfMany_).subspan(firstOfMany_[k], firstOfMany_[k + 1] - firstOfMany_[k])};
}

CircleIndex Finder::Walker::find(Point p, CircleIndex hint) const {
  CircleIndex circle = starts_.near(p, 0, [](CircleIndex) { return true; });
  if (circle == kNone) return kNone;
  if (hint != kNone && diagram_.hasCell(hint) && distanceDifference(diagram_, hint, circle, p) > 0) circle = hint;
  // Each step comes nearer, so the walk ends. But rounding may lead around a loop, which then meets the circle marked
  // at step 4, 8, 16 and so on.
  CircleIndex marked = circle;
  std::size_t step = 0;
  for (std::size_t markAt = 4;; ++step) {
    const CircleIndex next = nearerNeighbor(circle, circle, p);
    if (next == kNone || next == marked) return circle;
    circle = next;
    if (step != markAt) continue;
    circle = marked = across(circle, p);
    markAt *= 2;
  }
}

/// Returns the circle, or a nearer one across a neighbor with many sides: a shortcut on a walk around that neighbor.
CircleIndex Finder::Walker::across(CircleIndex circle, Point p) const {
  if (!manySides(circle).sides.empty()) return circle;
  for (const SideIndex side : diagram_.sides(circle)) {
    const CircleIndex neighbor = diagram_.neighborOf(side);
    if (manySides(neighbor).sides.empty()) continue;
    if (const CircleIndex next = nearerNeighbor(circle, neighbor, p); next != kNone) return next;
  }
  return circle;
}

/// Returns the indices of points, grouped by bucket, so that a walk finds its circles in the cache.
std::vector<std::uint32_t> Finder::Walker::inOrderOfBuckets(std::span<const Point> points) const {
  std::vector<std::uint32_t> order(points.size());
  if (!starts_.hasBuckets()) {
    std::iota(order.begin(), order.end(), 0U);
    return order;
  }
  std::vector<std::uint32_t> next(starts_.bucketCount() + 1, 0);
  for (const Point& p : points) ++next[starts_.bucketOf(p) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  for (std::size_t k = 0; k < points.size(); ++k) {
    order[next[starts_.bucketOf(points[k])]++] = static_cast<std::uint32_t>(k);
  }
  return order;
}

/// Returns a neighbor of a circle, `of`, that is nearer to p than `circle`, or kNone.
CircleIndex Finder::Walker::nearerNeighbor(CircleIndex circle, CircleIndex of, Point p) const {
  double most = 0;
  CircleIndex nearest;
  const auto ask = [&](SideIndex side) {
    const CircleIndex neighbor = diagram_.neighborOf(side);
    const double its = distanceDifference(diagram_, neighbor, circle, p);
    if (its > most) {
      most = its;
      nearest = neighbor;
    }
  };
  const Sides many = manySides(of);
  const auto sides = many.sides;
  if (sides.empty()) {
    std::ranges::for_each(diagram_.sides(of), ask);
    return nearest;
  }
  const Vector toPoint = {p.x - many.middle.x, p.y - many.middle.y};
  const auto beginning = [&](SideIndex side) { return beginningOf(diagram_, side, many.middle); };
  const Vector reference = beginning(sides.front());
  const auto after = std::ranges::partition_point(
      sides, [&](SideIndex side) { return isNoLater(reference, beginning(side), toPoint); });
  // Rounding may be off by a side of next to no length.
  const auto k = static_cast<std::size_t>(after - sides.begin()) + sides.size();
  for (const std::size_t offset : {0U, 1U, 2U, 3U}) ask(sides[(k + 1 - offset) % sides.size()]);
  return nearest;
}

Finder::Finder(const Diagram& diagram) : walker_(std::make_unique<Walker>(diagram)) {}
Finder::Finder(Finder&&) noexcept = default;
Finder& Finder::operator=(Finder&&) noexcept = default;
Finder::~Finder() = default;

CircleIndex Finder::find(Point p, CircleIndex hint) const { return walker_->find(p, hint); }

std::vector<CircleIndex> Finder::findAll(std::span<const Point> points) const {
  std::vector<CircleIndex> result(points.size());
  CircleIndex before = kNone;
  for (const std::uint32_t k : walker_->inOrderOfBuckets(points)) before = result[k] = find(points[k], before);
  return result;
}

}  // namespace circle_voronoi
