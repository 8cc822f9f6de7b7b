// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace circle_voronoi {

/// A set of integers below a fixed size that finds the next and the previous member quickly: a tree of 64-bit words in
/// which a bit is set when the word below it is not zero.
class SlotSet {
 public:
  static constexpr std::ptrdiff_t kNoSlot = -1;

  explicit SlotSet(std::size_t size) {
    do {
      size = (size + 63) / 64;
      levels_.emplace_back(size, 0);
    } while (size > 1);
  }

  void insert(std::ptrdiff_t slot) {
    for (auto& level : levels_) {
      level[word(slot)] |= bit(slot);
      slot /= 64;
    }
  }

  void erase(std::ptrdiff_t slot) {
    for (auto& level : levels_) {
      if ((level[word(slot)] &= ~bit(slot)) != 0) return;
      slot /= 64;
    }
  }

  bool contains(std::ptrdiff_t slot) const { return (levels_[0][word(slot)] & bit(slot)) != 0; }

  /// The first member at or after `from` and before `end`, or kNoSlot.
  std::ptrdiff_t firstIn(std::ptrdiff_t from, std::ptrdiff_t end) const {
    if (from >= end) return kNoSlot;
    std::ptrdiff_t position = from;
    for (std::size_t up = 0; up < levels_.size(); ++up) {
      if (word(position) >= levels_[up].size()) return kNoSlot;
      std::uint64_t rest = levels_[up][word(position)] & (~std::uint64_t{0} << (position % 64));
      if (rest != 0) {
        position = position / 64 * 64 + std::countr_zero(rest);
        for (std::size_t down = up; down-- > 0;) {
          position = position * 64 + std::countr_zero(levels_[down][static_cast<std::size_t>(position)]);
        }
        return position < end ? position : kNoSlot;
      }
      position = position / 64 + 1;
    }
    return kNoSlot;
  }

  /// The last member at or after `begin` and before `end`, or kNoSlot.
  std::ptrdiff_t lastIn(std::ptrdiff_t begin, std::ptrdiff_t end) const {
    if (begin >= end) return kNoSlot;
    std::ptrdiff_t position = end - 1;
    for (std::size_t up = 0; up < levels_.size(); ++up) {
      std::uint64_t rest = levels_[up][word(position)] & (~std::uint64_t{0} >> (63 - position % 64));
      if (rest != 0) {
        position = position / 64 * 64 + 63 - std::countl_zero(rest);
        for (std::size_t down = up; down-- > 0;) {
          position = position * 64 + 63 - std::countl_zero(levels_[down][static_cast<std::size_t>(position)]);
        }
        return position >= begin ? position : kNoSlot;
      }
      position = position / 64 - 1;
      if (position < 0) return kNoSlot;
    }
    return kNoSlot;
  }

 private:
  static std::size_t word(std::ptrdiff_t slot) { return static_cast<std::size_t>(slot) / 64; }
  static std::uint64_t bit(std::ptrdiff_t slot) { return std::uint64_t{1} << (slot % 64); }

  std::vector<std::vector<std::uint64_t>> levels_;
};

}  // namespace circle_voronoi
