// SPDX-License-Identifier: GPL-3.0-or-later
#include "spatial_order.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "at.h"

namespace circle_voronoi {
namespace {

constexpr int kHilbertBits = 16;
constexpr int kDigitBits = 11;
/// More points than this in one cell get a curve of their own.
constexpr std::size_t kCrowd = 8;

struct Keyed {
  std::uint32_t key = 0;
  int index = 0;
};

/// Returns the position of a cell along the Hilbert curve of order kHilbertBits (H. S. Warren, "Hacker's Delight",
/// section 16-2).
std::uint32_t hilbertKey(std::uint32_t x, std::uint32_t y) {
  std::uint32_t key = 0;
  for (int bit = kHilbertBits - 1; bit >= 0; --bit) {
    const std::uint32_t right = (x >> bit) & 1;
    const std::uint32_t upper = (y >> bit) & 1;
    key = (key << 2) | ((3 * right) ^ upper);
    // In the lower half the axes are swapped, and on its right also reversed. Masks do this because branches would be
    // mispredicted.
    const std::uint32_t isLower = upper - 1;
    const std::uint32_t isBackwards = isLower & (0u - right);
    const std::uint32_t change = (x ^ y) & isLower;
    x ^= change ^ isBackwards;
    y ^= change ^ isBackwards;
  }
  return key;
}

class SpatialOrder {
 public:
  SpatialOrder(std::span<const Point> points, Threads threads)
      : points_(points), threads_(threads), items_(points.size()), other_(points.size()) {
    for (std::size_t i = 0; i < points.size(); ++i) items_[i].index = static_cast<int>(i);
    runs_.push_back({0, items_.size()});
    // A cell is 2^16 times smaller than its box, so the range of double soon ends this loop.
    while (!runs_.empty()) {
      const Run run = runs_.back();
      runs_.pop_back();
      orderRun(run);
    }
  }

  std::vector<int> indices() const {
    std::vector<int> indices;
    indices.reserve(items_.size());
    for (const Keyed& item : items_) indices.push_back(item.index);
    return indices;
  }

 private:
  /// The items from `begin` to before `end`, which lie in one cell of the curve at its current depth.
  struct Run {
    std::size_t begin, end;
  };

  /// Orders a run along the curve through its own bounding box, and notes the cells that hold many points.
  void orderRun(Run run) {
    const std::span<Keyed> items = std::span(items_).subspan(run.begin, run.end - run.begin);
    if (!setKeys(items)) return;
    if (items.size() > (1u << kDigitBits)) {
      sortByKey(items);
    } else {
      std::stable_sort(items.begin(), items.end(), [](const Keyed& a, const Keyed& b) { return a.key < b.key; });
    }
    std::size_t begin = 0;
    for (std::size_t i = 1; i <= items.size(); ++i) {
      if (i < items.size() && items[i].key == items[begin].key) continue;
      if (i - begin > kCrowd) {
        runs_.push_back({run.begin + begin, run.begin + i});
      } else if (i - begin > 1) {
        bringTogether(items.subspan(begin, i - begin));
      }
      begin = i;
    }
  }

  /// Sorts a cell so that equal points follow one another.
  void bringTogether(std::span<Keyed> cell) const {
    std::stable_sort(cell.begin(), cell.end(), [this](const Keyed& a, const Keyed& b) {
      const Point& p = points_[at(a.index)];
      const Point& q = points_[at(b.index)];
      return p.x != q.x ? p.x < q.x : p.y < q.y;
    });
  }

  /// Sets the key of each item on the curve through their bounding box. Returns false if all points are equal.
  bool setKeys(std::span<Keyed> items) const {
    if (items.empty()) return false;
    Point low = points_[at(items[0].index)];
    Point high = low;
    for (const Keyed& item : items) {
      const Point& p = points_[at(item.index)];
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    // The number of cells per unit must be finite, however small the box.
    const double extent = std::max(high.x - low.x, high.y - low.y);
    const double magnification = extent < 0x1p-900 ? 0x1p1000 : 1;
    const double size = extent * magnification;
    if (size == 0) return false;
    const double cells = ((1u << kHilbertBits) - 1) / size;
    threads_.forEach(items.size(), [&](std::size_t i) {
      const Point& p = points_[at(items[i].index)];
      items[i].key = hilbertKey(static_cast<std::uint32_t>((p.x - low.x) * magnification * cells),
                                static_cast<std::uint32_t>((p.y - low.y) * magnification * cells));
    });
    return true;
  }

  /// Sorts items by key, digit by digit. The sort is stable.
  void sortByKey(std::span<Keyed> items) {
    for (int shift = 0; shift < 2 * kHilbertBits; shift += kDigitBits) {
      std::array<std::size_t, (1u << kDigitBits) + 1> first{};
      const auto digit = [shift](const Keyed& item) {
        return static_cast<std::size_t>((item.key >> shift) & ((1u << kDigitBits) - 1));
      };
      for (const Keyed& item : items) ++first[digit(item) + 1];
      for (std::size_t d = 1; d < first.size(); ++d) first[d] += first[d - 1];
      for (const Keyed& item : items) other_[first[digit(item)]++] = item;
      std::copy_n(other_.begin(), items.size(), items.begin());
    }
  }

  std::span<const Point> points_;
  Threads threads_;
  std::vector<Keyed> items_;
  std::vector<Keyed> other_;
  std::vector<Run> runs_;
};

}  // namespace

std::vector<int> spatialOrder(std::span<const Point> points, Threads threads) {
  return SpatialOrder(points, threads).indices();
}

}  // namespace circle_voronoi
