// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "circle_voronoi/index.h"
#include "sort_unique.h"

namespace circle_voronoi {

/// All indices from 0 to before a count, or a few of them in increasing order. Each has a row, so that arrays for a few
/// indices are short. A row is found at once among all indices, and in O(log k) steps among k of them.
class Chosen {
 public:
  /// All indices.
  explicit Chosen(std::size_t count) : count_(count) {}
  /// Some indices, in any order.
  explicit Chosen(std::vector<std::int32_t> indices) : isAll_(false), indices_(std::move(indices)) {
    sortUnique(indices_);
    count_ = indices_.size();
  }

  bool isAll() const { return isAll_; }
  std::size_t size() const { return count_; }
  /// Returns the index of a row.
  std::int32_t operator[](std::size_t row) const { return isAll_ ? static_cast<std::int32_t>(row) : indices_[row]; }
  /// Returns the row of an index, or kNone.
  std::int32_t rowOf(std::int32_t index) const {
    if (isAll_) return index;
    const auto found = std::lower_bound(indices_.begin(), indices_.end(), index);
    return found != indices_.end() && *found == index ? static_cast<std::int32_t>(found - indices_.begin()) : kNone;
  }
  bool has(std::int32_t index) const { return rowOf(index) != kNone; }

 private:
  bool isAll_ = true;
  std::size_t count_ = 0;
  std::vector<std::int32_t> indices_;
};

}  // namespace circle_voronoi
