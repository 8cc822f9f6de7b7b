// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
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

/// What became of one input.
struct TrialResult {
  std::string problem;  ///< empty: certified, and the same as the exact diagram
  std::string way;      ///< the construction that made the diagram
};

/// Computes the diagram by Method::automatic, judges it again, and compares it with the exact one; in degenerate
/// position after merging.
TrialResult tryAutomatic(std::span<const Circle> circles, bool isDegenerate);

/// The same without the comparison, which takes too long for many circles in degenerate position.
TrialResult tryCertified(std::span<const Circle> circles);

/// The same of circles that are tiny beside their coordinates: certified, hidden circles compared with those by
/// definition, and an editor's snapshot the same; in general position compared with the exact diagram, too.
TrialResult tryTiny(std::span<const Circle> circles, bool isDegenerate);

/// As few of the circles as still fail, by leaving out ever smaller parts.
std::vector<Circle> shrink(std::vector<Circle> circles, const std::function<bool(std::span<const Circle>)>& fails);

/// How often each construction made the result, by family; a Markdown table.
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
