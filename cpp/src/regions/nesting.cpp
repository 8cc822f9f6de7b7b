// SPDX-License-Identifier: GPL-3.0-or-later
#include "nesting.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "at.h"
#include "circle_voronoi/limits.h"
#include "in_outline.h"
#include "ring_sweep.h"
#include "rounded.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

/// Places on the square that are nearer to each other may be in the wrong order, by rounding.
constexpr double kOneDirection = 0x1p-44;

/// Makes straight rings of loops for a sweep. The pieces on the border of the cell are replaced by ways outside: away
/// from the center to a square around all loops, and along it.
class StraightLoops {
 public:
  StraightLoops(Point center, double half) : center_(center), half_(half) {}

  void add(const std::vector<OutlinePiece>& loop) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const OutlinePiece& piece = loop[k];
      const Point start = piece.curve.start;
      add(start);
      if (piece.side == kNone && !piece.isOnCircle()) continue;
      addWay(start, loop[k + 1 == loop.size() ? 0 : k + 1].curve.start);
    }
    endRing();
  }

  void add(const PointRing& hole) {
    for (const Point p : hole) add(p);
    endRing();
  }

  /// Returns the rings, or nothing if one has next to no size.
  const Rings* rings() const { return areRings_ ? &rings_ : nullptr; }

 private:
  std::size_t begin() const { return at(rings_.offsets.back()); }

  void add(Point p) {
    if (rings_.points.size() == begin() || rings_.points.back() != p) rings_.points.push_back(p);
  }

  void endRing() {
    while (rings_.points.size() > begin() + 1 && rings_.points.back() == rings_.points[begin()])
      rings_.points.pop_back();
    areRings_ = areRings_ && rings_.points.size() >= begin() + 3;
    rings_.offsets.push_back(static_cast<std::int32_t>(rings_.points.size()));
  }

  /// Returns the place of a direction on the square, from 0 to 8, counter-clockwise from the middle of its right side.
  static double placeOf(Vector v) {
    if (std::abs(v.x) < std::abs(v.y)) return (v.y > 0 ? 2 : 6) - v.x / v.y;
    const double place = (v.x > 0 ? 0 : 4) + v.y / v.x;
    return place < 0 ? place + 8 : place;
  }

  void addWay(Point from, Point to) {
    const double start = placeOf(vectorTo(center_, from));
    double end = placeOf(vectorTo(center_, to));
    if (end < start - kOneDirection) end += 8;
    if (end > start + 8 - kOneDirection) end -= 8;
    addOnSquare(from);
    for (int k = 0; 2 * k + 1 < end; ++k) {
      if (2 * k + 1 <= start) continue;
      const int corner = k % 4;
      add(Point{center_.x + (corner == 0 || corner == 3 ? half_ : -half_), center_.y + (corner < 2 ? half_ : -half_)});
    }
    addOnSquare(to);
  }

  void addOnSquare(Point p) {
    const Vector v = vectorTo(center_, p);
    if (largestOf(v) == 0) {
      areRings_ = false;
      return;
    }
    const bool isAside = std::abs(v.x) >= std::abs(v.y);
    const auto place = [&](double value, double other) { return half_ * (value / std::abs(other)); };
    add(rounded(isAside ? Point{center_.x + std::copysign(half_, v.x), center_.y + place(v.y, v.x)}
                        : Point{center_.x + place(v.x, v.y), center_.y + std::copysign(half_, v.y)}));
  }

  Point center_;
  double half_;
  Rings rings_ = {{}, {0}};
  bool areRings_ = true;
};

/// Returns how loops and holes lie to each other, or nothing if rounding has made them cross.
std::optional<RingOrder> orderOf(const Outline& loops, std::span<const PointRing> holes, Point center) {
  double size = 0;
  const auto include = [&](Point p) { size = std::max(size, largestOf(vectorTo(center, p))); };
  for (const auto& loop : loops) {
    for (const OutlinePiece& piece : loop) include(piece.curve.start);
  }
  for (const PointRing& hole : holes) std::ranges::for_each(hole, include);
  if (!(size > 0)) return std::nullopt;
  const double half = 4 * powerOfTwoIn(size);
  if (!(half + largestOf({center.x, center.y}) < kRegionLimit)) return std::nullopt;
  StraightLoops straight(rounded(center), half);
  for (const auto& loop : loops) straight.add(loop);
  for (const PointRing& hole : holes) straight.add(hole);
  return straight.rings() ? orderIfApart(*straight.rings()) : std::nullopt;
}

}  // namespace

std::vector<std::size_t> loopsAround(const Outline& loops, std::span<const PointRing> holes, Point center) {
  std::vector<std::size_t> result(holes.size(), 0);
  if (loops.size() < 2) return result;
  const std::optional<RingOrder> order = orderOf(loops, holes, center);
  for (std::size_t k = 0; k < holes.size(); ++k) {
    const std::int32_t around = order ? order->parent[loops.size() + k] : kNone;
    if (around != kNone && at(around) < loops.size()) {
      result[k] = at(around);
      continue;
    }
    const auto found = std::ranges::find_if(loops, [&](const auto& loop) { return hasInLoop(loop, holes[k].front()); });
    if (found != loops.end()) result[k] = static_cast<std::size_t>(found - loops.begin());
  }
  return result;
}

}  // namespace circle_voronoi
