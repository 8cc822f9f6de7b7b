// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rotation system of the event loop: the cyclic order of the directed edges (DEs) around each circle.
//
// Every candidate pair {a, b} has a slot on a and a slot on b. The slots of a circle are sorted once,
// counter-clockwise, by the direction to the partner, and a DE never leaves the slots of the circles it joins: where a
// three-touch disc replaces DE(a,b) and DE(b,c) by DE(a,c), the latter starts in the slot where DE(a,b) started and
// ends in the slot where DE(b,c) ended. Hence ties of angles cannot disturb the cyclic order.
//
// A slot holds at most one DE that starts there ("out") and one that ends there ("in"). Seen from the circle, a DE that
// starts looks clockwise for its disc of R_max, one that ends looks counter-clockwise:
//
//              in ──►  unused arc  ◄── out|in ──►  unused arc  ◄── out      (counter-clockwise)
//
// Between an out and the next in lies an arc that is used up (or nothing, where an antipodal disc placed both).
// Two DEs that face each other across an unused arc are parametrically adjacent and may form a three-touch disc.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "at.h"
#include "circle_voronoi/circle.h"
#include "pair.h"
#include "portable.h"
#include "slot_set.h"
#include "vectors.h"

namespace circle_voronoi {

/// The index that marks the absence of a directed edge.
inline constexpr int kNoEdge = -1;

/// A directed edge from circle a to circle b; its Voronoi segment lies to its right (paper, section 2.1).
struct DirectedEdge {
  int a = 0;
  int b = 0;
  int slotA = 0;
  int slotB = 0;
  int edge = 0;        ///< the Voronoi edge that its segment belongs to
  bool isEnd = false;  ///< whether the segment leads to the end of that edge, or to its start
  Vector fromA;        ///< from the center of a to the center of the disc of R_min
  Vector fromB;
};

class RotationSystem {
 public:
  /// The slots of a pair, on its first and on its second circle.
  using Slots = std::array<int, 2>;

  RotationSystem(std::span<const Circle> circles, std::span<const Pair> pairs);

  /// Moves out the slots of each pair.
  std::vector<Slots> takeSlots() { return std::move(pairSlots_); }

  const DirectedEdge& edge(int index) const { return edges_[at(index)]; }

  /// Returns whether a DE that was placed has not been removed.
  bool isAlive(int index) const { return slots_[at(edges_[at(index)].slotA)].out == index; }

  /// Puts a DE into its slots, which hold no other, and returns its index.
  int place(const DirectedEdge& edge) {
    const int index = static_cast<int>(edges_.size());
    edges_.push_back(edge);
    slots_[at(edge.slotA)].out = index;
    slots_[at(edge.slotB)].in = index;
    occupied_.insert(edge.slotA);
    occupied_.insert(edge.slotB);
    return index;
  }

  void remove(int index) {
    const DirectedEdge& edge = edges_[at(index)];
    slots_[at(edge.slotA)].out = kNoEdge;
    slots_[at(edge.slotB)].in = kNoEdge;
    for (const int slot : {edge.slotA, edge.slotB}) {
      if (slots_[at(slot)].out == kNoEdge && slots_[at(slot)].in == kNoEdge) occupied_.erase(slot);
    }
  }

  /// The DE that faces the end of `edge` across the unused arc of circle b, kNoEdge if there is none.
  int adjacentAfter(const DirectedEdge& edge) const { return slots_[at(slotAfter(edge.b, edge.slotB))].out; }

  /// The DE that faces the start of `edge` across the unused arc of circle a.
  int adjacentBefore(const DirectedEdge& edge) const { return slots_[at(slotBefore(edge.a, edge.slotA))].in; }

  /// The DEs that bound the arc of a circle around a slot, counter-clockwise: `in` ends before the slot, and `out`
  /// starts after it. If one is missing, the arc is used up.
  struct Arc {
    int in = kNoEdge;
    int out = kNoEdge;
    bool isWhole = false;  ///< whether both are in one slot, so that the arc is the whole circle

    bool isUsed() const { return in == kNoEdge || out == kNoEdge; }
  };
  Arc arcAt(int circle, int slot) const {
    const std::ptrdiff_t before = slotBefore(circle, slot);
    if (before == SlotSet::kNoSlot) return {};
    const std::ptrdiff_t after = slotAfter(circle, slot);
    return {slots_[at(before)].in, slots_[at(after)].out, before == after};
  }

  /// Returns the remaining DEs in cycles of adjacent DEs, each as the list of the circles that they start from.
  std::vector<std::vector<int>> cycles() const;

  void prefetchSlot(int slot) const { prefetch(&slots_[at(slot)]); }
  void prefetchEdge(int index) const { prefetch(&edges_[at(index)]); }

 private:
  /// The DEs that start and end in a slot.
  struct Slot {
    int out = kNoEdge;
    int in = kNoEdge;
  };

  /// The occupied slot of a circle that follows `slot` counter-clockwise, `slot` itself last; SlotSet::kNoSlot if none.
  std::ptrdiff_t slotAfter(int circle, int slot) const {
    const std::ptrdiff_t found = occupied_.firstIn(slot + 1, firstSlot_[at(circle + 1)]);
    return found != SlotSet::kNoSlot ? found : occupied_.firstIn(firstSlot_[at(circle)], slot + 1);
  }

  std::ptrdiff_t slotBefore(int circle, int slot) const {
    const std::ptrdiff_t found = occupied_.lastIn(firstSlot_[at(circle)], slot);
    return found != SlotSet::kNoSlot ? found : occupied_.lastIn(slot, firstSlot_[at(circle + 1)]);
  }

  std::vector<int> firstSlot_;  ///< the first slot of each circle, and the number of slots
  std::vector<Slot> slots_;
  SlotSet occupied_;
  std::vector<DirectedEdge> edges_;
  std::vector<Slots> pairSlots_;
};

}  // namespace circle_voronoi
