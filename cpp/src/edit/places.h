// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace circle_voronoi {

/// Numbers from 0 on, of which some are in use: the least number of them, as those that are free are used again. What
/// is taken and released can be taken back, up to the last time that it was kept; until then nothing released is taken.
class Places {
 public:
  explicit Places(int used = 0) : count_(used), kept_(used) {}

  /// All numbers are below.
  int count() const { return count_; }

  int take() { return freeLeft_ > 0 ? free_[--freeLeft_] : count_++; }
  void release(int place) { released_.push_back(place); }

  struct Mark {
    std::size_t freeLeft;
    int count;
    std::size_t released;
  };
  Mark mark() const { return {freeLeft_, count_, released_.size()}; }
  void takeBack(const Mark& mark) noexcept {
    freeLeft_ = mark.freeLeft;
    count_ = mark.count;
    released_.resize(mark.released);
  }

  /// So that `keep` needs no memory.
  void prepare() {
    const std::size_t needed = freeLeft_ + released_.size();
    if (needed > free_.capacity()) free_.reserve(std::max(needed, 2 * free_.capacity()));
  }
  void keep() noexcept {
    free_.resize(freeLeft_);
    free_.insert(free_.end(), released_.begin(), released_.end());
    released_.clear();
    freeLeft_ = free_.size();
    kept_ = count_;
  }
  void takeAllBack() noexcept { takeBack({free_.size(), kept_, 0}); }

 private:
  std::vector<int> free_;
  std::size_t freeLeft_ = 0;  ///< of them, those that are not taken
  std::vector<int> released_;
  int count_;
  int kept_;
};

}  // namespace circle_voronoi
