// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_names.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "column_names.h"
#include "json_reader.h"
#include "members.h"

namespace circle_voronoi {
namespace {

/// Properties with names of things in other programs, the most likely first (web/view/identity-columns.ts).
constexpr auto kNameProperties = std::to_array<std::string_view>(
    {"name", "label", "title", "ort", "stadt", "city", "place", "bezeichnung", "beschriftung"});

std::string nameIn(std::string_view properties) {
  std::string name;
  auto best = kNameProperties.end();
  visitMembers(properties, [&](std::string_view key, std::string_view value) {
    const auto found = std::find_if(kNameProperties.begin(), best, [&](auto known) { return isSameName(key, known); });
    if (found == best || !isIdValue(value)) return;
    best = found;
    name = value.starts_with('"') ? std::string(JsonReader(value).string()) : std::string(value);
  });
  return name;
}

}  // namespace

std::vector<std::string> namesIn(const CircleAttributes* attributes) {
  std::vector<std::string> names;
  if (attributes == nullptr) return names;
  names.reserve(attributes->properties.size());
  for (const std::string& properties : attributes->properties) names.push_back(nameIn(properties));
  return names;
}

}  // namespace circle_voronoi
