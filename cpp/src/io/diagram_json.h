// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "circle_voronoi/attributes.h"
#include "circle_voronoi/diagram.h"
#include "writer.h"

namespace circle_voronoi {

/// `[` the items, each written by `item(i)`, a line each, `]`.
template <class Item>
void writeLines(Writer& out, std::size_t count, Item item) {
  out << "[";
  for (std::size_t i = 0; i < count; ++i) {
    out << (i == 0 ? "\n  " : ",\n  ");
    item(i);
  }
  out << (count == 0 ? "]" : "\n ]");
}

/// Writes the height, the id and the properties of a circle as further members of its object.
void writeAttributeMembers(Writer& out, const CircleAttributes& attributes, std::size_t circle);

/// Writes the hidden circles, as lines. `name` is the member for the circle.
void writeHidden(Writer& out, std::span<const HiddenCircle> hidden, std::string_view name);

/// Writes the edges, as lines. `name` is the member for the two circles.
void writeEdges(Writer& out, std::span<const Edge> edges, std::string_view name);

/// Writes a diagram in the format of `writeJson`. `writeMore` may write further members, each with a comma after it.
void writeDiagram(Writer& out, const Diagram& diagram, std::optional<int> digits, const CircleAttributes& attributes,
                  const std::function<void()>& writeMore);

}  // namespace circle_voronoi
