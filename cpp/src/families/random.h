// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "vectors.h"

namespace circle_voronoi {

/// 10 to the power of `exponent`, within a few units of the last place and with the same bits on every platform.
double powerOfTen(double exponent);

/// The unit vector at `turns` full turns counter-clockwise from the x axis, within a few units of the last place and
/// with the same bits on every platform.
Vector directionAt(double turns);

/// Random numbers that are the same on every platform (splitmix64 by Sebastiano Vigna, public domain).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }

  /// In [0, 1).
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  /// In [low, high).
  double uniform(double low, double high) { return low + (high - low) * unit(); }
  /// In [0, count).
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }
  /// 10 to a power that is uniform in [low, high).
  double logUniform(double low, double high) { return powerOfTen(uniform(low, high)); }
  Vector direction() { return directionAt(unit()); }

  /// Mean 0 and variance 1; the sum of twelve uniform numbers is near enough to normal.
  double gaussian() {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += unit();
    return sum;
  }

  template <class Item>
  void shuffle(std::vector<Item>& items) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[below(i)]);
  }

 private:
  std::uint64_t state_;
};

}  // namespace circle_voronoi
