// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numeric>
#include <span>
#include <vector>

#include "circle_voronoi/index.h"
#include "circle_voronoi/point.h"

namespace circle_voronoi {

/// Square buckets over a box, each with an item that lies in it or near it: where a walk to a point may start. A bucket
/// with many items is a grid of its own, so that a walk is short however the items are distributed.
class BucketGrid {
 public:
  struct Item {
    Point place;
    int item;
  };

  /// Without buckets.
  BucketGrid() = default;

  /// About a bucket for each two items.
  explicit BucketGrid(std::span<const Item> items) {
    if (items.empty()) return;
    Point high = items.front().place;
    corner_ = high;
    for (const auto& [p, item] : items) {
      corner_ = {std::min(corner_.x, p.x), std::min(corner_.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const double width = high.x - corner_.x;
    const double height = high.y - corner_.y;
    const double wanted = std::max(1.0, static_cast<double>(items.size()) / kItemsABucket);
    const double extent = std::max(width, height);  // a product of the smallest numbers would be 0
    const double side = extent * std::max(std::sqrt(width / extent * (height / extent) / wanted), 1 / wanted);
    if (side > 0) side_ = side;  // any size does for one place
    columns_ = static_cast<int>(width / side_) + 1;
    rows_ = static_cast<int>(height / side_) + 1;
    items_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), kNone);
    for (const auto& [p, item] : items) put(p, item);
    if (extent > 0) divideCrowds(items);
    spread();
  }

  bool hasBuckets() const { return !items_.empty(); }

  std::size_t bucketCount() const { return items_.size(); }
  /// The bucket of a point, row by row. Precondition: there are buckets.
  std::size_t bucketOf(Point p) const { return at(columnOf(p), rowOf(p)); }

  /// Puts an item into the bucket of a point, in place of the one there.
  void put(Point p, int item) {
    int& there = items_[bucketOf(p)];
    if (there < kNone) {
      gridOf(there).put(p, item);
    } else {
      there = item;
    }
  }

  /// An item for which a condition holds, from the bucket of a point or from one of the layers of buckets around it, up
  /// to the number given; kNone if there is none.
  template <class Condition>
  int near(Point p, int layers, Condition holds) const {
    if (!hasBuckets()) return kNone;
    const int column = columnOf(p);
    const int row = rowOf(p);
    for (int layer = 0; layer <= layers; ++layer) {
      for (int y = std::max(row - layer, 0); y <= std::min(row + layer, rows_ - 1); ++y) {
        const int step = layer == 0 || std::abs(y - row) == layer ? 1 : 2 * layer;
        for (int x = column - layer; x <= column + layer; x += step) {
          if (x < 0 || x >= columns_) continue;
          int item = items_[at(x, y)];
          if (item < kNone) item = gridOf(item).near(p, layers, holds);
          if (item != kNone && holds(item)) return item;
        }
      }
    }
    return kNone;
  }

 private:
  static constexpr double kItemsABucket = 2;
  /// A bucket with more items is divided.
  static constexpr std::size_t kCrowd = 8;

  /// Replaces the items of buckets that have many by grids.
  void divideCrowds(std::span<const Item> items) {
    std::vector<std::size_t> ends(items_.size() + 1, 0);
    for (const Item& item : items) ++ends[bucketOf(item.place) + 1];
    if (*std::max_element(ends.begin(), ends.end()) <= kCrowd) return;
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<Item> sorted(items.size());
    for (const Item& item : items) sorted[ends[bucketOf(item.place)]++] = item;
    std::size_t begin = 0;
    for (std::size_t bucket = 0; bucket < items_.size(); ++bucket) {
      const auto crowd = std::span(sorted).subspan(begin, ends[bucket] - begin);
      begin = ends[bucket];
      if (crowd.size() <= kCrowd) continue;
      items_[bucket] = kNone - 1 - static_cast<int>(grids_.size());
      grids_.emplace_back(crowd);
    }
  }

  BucketGrid& gridOf(int item) { return grids_[static_cast<std::size_t>(kNone - 1 - item)]; }
  const BucketGrid& gridOf(int item) const { return grids_[static_cast<std::size_t>(kNone - 1 - item)]; }

  /// Gives each empty bucket an item of a neighboring bucket, starting from the buckets that have items.
  void spread() {
    std::vector<std::size_t> filled;
    filled.reserve(items_.size());
    for (std::size_t i = 0; i < items_.size(); ++i) {
      if (items_[i] != kNone) filled.push_back(i);
    }
    for (std::size_t i = 0; i < filled.size(); ++i) {
      const int column = static_cast<int>(filled[i]) % columns_;
      const int row = static_cast<int>(filled[i]) / columns_;
      const auto spreadTo = [&](int x, int y) {
        if (x < 0 || x >= columns_ || y < 0 || y >= rows_ || items_[at(x, y)] != kNone) return;
        items_[at(x, y)] = items_[filled[i]];
        filled.push_back(at(x, y));
      };
      spreadTo(column - 1, row);
      spreadTo(column + 1, row);
      spreadTo(column, row - 1);
      spreadTo(column, row + 1);
    }
  }

  int columnOf(Point p) const { return place((p.x - corner_.x) / side_, columns_); }
  int rowOf(Point p) const { return place((p.y - corner_.y) / side_, rows_); }
  static int place(double offset, int count) {
    return static_cast<int>(std::clamp(offset, 0.0, static_cast<double>(count - 1)));
  }
  std::size_t at(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }

  Point corner_;
  double side_ = 1;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<int> items_;         ///< below kNone, the number of a grid
  std::vector<BucketGrid> grids_;  ///< of the buckets with many items
};

}  // namespace circle_voronoi
