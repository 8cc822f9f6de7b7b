// SPDX-License-Identifier: GPL-3.0-or-later
#include "locate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "at.h"
#include "infinity.h"
#include "vectors.h"

namespace circle_voronoi {
namespace {

/// The number of layers of buckets to search around an outdated bucket. Beyond them a walk is as quick.
constexpr int kMostLayers = 3;

/// After so many cells, a walk goes to the nearest neighbor, of kFewSpokes.
constexpr int kFewSectors = 3;
/// A cell with more half-edges around its circle has them in a list, which is used after this number of steps.
constexpr int kFewSpokes = 32;
constexpr int kFewTurns = 4;

/// Returns whether, turning counter-clockwise from `reference`, v comes no later than w.
bool isNoLater(Vector reference, Vector v, Vector w) {
  const auto isSecondHalf = [&](Vector u) {
    const double side = cross(reference, u);
    return side < 0 || (side == 0 && dot(reference, u) < 0);
  };
  if (isSecondHalf(v) != isSecondHalf(w)) return isSecondHalf(w);
  return cross(v, w) >= 0;
}

/// Returns the half-edge, of h and up to `most` others around its origin, whose target is nearest to a point.
int nearestSpoke(const EditState& state, int h, Point p, int most = std::numeric_limits<int>::max()) {
  int nearest = h;
  double least = kInfinite;
  int spoke = h;
  do {
    if (const int to = state.dual.target(spoke); to != kPointAtInfinity) {
      if (const double distance = distanceFrom(p, state.circles[at(to)]); distance < least) {
        least = distance;
        nearest = spoke;
      }
    }
    spoke = state.dual.aroundClockwise(spoke);
  } while (spoke != h && most-- > 0);
  return nearest;
}

bool isThere(const EditState& state, int slot) {
  return slot >= 0 && slot < static_cast<int>(state.slots.size()) && state.isVisible(slot);
}

}  // namespace

Location Locator::locate(const EditState& state, Point p, int hint) const {
  int slot = kNone;
  double least = kInfinite;
  const int near = starts_.near(p, kMostLayers, [&](int start) { return isThere(state, start); });
  for (const int candidate : {hint, last_, near}) {
    if (!isThere(state, candidate)) continue;
    if (const double distance = distanceFrom(p, state.circles[at(candidate)]); slot == kNone || distance < least) {
      slot = candidate;
      least = distance;
    }
  }
  for (int i = 0; slot == kNone && i < static_cast<int>(state.slots.size()); ++i) {
    if (state.isVisible(i)) slot = i;
  }
  if (slot == kNone) return {};
  if (state.visibleCount < 2) return {slot, kNone};
  least = distanceFrom(p, state.circles[at(slot)]);
  int h = state.edgeOf[at(slot)];
  int steps = 0;
  for (int sectors = 0;; ++sectors) {
    const Location sector = sectorOf(state, h, p);
    h = sector.halfEdge;
    steps += sector.steps;
    if (state.dual.target(h) == kPointAtInfinity) break;
    double distance = distanceFrom(p, state.circles[at(state.dual.target(h))]);
    if (!(distance < least)) break;
    if (sectors >= kFewSectors) {
      // A long walk may lead along the border of a large cell, which is nearer.
      const int nearest = nearestSpoke(state, h, p, kFewSpokes);
      const double its = distanceFrom(p, state.circles[at(state.dual.target(nearest))]);
      if (its < distance) {
        h = nearest;
        distance = its;
      }
    }
    least = distance;
    h = state.dual.twin[at(h)];
  }
  return {state.dual.origin[at(h)], h, steps};
}

/// Returns the half-edge, from the origin of h, in whose sector a point lies. If rounding hides the sector, returns the
/// half-edge to the nearest neighbor, which is nearer than the origin if the point is not in the cell. Turns from h,
/// and if that takes long, also from a listed half-edge.
Location Locator::sectorOf(const EditState& state, int h, Point p) const {
  const Dual& dual = state.dual;
  const int slot = dual.origin[at(h)];
  const Circle& from = state.circles[at(slot)];
  const Vector ray = {p.x - from.x, p.y - from.y};
  struct Turn {
    int spoke;
    bool isLeft;
  };
  const auto turnFrom = [&](int spoke) { return Turn{spoke, cross(state.discs.direction(spoke), ray) >= 0}; };
  std::array<Turn, 2> turns = {turnFrom(h), {}};
  std::size_t count = 1;
  int steps = 0;
  do {
    if (steps == kFewTurns) {
      if (const int listed = listedToward(state, slot, ray); listed != kNone) turns[count++] = turnFrom(listed);
    }
    for (auto& [spoke, isLeft] : std::span(turns).first(count)) {
      if (state.discs.spans(spoke, ray)) return {slot, spoke, std::max(0, steps - kFewSpokes)};
      spoke = isLeft ? dual.around(spoke) : dual.aroundClockwise(spoke);
    }
    ++steps;
  } while (turns.front().spoke != h);
  return {slot, nearestSpoke(state, h, p), steps};
}

/// Returns the last listed half-edge of a circle that is still there and comes no later than a ray; kNone without a
/// list.
int Locator::listedToward(const EditState& state, int slot, Vector ray) const {
  const auto found = spokes_.find(slot);
  if (found == spokes_.end()) return kNone;
  const std::vector<int>& spokes = found->second;
  const auto isHere = [&](int h) {
    return h < state.dual.halfEdgeCount() && state.isInUse(h / 3) && state.dual.origin[at(h)] == slot;
  };
  auto low = std::find_if(spokes.begin(), spokes.end(), isHere);
  if (low == spokes.end()) return kNone;
  const Vector reference = state.discs.direction(*low);
  for (auto high = spokes.end(); high - low > 1;) {
    const auto middle = low + (high - low) / 2;
    const auto next = std::find_if(middle, high, isHere);
    if (next != high && isNoLater(reference, state.discs.direction(*next), ray)) {
      low = next;
    } else {
      high = middle;
    }
  }
  return *low;
}

/// Lists the half-edges around the circles that have many.
void Locator::listSpokes(const EditState& state) {
  spokes_.clear();
  std::vector<int> counts(state.slots.size(), 0);
  for (int h = 0; h < state.dual.halfEdgeCount(); ++h) {
    const int slot = state.dual.origin[at(h)];
    if (slot == kPointAtInfinity || !state.isInUse(h / 3) || ++counts[at(slot)] != kFewSpokes + 1) continue;
    std::vector<int>& spokes = spokes_[slot];
    int spoke = h;
    do {
      spokes.push_back(spoke);
      spoke = state.dual.around(spoke);
    } while (spoke != h);
  }
}

void Locator::note(const EditState& state, int slot) {
  last_ = slot;
  if (state.visibleCount > 2 * filledFor_ + 16 || steps_ > state.dual.halfEdgeCount()) {
    fill(state);
  } else if (starts_.hasBuckets()) {
    starts_.put(centerOf(state.circles[at(slot)]), slot);
  }
}

void Locator::fill(const EditState& state) {
  filledFor_ = state.visibleCount;
  steps_ = 0;
  listSpokes(state);
  std::vector<BucketGrid::Item> starts;
  for (int i = 0; i < static_cast<int>(state.slots.size()); ++i) {
    if (state.isVisible(i)) starts.push_back({centerOf(state.circles[at(i)]), i});
  }
  starts_ = BucketGrid(starts);
}

}  // namespace circle_voronoi
