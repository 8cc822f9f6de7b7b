// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <ranges>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/index.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

/// The sides of a cell from the first, each found from the one before: a range of SideIndex, which the diagram must
/// outlive.
class Sides : public std::ranges::view_base {
 public:
  class Iterator {
   public:
    using value_type = SideIndex;
    using difference_type = std::ptrdiff_t;
    using iterator_category = std::forward_iterator_tag;

    Iterator() = default;
    Iterator(const SideIndex* next, SideIndex first) : next_(next), first_(first), side_(first) {}

    SideIndex operator*() const { return side_; }
    Iterator& operator++() {
      side_ = next_[side_];
      if (side_ == first_) side_ = kNone;
      return *this;
    }
    Iterator operator++(int) {
      const Iterator before = *this;
      ++*this;
      return before;
    }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.side_ == b.side_; }

   private:
    const SideIndex* next_ = nullptr;
    SideIndex first_;
    SideIndex side_;  ///< kNone: behind the last
  };

  Sides(const std::vector<SideIndex>& nextSide, SideIndex first) : next_(nextSide.data()), first_(first) {}

  Iterator begin() const { return {next_, first_}; }
  Iterator end() const { return {}; }
  bool empty() const { return first_ == kNone; }
  /// Of sides that are not empty.
  SideIndex front() const { return first_; }

 private:
  const SideIndex* next_;
  SideIndex first_;
};

}  // namespace circle_voronoi
