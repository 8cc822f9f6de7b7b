// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi_families/families.h"

namespace circle_voronoi::test {

/// The outcome of one input.
struct TrialResult {
  std::string problem;  ///< empty: certified, and the same as the exact diagram
  std::string way;      ///< the construction that made the diagram
};

/// Computes the diagram by Method::automatic, judges it again, and compares it with the exact one; in degenerate
/// position after merging.
TrialResult tryAutomatic(std::span<const Circle> circles, bool isDegenerate);

/// Leaves out the comparison, which takes too long for many circles in degenerate position.
TrialResult tryCertified(std::span<const Circle> circles);

/// Tests circles that are tiny relative to their coordinates: the diagram is certified, exactly the circles that lie
/// inside others are hidden, and an editor's snapshot is equal. In general position the diagram is compared with the
/// exact one, too.
TrialResult tryTiny(std::span<const Circle> circles, bool isDegenerate);

/// A minimal subset of the circles that still fails, found by leaving out ever smaller parts.
std::vector<Circle> shrink(std::vector<Circle> circles, const std::function<bool(std::span<const Circle>)>& fails);

/// The number of results by each construction, by family, as a Markdown table.
class WayTable {
 public:
  void add(const std::string& family, const TrialResult& result);
  std::string text() const;
  int trials() const;
  int problems() const;

 private:
  static constexpr std::string_view kWays[] = {"flip", "repair", "insert", "touching-disc"};
  struct Row {
    std::string family;
    int ways[std::size(kWays)] = {};
    int problems = 0;
    int trials = 0;
  };
  std::vector<Row> rows_;
};

}  // namespace circle_voronoi::test
