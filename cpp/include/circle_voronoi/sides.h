// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <iterator>
#include <ranges>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/index.h"

namespace circle_voronoi {

/// The sides of a cell in counter-clockwise order: a range of SideIndex. The diagram must outlive it.
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
    SideIndex side_;  ///< kNone after the last side
  };

  Sides(const std::vector<SideIndex>& nextSide, SideIndex first) : next_(nextSide.data()), first_(first) {}

  [[nodiscard]] Iterator begin() const { return {next_, first_}; }
  [[nodiscard]] Iterator end() const { return {}; }
  [[nodiscard]] bool empty() const { return first_ == kNone; }
  /// Returns the first side. Precondition: the range is not empty.
  [[nodiscard]] SideIndex front() const { return first_; }

 private:
  const SideIndex* next_;
  SideIndex first_;
};

}  // namespace circle_voronoi
