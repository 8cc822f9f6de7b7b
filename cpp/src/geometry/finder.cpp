// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/finder.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>

#include "circle_voronoi/cells.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

/// Up to so many sides it is quicker to ask every neighbor, and the nearest one makes the longest step.
constexpr std::size_t kFewSides = 24;

std::size_t bucketOf(double offset, double size, std::size_t count) {
  const double bucket = offset / size;
  return bucket > 0 ? static_cast<std::size_t>(std::min(bucket, static_cast<double>(count - 1))) : 0;
}

/// The direction from the cell's center in which a side begins.
Vector beginningOf(const Diagram& diagram, SideIndex side) {
  const Circle& c = diagram.circles[static_cast<std::size_t>(diagram.circleOf(side))];
  const VertexIndex origin = diagram.originOf(side);
  if (origin != kNone) {
    const Vertex& v = diagram.vertices[static_cast<std::size_t>(origin)];
    return {v.x - c.x, v.y - c.y};
  }
  // The limit of point(s) as s goes to 0.
  const Bisector bisector = sideCurve(diagram, side).bisector;
  const double a = std::abs(bisector.a);
  return {-a * bisector.along.x - bisector.b * bisector.across.x,
          -a * bisector.along.y - bisector.b * bisector.across.y};
}

/// Whether turning counter-clockwise from `reference` one meets v no later than w.
bool noLater(Vector reference, Vector v, Vector w) {
  const auto isSecondHalf = [&](Vector u) {
    const double side = turn(reference, u);
    return side < 0 || (side == 0 && facing(reference, u) < 0);
  };
  if (isSecondHalf(v) != isSecondHalf(w)) return isSecondHalf(w);
  return turn(v, w) >= 0;
}

}  // namespace

class Finder::Walker {
 public:
  explicit Walker(const Diagram& diagram);
  CircleIndex find(Point p, CircleIndex hint) const;

 private:
  CircleIndex startNear(Point p) const;
  CircleIndex nearerNeighbor(CircleIndex circle, Point p) const;
  std::span<const SideIndex> manySides(CircleIndex circle) const;

  const Diagram& diagram_;
  Point corner_;
  double width_ = 1;  ///< of a bucket
  double height_ = 1;
  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  std::vector<CircleIndex> starts_;  ///< a visible circle for each bucket, row by row
  /// Cells with many sides, increasing, and their sides: those of the k-th from firstOfMany_[k] to firstOfMany_[k + 1].
  std::vector<CircleIndex> many_;
  std::vector<std::size_t> firstOfMany_ = {0};
  std::vector<SideIndex> sidesOfMany_;
};

Finder::Walker::Walker(const Diagram& diagram) : diagram_(diagram) {
  const auto& circles = diagram.circles;
  Box box = {kInfinite, kInfinite, -kInfinite, -kInfinite};
  std::size_t visible = 0;
  for (std::size_t i = 0; i < circles.size(); ++i) {
    if (!diagram.hasCell(static_cast<std::int32_t>(i))) continue;
    ++visible;
    box.minX = std::min(box.minX, circles[i].x);
    box.minY = std::min(box.minY, circles[i].y);
    box.maxX = std::max(box.maxX, circles[i].x);
    box.maxY = std::max(box.maxY, circles[i].y);
  }
  if (visible == 0) return;

  corner_ = {box.minX, box.minY};
  const double perBucket = 2;
  const auto count = static_cast<std::size_t>(std::sqrt(static_cast<double>(visible) / perBucket)) + 1;
  columns_ = rows_ = count;
  // Centers on one line leave a grid without width or height, as does the smallest number; any size does there.
  const auto sizeOf = [&](double extent) {
    const double size = extent / static_cast<double>(count);
    return size > 0 ? size : 1;
  };
  width_ = sizeOf(box.maxX - box.minX);
  height_ = sizeOf(box.maxY - box.minY);

  starts_.assign(columns_ * rows_, kNone);
  std::deque<std::size_t> filled;
  for (std::size_t i = 0; i < circles.size(); ++i) {
    if (!diagram.hasCell(static_cast<std::int32_t>(i))) continue;
    const std::size_t bucket = bucketOf(circles[i].y - corner_.y, height_, rows_) * columns_ +
                               bucketOf(circles[i].x - corner_.x, width_, columns_);
    if (starts_[bucket] == kNone) filled.push_back(bucket);
    starts_[bucket] = static_cast<std::int32_t>(i);
  }
  // Empty buckets take the start of a filled one near them.
  while (!filled.empty()) {
    const std::size_t bucket = filled.front();
    filled.pop_front();
    const auto spread = [&](std::size_t next) {
      if (starts_[next] != kNone) return;
      starts_[next] = starts_[bucket];
      filled.push_back(next);
    };
    const std::size_t column = bucket % columns_;
    if (column > 0) spread(bucket - 1);
    if (column + 1 < columns_) spread(bucket + 1);
    if (bucket >= columns_) spread(bucket - columns_);
    if (bucket + columns_ < starts_.size()) spread(bucket + columns_);
  }

  std::vector<std::uint32_t> sideCount(circles.size(), 0);
  for (const Edge& edge : diagram.edges) {
    ++sideCount[static_cast<std::size_t>(edge.left)];
    ++sideCount[static_cast<std::size_t>(edge.right)];
  }
  for (std::size_t i = 0; i < circles.size(); ++i) {
    if (sideCount[i] <= kFewSides) continue;
    const auto circle = static_cast<std::int32_t>(i);
    many_.push_back(circle);
    std::ranges::copy(diagram.sides(circle), std::back_inserter(sidesOfMany_));
    firstOfMany_.push_back(sidesOfMany_.size());
  }
}

