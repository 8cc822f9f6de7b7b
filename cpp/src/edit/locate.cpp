// SPDX-License-Identifier: GPL-3.0-or-later
#include "locate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "homogeneous_disc.h"

namespace circle_voronoi {
namespace {

/// Of buckets around one that is outdated: farther than these a walk is as quick.
constexpr int kMostRings = 3;

/// Whether a ray from the centre of the origin of h goes through its sector; not if rounding hides whether there is
/// next to nothing between the rays to its discs, or next to all.
bool spans(const EditState& state, int h, Vector ray) {
  const Dual& dual = state.dual;
  const auto toDisc = [&](int corner) {
    return state.predicates.direction(dual.origin[corner], state.discs[corner / 3]);
  };
  const Direction before = toDisc(Dual::next(dual.twin[h]));
  const Direction after = toDisc(h);
  const Vector u = {before.x, before.y};
  const Vector v = {after.x, after.y};
  const int turn = crossOf(before, after).sign();
  if (turn == 0 && dot(u, v) >= 0) return false;
  const bool isAfter = cross(u, ray) >= 0;
  const bool isBefore = cross(ray, v) >= 0;
  return turn < 0 ? isAfter || isBefore : isAfter && isBefore;
}

/// The half-edge from the origin of h in whose sector a point lies. If rounding hides it, that to the nearest
/// neighbour: if the point is not in the cell, that one is nearer.
int sectorOf(const EditState& state, int h, Point p) {
  const Dual& dual = state.dual;
  const Circle& from = state.circles[dual.origin[h]];
  const Vector ray = {p.x - from.x, p.y - from.y};
  const bool isLeft = cross(state.discs.direction(h), ray) >= 0;
  int spoke = h;
  do {
    if (spans(state, spoke, ray)) return spoke;
    spoke = isLeft ? dual.twin[Dual::previous(spoke)] : Dual::next(dual.twin[spoke]);
  } while (spoke != h);
  int nearest = h;
  double least = std::numeric_limits<double>::infinity();
  do {
    if (const int to = dual.target(spoke); to != kPointAtInfinity) {
      if (const double distance = distanceFrom(p, state.circles[to]); distance < least) {
        least = distance;
        nearest = spoke;
      }
    }
    spoke = Dual::next(dual.twin[spoke]);
  } while (spoke != h);
  return nearest;
}

bool isThere(const EditState& state, int slot) {
  return slot >= 0 && slot < static_cast<int>(state.sites.size()) && state.isVisible(slot);
}

}  // namespace

Place Locator::locate(const EditState& state, Point p, int hint) const {
  int slot = kNone;
  double least = std::numeric_limits<double>::infinity();
  for (const int candidate : {hint, last_, startNear(state, p)}) {
    if (!isThere(state, candidate)) continue;
    if (const double distance = distanceFrom(p, state.circles[candidate]); slot == kNone || distance < least) {
      slot = candidate;
      least = distance;
    }
  }
  for (int i = 0; slot == kNone && i < static_cast<int>(state.sites.size()); ++i) {
    if (state.isVisible(i)) slot = i;
  }
  if (slot == kNone) return {};
  if (state.visibleCount < 2) return {slot, kNone};
  least = distanceFrom(p, state.circles[slot]);
  int h = state.edgeOf[slot];
  while (true) {
    h = sectorOf(state, h, p);
    const int next = state.dual.target(h);
    if (next == kPointAtInfinity) break;
    const double distance = distanceFrom(p, state.circles[next]);
    if (!(distance < least)) break;
    least = distance;
    h = state.dual.twin[h];
  }
  return {state.dual.origin[h], h};
}

int Locator::columnOf(Point p) const {
  return static_cast<int>(std::clamp((p.x - corner_.x) * scale_, 0.0, static_cast<double>(columns_ - 1)));
}

int Locator::rowOf(Point p) const {
  return static_cast<int>(std::clamp((p.y - corner_.y) * scale_, 0.0, static_cast<double>(rows_ - 1)));
}

void Locator::put(const Circle& circle, int slot) {
  const Point p = {circle.x, circle.y};
  buckets_[bucketAt(columnOf(p), rowOf(p))] = slot;
}

/// A visible circle from the bucket of a point, or from one of the rings of buckets around it; kNone if there is none.
int Locator::startNear(const EditState& state, Point p) const {
  if (buckets_.empty()) return kNone;
  const int column = columnOf(p);
  const int row = rowOf(p);
  for (int ring = 0; ring <= kMostRings; ++ring) {
    for (int y = std::max(row - ring, 0); y <= std::min(row + ring, rows_ - 1); ++y) {
      const int step = std::abs(y - row) == ring ? 1 : 2 * ring;
      for (int x = column - ring; x <= column + ring; x += step) {
        if (x < 0 || x >= columns_) continue;
        if (const int slot = buckets_[bucketAt(x, y)]; isThere(state, slot)) return slot;
      }
    }
  }
  return kNone;
}

void Locator::note(const EditState& state, int slot) {
  last_ = slot;
  if (state.visibleCount > 2 * filledFor_ + 16) {
    fill(state);
  } else if (!buckets_.empty()) {
    put(state.circles[slot], slot);
  }
}

void Locator::fill(const EditState& state) {
  filledFor_ = state.visibleCount;
  buckets_.clear();
  Point low = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point high = {-low.x, -low.y};
  for (int i = 0; i < static_cast<int>(state.sites.size()); ++i) {
    if (!state.isVisible(i)) continue;
    const Circle& c = state.circles[i];
    low = {std::min(low.x, c.x), std::min(low.y, c.y)};
    high = {std::max(high.x, c.x), std::max(high.y, c.y)};
  }
  const double width = high.x - low.x;
  const double height = high.y - low.y;
  if (!(std::max(width, height) > 0)) return;
  // Square buckets, one for two circles.
  const double wanted = std::max(1.0, filledFor_ / 2.0);
  const double side = std::max(std::sqrt(width * height / wanted), std::max(width, height) / wanted);
  corner_ = low;
  scale_ = 1 / side;
  if (!std::isfinite(scale_)) return;  // next to nothing lies between the circles: walks start anywhere
  columns_ = static_cast<int>(width * scale_) + 1;
  rows_ = static_cast<int>(height * scale_) + 1;
  buckets_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), kNone);
  for (int i = 0; i < static_cast<int>(state.sites.size()); ++i) {
    if (state.isVisible(i)) put(state.circles[i], i);
  }
  fillEmptyBuckets();
}

/// Each takes the circle of one beside it, from those that have some outwards.
void Locator::fillEmptyBuckets() {
  std::vector<int> filled;
  filled.reserve(buckets_.size());
  for (std::size_t i = 0; i < buckets_.size(); ++i) {
    if (buckets_[i] != kNone) filled.push_back(static_cast<int>(i));
  }
  for (std::size_t i = 0; i < filled.size(); ++i) {
    const int column = filled[i] % columns_;
    const int row = filled[i] / columns_;
    const auto spreadTo = [&](int x, int y) {
      if (x < 0 || x >= columns_ || y < 0 || y >= rows_ || buckets_[bucketAt(x, y)] != kNone) return;
      buckets_[bucketAt(x, y)] = buckets_[static_cast<std::size_t>(filled[i])];
      filled.push_back(static_cast<int>(bucketAt(x, y)));
    };
    spreadTo(column - 1, row);
    spreadTo(column + 1, row);
    spreadTo(column, row - 1);
    spreadTo(column, row + 1);
  }
}

}  // namespace circle_voronoi
