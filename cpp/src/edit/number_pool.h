// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace circle_voronoi {

/// An allocator of numbers from 0 on. It reuses free numbers before it takes new ones. `rollBack` undoes everything
/// taken and released since a mark, at most back to the last `commit`. A released number is reused only after the next
/// `commit`.
class NumberPool {
 public:
  explicit NumberPool(int used = 0) : count_(used), committed_(used) {}

  /// Returns an upper bound: all numbers in use are below it.
  int count() const { return count_; }

  int take() { return freeLeft_ > 0 ? free_[--freeLeft_] : count_++; }
  void release(int number) { released_.push_back(number); }

  struct Mark {
    std::size_t freeLeft;
    int count;
    std::size_t released;
  };
  Mark mark() const { return {freeLeft_, count_, released_.size()}; }
  void rollBack(const Mark& mark) noexcept {
    freeLeft_ = mark.freeLeft;
    count_ = mark.count;
    released_.resize(mark.released);
  }

  /// Reserves memory so that `commit` does not allocate.
  void prepare() {
    const std::size_t needed = freeLeft_ + released_.size();
    if (needed > free_.capacity()) free_.reserve(std::max(needed, 2 * free_.capacity()));
  }
  void commit() noexcept {
    free_.resize(freeLeft_);
    free_.insert(free_.end(), released_.begin(), released_.end());
    released_.clear();
    freeLeft_ = free_.size();
    committed_ = count_;
  }
  void rollBackAll() noexcept { rollBack({free_.size(), committed_, 0}); }

 private:
  std::vector<int> free_;
  std::size_t freeLeft_ = 0;  ///< the count of numbers in free_ that are not taken
  std::vector<int> released_;
  int count_;
  int committed_;
};

}  // namespace circle_voronoi
