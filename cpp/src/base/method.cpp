// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/method.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace circle_voronoi {
namespace {

// In the order of the enumerations.
constexpr auto kMethodNames = std::to_array<std::string_view>({"auto", "touching-disc", "flip"});
constexpr auto kCandidatesNames = std::to_array<std::string_view>({"dynamic", "uniform", "all-pairs"});
constexpr auto kWayNames =
    std::to_array<std::string_view>({"flip", "repair", "insert", "apollonius-graph", "touching-disc", "edit"});

template <class Value, std::size_t count>
std::string_view nameIn(const std::array<std::string_view, count>& names, Value value) {
  const auto i = static_cast<std::size_t>(value);
  return i < count ? names[i] : std::string_view();
}

template <class Value, std::size_t count>
std::optional<Value> valueIn(const std::array<std::string_view, count>& names, std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Value>(found - names.begin());
}

}  // namespace

std::string_view methodName(Method method) { return nameIn(kMethodNames, method); }
std::string_view candidatesName(Candidates candidates) { return nameIn(kCandidatesNames, candidates); }
std::string_view wayName(Way way) { return nameIn(kWayNames, way); }

std::optional<Method> methodFromName(std::string_view name) { return valueIn<Method>(kMethodNames, name); }
std::optional<Candidates> candidatesFromName(std::string_view name) {
  return valueIn<Candidates>(kCandidatesNames, name);
}
std::optional<Way> wayFromName(std::string_view name) { return valueIn<Way>(kWayNames, name); }

}  // namespace circle_voronoi
