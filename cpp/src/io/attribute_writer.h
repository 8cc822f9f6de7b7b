// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "circle_voronoi/attributes.h"
#include "column_names.h"
#include "members.h"
#include "writer.h"

namespace circle_voronoi {

/// Returns the entry of a circle in a list of attributes, which may be empty.
inline std::string_view entryOf(const std::vector<std::string>& list, std::size_t circle) {
  return list.empty() ? std::string_view() : std::string_view(list[circle]);
}

/// Returns whether there is a member of this name.
inline bool hasMember(std::string_view members, std::string_view name) {
  bool isFound = false;
  visitMembers(members, [&](std::string_view other, std::string_view) { isFound = isFound || other == name; });
  return isFound;
}

/// Visits the properties of a circle, renamed where a name belongs to the file's own members: `isOwn(name)` returns
/// whether it does. `visit(name, value)` gets the JSON of the value. Skips a property that repeats the id or the height
/// under the name of the file's own member for it.
template <class IsOwn, class Visit>
void visitProperties(const CircleAttributes& attributes, std::size_t circle, IsOwn isOwn, Visit visit) {
  const std::string_view id = entryOf(attributes.ids, circle);
  const std::string_view height = entryOf(attributes.heights, circle);
  visitMembers(entryOf(attributes.properties, circle), [&](std::string_view name, std::string_view value) {
    if (!isOwn(name)) return visit(name, value);
    const bool isId = isSameName(name, "id");
    const std::string_view repeated = isId ? id : isSameName(name, "z") ? height : std::string_view();
    const bool isRepeated =
        value == repeated || (repeated.empty() && value == "null" && (isId || isSameName(name, "z")));
    if (isRepeated) return;
    std::string own = "input_" + std::string(name);
    while (hasMember(entryOf(attributes.properties, circle), own)) own.insert(0, "input_");
    visit(std::string_view(own), value);
  });
}

/// Writes the beginning of a collection, up to its features. `attributes` may be null, and `box` if cells are not cut.
inline void writeCollectionStart(Writer& out, const CircleAttributes* attributes, const Box* box = nullptr) {
  out << R"({"type":"FeatureCollection",)";
  if (box != nullptr) {
    out << R"("bbox":[)" << box->minX << "," << box->minY << "," << box->maxX << "," << box->maxY << "],";
  }
  if (attributes != nullptr) {
    visitMembers(attributes->collection, [&](std::string_view name, std::string_view value) {
      if (name != "type" && name != "features" && name != "bbox") out << jsonString(name) << ":" << value << ",";
    });
  }
  out << R"("features":[)";
}

/// Writes the beginning of a feature, up to its properties. `attributes` may be null.
inline void writeFeatureStart(Writer& out, const CircleAttributes* attributes, std::size_t circle) {
  out << R"({"type":"Feature",)";
  if (attributes != nullptr) {
    if (const auto id = entryOf(attributes->ids, circle); !id.empty()) out << R"("id":)" << id << ",";
  }
  out << R"("properties":{)";
}

}  // namespace circle_voronoi
