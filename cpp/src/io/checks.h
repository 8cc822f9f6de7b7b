// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "circle_voronoi/attributes.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/tile.h"
#include "guarded.h"
#include "members.h"

namespace circle_voronoi {

/// Errors: badInput if the numbers of vertexCircles and vertices differ.
inline Result<void> checkVertices(const Diagram& diagram) {
  if (diagram.vertexCircles.size() == diagram.vertices.size()) return {};
  return errorWith(ErrorCode::badInput, "There are not as many vertexCircles as vertices.");
}

/// Errors: badOption if a number of digits after the decimal point is negative.
inline Result<void> checkDigits(std::optional<int> digits) {
  if (!digits || *digits >= 0) return {};
  return errorWith(ErrorCode::badOption, "The number of digits must not be negative.");
}

/// Errors: badInput if a list of attributes is not empty and does not have an entry for each circle, or an entry is not
/// such JSON.
inline Result<void> checkAttributes(const CircleAttributes& attributes, std::size_t circleCount) {
  for (const auto* list : {&attributes.properties, &attributes.ids, &attributes.heights}) {
    if (!list->empty() && list->size() != circleCount) {
      return errorWith(ErrorCode::badInput, "There are not as many attributes as circles.");
    }
  }
  return guarded([&]() -> Result<void> {
    const auto areMembers = [](const std::string& text) { return text.empty() || isJsonLine("{" + text + "}"); };
    const auto check = [](const std::vector<std::string>& list, const char* what, auto isRight) {
      const auto wrong = std::ranges::find_if_not(list, isRight);
      if (wrong == list.end()) return;
      const std::int64_t circle = wrong - list.begin();
      throw ThrownError{{ErrorCode::badInput, circle, "Circle " + std::to_string(circle) + ": " + what + " in JSON."}};
    };
    check(attributes.properties, "the properties are not members of an object", areMembers);
    check(attributes.ids, "the id is not a string or a number",
          [](const std::string& text) { return text.empty() || (isIdValue(text) && isJsonLine(text)); });
    check(attributes.heights, "the height is not a number",
          [](const std::string& text) { return text.empty() || isJsonNumber(text); });
    if (areMembers(attributes.collection)) return {};
    return errorWith(ErrorCode::badInput, "The collection of attributes is not members of an object in JSON.");
  });
}

/// Errors: badInput if a span of a selection does not have an entry for each circle.
inline Result<void> checkSelection(const Selection& selection, std::size_t circleCount) {
  const auto fits = [&](std::size_t size) { return size == 0 || size == circleCount; };
  if (fits(selection.ids.size()) && fits(selection.isChosen.size())) return {};
  return errorWith(ErrorCode::badInput, "The selection does not have as many entries as there are circles.");
}

}  // namespace circle_voronoi
