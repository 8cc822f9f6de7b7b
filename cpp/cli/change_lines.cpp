// SPDX-License-Identifier: GPL-3.0-or-later
#include "change_lines.h"

#include <array>
#include <ostream>
#include <string_view>
#include <type_traits>
#include <vector>

#include "json_number.h"

namespace circle_voronoi::cli {
namespace {

class LineWriter {
 public:
  explicit LineWriter(std::ostream& out) : out_(out) {}

  template <class Item>
  void list(std::string_view name, const std::vector<Item>& items) {
    out_ << ", \"" << name << "\": [";
    isFirst_ = true;
    for (const Item& item : items) put(item);
    out_ << ']';
  }

 private:
  template <class Number>
  void number(Number value) {
    if (!isFirst_) out_ << ", ";
    isFirst_ = false;
    if constexpr (std::is_floating_point_v<Number>) {
      writeNumber(out_, value);
    } else {
      writeNumber(out_, std::int32_t{value});
    }
  }
  template <class... Numbers>
  void numbers(Numbers... values) {
    (number(values), ...);
  }

  void put(std::int32_t value) { number(value); }
  void put(const Circle& c) { numbers(c.x, c.y, c.r); }
  void put(const Vertex& v) { numbers(v.x, v.y, v.r); }
  void put(const std::array<CircleId, 3>& ids) { numbers(ids[0], ids[1], ids[2]); }
  void put(const HiddenCircle& hider) { numbers(hider.circle, hider.by); }
  void put(const Edge& edge) { numbers(edge.left, edge.right, edge.start, edge.end); }
  void put(const HullSide& side) { numbers(side.side, side.next); }

  std::ostream& out_;
  bool isFirst_ = true;
};

constexpr std::array<std::string_view, 3> kWays = {"local", "patch", "whole"};

}  // namespace

void writeChange(std::ostream& out, const Change& change) {
  out << "{\"way\": \"" << kWays[static_cast<std::size_t>(change.way)] << '"';
  LineWriter writer(out);
  writer.list("inserted", change.inserted);
  writer.list("removed", change.removed);
  writer.list("replaced", change.replaced);
  writer.list("circles", change.circles);
  writer.list("hidden", change.hidden);
  writer.list("hiders", change.hiders);
  writer.list("shown", change.shown);
  writer.list("cells", change.cells);
  writer.list("removedVertices", change.removedVertices);
  writer.list("addedVertices", change.addedVertices);
  writer.list("vertices", change.vertices);
  writer.list("vertexCircles", change.vertexCircles);
  writer.list("removedEdges", change.removedEdges);
  writer.list("addedEdges", change.addedEdges);
  writer.list("edges", change.edges);
  writer.list("hullSides", change.hullSides);
  out << "}\n";
}

}  // namespace circle_voronoi::cli
