// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "at.h"
#include "infinity.h"

namespace circle_voronoi {

/// Circles that wait, each in a list of a half-edge. A list moves as a whole in one step.
class WaitingCircles {
 public:
  explicit WaitingCircles(std::size_t circleCount) : next_(circleCount, kEnd), listOf_(circleCount, kPointAtInfinity) {}

  /// The half-edge in whose list a circle was put last, or kPointAtInfinity if it does not wait.
  int listOf(int circle) const { return listOf_[at(circle)]; }

  /// From now on the circle does not wait; it is taken out of its list as that is taken.
  void leave(int circle) { listOf_[at(circle)] = kPointAtInfinity; }

  /// Reserves memory for the lists of `count` half-edges.
  void resize(std::size_t halfEdgeCount) { lists_.resize(halfEdgeCount); }

  void add(int h, int circle) {
    listOf_[at(circle)] = h;
    next_[at(circle)] = lists_[at(h)].first;
    if (lists_[at(h)].first == kEnd) lists_[at(h)].last = circle;
    lists_[at(h)].first = circle;
  }

  /// Prepends the list of one half-edge to the list of another.
  void move(int from, int to) {
    List& moved = lists_[at(from)];
    if (moved.first == kEnd) return;
    next_[at(moved.last)] = lists_[at(to)].first;
    if (lists_[at(to)].first == kEnd) lists_[at(to)].last = moved.last;
    lists_[at(to)].first = moved.first;
    moved = {};
  }

  /// Appends the circles of a list that still wait to `taken`, and empties the list.
  void take(int h, std::vector<int>& taken) {
    for (int circle = lists_[at(h)].first; circle != kEnd; circle = next_[at(circle)]) {
      if (listOf_[at(circle)] != kPointAtInfinity) taken.push_back(circle);
    }
    lists_[at(h)] = {};
  }

 private:
  static constexpr int kEnd = -1;
  struct List {
    int first = kEnd;
    int last = kEnd;
  };
  std::vector<List> lists_;  ///< of each half-edge
  std::vector<int> next_;    ///< for each circle the next one in its list
  std::vector<int> listOf_;
};

}  // namespace circle_voronoi
