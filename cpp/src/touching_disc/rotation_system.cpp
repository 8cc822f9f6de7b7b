// SPDX-License-Identifier: GPL-3.0-or-later
#include "rotation_system.h"

#include <algorithm>

#include "angle.h"
#include "at.h"

namespace circle_voronoi {

RotationSystem::RotationSystem(std::span<const Circle> circles, std::span<const Pair> pairs)
    : firstSlot_(circles.size() + 1, 0),
      slots_(2 * pairs.size()),
      occupied_(2 * pairs.size()),
      pairSlots_(pairs.size()) {
  edges_.reserve(2 * pairs.size());
  const int n = static_cast<int>(circles.size());
  for (const auto& [a, b] : pairs) {
    ++firstSlot_[at(a + 1)];
    ++firstSlot_[at(b + 1)];
  }
  for (int i = 0; i < n; ++i) firstSlot_[at(i + 1)] += firstSlot_[at(i)];

  struct Spoke {
    double angle;
    int pair;
    bool atB;
  };
  std::vector<Spoke> spokes(2 * pairs.size());
  std::vector<int> fill(firstSlot_.begin(), firstSlot_.end() - 1);
  for (std::size_t pair = 0; pair < pairs.size(); ++pair) {
    const auto [a, b] = pairs[pair];
    const Vector v = between(circles[at(a)], circles[at(b)]);
    spokes[at(fill[at(a)]++)] = {pseudoAngle(v), static_cast<int>(pair), false};
    spokes[at(fill[at(b)]++)] = {pseudoAngle({-v.x, -v.y}), static_cast<int>(pair), true};
  }
  for (int i = 0; i < n; ++i) {
    std::sort(spokes.begin() + firstSlot_[at(i)], spokes.begin() + firstSlot_[at(i + 1)],
              [](const Spoke& s, const Spoke& t) { return s.angle != t.angle ? s.angle < t.angle : s.pair < t.pair; });
  }
  for (std::size_t slot = 0; slot < spokes.size(); ++slot) {
    pairSlots_[at(spokes[slot].pair)][spokes[slot].atB ? 1 : 0] = static_cast<int>(slot);
  }
}

std::vector<std::vector<int>> RotationSystem::cycles() const {
  std::vector<std::vector<int>> cycles;
  std::vector<bool> seen(edges_.size(), false);
  for (const Slot& slot : slots_) {
    int index = slot.out;
    if (index == kNoEdge || seen[at(index)]) continue;
    std::vector<int> cycle;
    while (index != kNoEdge && !seen[at(index)]) {
      seen[at(index)] = true;
      cycle.push_back(edges_[at(index)].a);
      index = adjacentAfter(edges_[at(index)]);
    }
    cycles.push_back(std::move(cycle));
  }
  return cycles;
}

}  // namespace circle_voronoi
