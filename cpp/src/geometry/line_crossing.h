// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "circle_voronoi/curve.h"
#include "circle_voronoi/index.h"
#include "vectors.h"

namespace circle_voronoi {

/// The crossings of a branch and the line through a point in a direction.
class LineCrossing {
 public:
  LineCrossing(const Bisector& bisector, Point p, Vector direction);

  /// Returns the parameters in increasing order: none, one or two.
  std::span<const double> parameters() const& { return {parameters_.data(), count_}; }
  std::span<const double> parameters() const&& = delete;

 private:
  std::size_t count_ = 0;
  std::array<double, 2> parameters_ = {};
};

}  // namespace circle_voronoi
