// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "circle_voronoi/editor.h"
#include "circle_voronoi_families/families.h"

namespace circle_voronoi::test {

/// A diagram that is kept by what an editor says has changed, as a page or a worker would.
class Mirror {
 public:
  /// The contradiction between a change and the changes before; empty if there is none.
  std::string apply(const Change& change);

  /// Describes a difference between the diagram and a snapshot whose circles have these ids; empty if they are equal.
  std::string difference(const Diagram& snapshot, const std::vector<CircleId>& ids) const;

 private:
  std::string hullDifference(const Diagram& snapshot, const std::vector<CircleId>& ids) const;

  struct Corner {
    std::array<CircleId, 3> circles;
    Vertex vertex;
  };
  std::map<CircleId, Circle> circles_;
  std::map<CircleId, CircleId> hidden_;  ///< and who hides them
  std::map<std::int32_t, Corner> vertices_;
  std::map<std::int32_t, Edge> edges_;
  std::map<std::int32_t, std::int32_t> hullSides_;  ///< and which side follows
};

/// How two diagrams of the same circles differ but for the order of their vertices and edges, to the bit, hidden
/// circles and hull included; empty: not at all.
std::string differenceToTheBit(const Diagram& actual, const Diagram& expected);

struct ScriptResult {
  std::string problem;  ///< empty: after each edit the mirror is right, after some the whole
  int edits = 0;
  int ways[3] = {};  ///< how often an edit was done in each way
};

/// Random edits of circles of a family: small moves, jumps, growing and shrinking back, copies of one another, circles
/// that come, go and come back under their ids. After each tenth the snapshot is certified and that of `compute`; at
/// the end it is the exact one.
ScriptResult runScript(const FamilyInfo& family, std::size_t count, int edits, std::uint64_t seed);

/// The number of edits done in each way, by family, as a Markdown table.
class EditTable {
 public:
  void add(const std::string& family, const ScriptResult& result);
  std::string text() const;
  int edits() const;
  int problems() const;

 private:
  struct Row {
    std::string family;
    ScriptResult sum;
    int scripts = 0;
    int problems = 0;
  };
  std::vector<Row> rows_;
};

}  // namespace circle_voronoi::test
