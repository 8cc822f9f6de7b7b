// SPDX-License-Identifier: GPL-3.0-or-later
#include "disjoint_circles.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "at.h"

namespace circle_voronoi {
namespace {

constexpr int kEnd = -1;

/// The largest radius of a level. The radii of a level are larger than an eighth of this.
double sizeOf(int level) { return std::ldexp(1.0, 3 * level); }

std::int64_t cellOf(double coordinate, int level) {
  return static_cast<std::int64_t>(std::floor(coordinate / (2 * sizeOf(level))));
}

}  // namespace

DisjointCircles::DisjointCircles(std::size_t count, double finest)
    : finest_(finest), first_(std::bit_ceil(2 * count + 1), kEnd) {
  circles_.reserve(count);
  next_.reserve(count);
}

int DisjointCircles::levelOf(double radius) const {
  int exponent = 0;
  // The fraction of a power of two is a half, and its level is that of the exponent before.
  const double fraction = std::frexp(std::max(radius, finest_), &exponent);
  return static_cast<int>(std::ceil((fraction == 0.5 ? exponent - 1 : exponent) / 3.0));
}

std::size_t DisjointCircles::bucket(int level, std::int64_t column, std::int64_t row) const {
  std::uint64_t hash = static_cast<std::uint64_t>(column) * 0x9e3779b97f4a7c15U;
  hash = (hash ^ static_cast<std::uint64_t>(row)) * 0xbf58476d1ce4e5b9U;
  hash = (hash ^ (hash >> 32) ^ static_cast<std::uint64_t>(level)) * 0x94d049bb133111ebU;
  return static_cast<std::size_t>(hash >> 32) & (first_.size() - 1);
}

/// Calls `visit` for the circles near a point, until it returns false.
template <class Visit>
void DisjointCircles::visitNear(Point point, double radius, Visit visit) const {
  const int own = radius > 0 || finest_ > 0 ? levelOf(radius)
                  : levels_.empty()         ? 0
                                            : *std::ranges::min_element(levels_);
  for (const int level : levels_) {
    if (level < own) continue;
    const std::int64_t column = cellOf(point.x, level);
    const std::int64_t row = cellOf(point.y, level);
    for (std::int64_t i = column - 1; i <= column + 1; ++i) {
      for (std::int64_t j = row - 1; j <= row + 1; ++j) {
        for (int k = first_[bucket(level, i, j)]; k != kEnd; k = next_[at(k)]) {
          if (!visit(circles_[at(k)])) return;
        }
      }
    }
  }
}

bool DisjointCircles::insert(const Circle& circle) {
  bool isFree = true;
  visitNear({circle.x, circle.y}, circle.r, [&](const Circle& other) {
    const Vector v = between(circle, other);
    const double reach = circle.r + other.r;
    isFree = dot(v, v) > reach * reach;
    return isFree;
  });
  if (!isFree) return false;

  const int index = static_cast<int>(circles_.size());
  circles_.push_back(circle);
  next_.push_back(kEnd);
  // Points block no other circle.
  if (circle.r == 0) return true;
  const int level = levelOf(circle.r);
  if (std::ranges::find(levels_, level) == levels_.end()) levels_.push_back(level);
  int& first = first_[bucket(level, cellOf(circle.x, level), cellOf(circle.y, level))];
  next_.back() = first;
  first = index;
  return true;
}

double DisjointCircles::room(Point point, double limit) const {
  double room = limit;
  visitNear(point, limit, [&](const Circle& other) {
    room = std::min(room, length({other.x - point.x, other.y - point.y}) - other.r);
    return true;
  });
  return room;
}

}  // namespace circle_voronoi
