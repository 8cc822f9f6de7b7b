// SPDX-License-Identifier: GPL-3.0-or-later
#include "locate.h"

#include <algorithm>
#include <cmath>

#include "infinity.h"

namespace circle_voronoi {
namespace {

/// The number of layers of buckets to search around an outdated bucket. Beyond them a walk is as quick.
constexpr int kMostLayers = 3;
constexpr double kCirclesABucket = 2;

/// Returns the half-edge, from the origin of h, in whose sector a point lies. If rounding hides the sector, returns the
/// half-edge to the nearest neighbor, which is nearer than the origin if the point is not in the cell.
int sectorOf(const EditState& state, int h, Point p) {
  const Dual& dual = state.dual;
  const Circle& from = state.circles[dual.origin[h]];
  const Vector ray = {p.x - from.x, p.y - from.y};
  const bool isLeft = cross(state.discs.direction(h), ray) >= 0;
  int spoke = h;
  do {
    if (state.discs.spans(spoke, ray)) return spoke;
    spoke = isLeft ? dual.around(spoke) : dual.aroundClockwise(spoke);
  } while (spoke != h);
  int nearest = h;
  double least = kInfinite;
  do {
    if (const int to = dual.target(spoke); to != kPointAtInfinity) {
      if (const double distance = distanceFrom(p, state.circles[to]); distance < least) {
        least = distance;
        nearest = spoke;
      }
    }
    spoke = dual.aroundClockwise(spoke);
  } while (spoke != h);
  return nearest;
}

bool isThere(const EditState& state, int slot) {
  return slot >= 0 && slot < static_cast<int>(state.sites.size()) && state.isVisible(slot);
}

}  // namespace

Location Locator::locate(const EditState& state, Point p, int hint) const {
  int slot = kNone;
  double least = kInfinite;
  const int near = starts_.near(p, kMostLayers, [&](int start) { return isThere(state, start); });
  for (const int candidate : {hint, last_, near}) {
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

void Locator::note(const EditState& state, int slot) {
  last_ = slot;
  if (state.visibleCount > 2 * filledFor_ + 16) {
    fill(state);
  } else if (starts_.hasBuckets()) {
    starts_.put(centerOf(state.circles[slot]), slot);
  }
}

void Locator::fill(const EditState& state) {
  filledFor_ = state.visibleCount;
  starts_ = {};
  if (filledFor_ == 0) return;
  Point low = {kInfinite, kInfinite};
  Point high = {-kInfinite, -kInfinite};
  const auto forEachVisible = [&](auto visit) {
    for (int i = 0; i < static_cast<int>(state.sites.size()); ++i) {
      if (state.isVisible(i)) visit(i, centerOf(state.circles[i]));
    }
  };
  forEachVisible([&](int, Point p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  });
  starts_ = BucketGrid(low, high, filledFor_ / kCirclesABucket);
  forEachVisible([&](int i, Point p) { starts_.put(p, i); });
  starts_.spread();
}

}  // namespace circle_voronoi
