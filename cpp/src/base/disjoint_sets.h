// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "at.h"

namespace circle_voronoi {

/// Disjoint sets of indices (union-find). The smallest index of a set represents it.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

  /// Adds a set of one index, and returns the index.
  std::int32_t add() {
    parent_.push_back(static_cast<std::int32_t>(parent_.size()));
    return parent_.back();
  }

  std::int32_t find(std::int32_t i) {
    while (parent_[at(i)] != i) i = parent_[at(i)] = parent_[at(parent_[at(i)])];
    return i;
  }

  /// Joins the sets of two indices. Returns whether they were apart.
  bool join(std::int32_t i, std::int32_t j) {
    i = find(i);
    j = find(j);
    parent_[at(std::max(i, j))] = std::min(i, j);
    return i != j;
  }

  /// Returns the representative of each index.
  std::vector<std::int32_t> representatives() && {
    for (std::int32_t& parent : parent_) parent = parent_[at(parent)];  // of a smaller index, and so done before
    return std::move(parent_);
  }

 private:
  std::vector<std::int32_t> parent_;
};

}  // namespace circle_voronoi