/// The sides of a cell with more than kFewSides; none of another.
std::span<const SideIndex> Finder::Walker::manySides(CircleIndex circle) const {
  const auto found = std::ranges::lower_bound(many_, circle);
  if (found == many_.end() || *found != circle) return {};
  const auto k = static_cast<std::size_t>(found - many_.begin());
  return std::span(sidesOfMany_).subspan(firstOfMany_[k], firstOfMany_[k + 1] - firstOfMany_[k]);
}

CircleIndex Finder::Walker::startNear(Point p) const {
  return starts_[bucketOf(p.y - corner_.y, height_, rows_) * columns_ + bucketOf(p.x - corner_.x, width_, columns_)];
}

CircleIndex Finder::Walker::find(Point p, CircleIndex hint) const {
  if (starts_.empty()) return kNone;
  CircleIndex circle = startNear(p);
  if (hint != kNone && diagram_.hasCell(hint) && lead(diagram_, hint, circle, p) > 0) circle = hint;
  // Each step comes nearer, so that none is made twice, but rounding may lead around in a circle: then one is met again
  // that was marked at step 1, 2, 4, 8 and so on.
  CircleIndex marked = circle;
  std::size_t step = 0;
  for (std::size_t markAt = 1;; ++step) {
    const CircleIndex next = nearerNeighbor(circle, p);
    if (next == kNone || next == marked) return circle;
    circle = next;
    if (step == markAt) {
      marked = circle;
      markAt *= 2;
    }
  }
}

/// A neighbor nearer to p than the circle itself, or kNone.
CircleIndex Finder::Walker::nearerNeighbor(CircleIndex circle, Point p) const {
  double most = 0;
  CircleIndex nearest;
  const auto ask = [&](SideIndex side) {
    const CircleIndex neighbor = diagram_.neighborOf(side);
    const double its = lead(diagram_, neighbor, circle, p);
    if (its > most) {
      most = its;
      nearest = neighbor;
    }
  };
  const auto sides = manySides(circle);
  if (sides.empty() || diagram_.metric == Metric::power) {
    std::ranges::for_each(diagram_.sides(circle), ask);
    return nearest;
  }
  const Circle& c = diagram_.circles[static_cast<std::size_t>(circle)];
  const Vector toPoint = {p.x - c.x, p.y - c.y};
  const Vector reference = beginningOf(diagram_, sides.front());
  const auto after = std::ranges::partition_point(
      sides, [&](SideIndex side) { return noLater(reference, beginningOf(diagram_, side), toPoint); });
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
  std::vector<CircleIndex> result;
  result.reserve(points.size());
  for (const Point& p : points) result.push_back(find(p, result.empty() ? CircleIndex() : result.back()));
  return result;
}

}  // namespace circle_voronoi
