// SPDX-License-Identifier: GPL-3.0-or-later
#include "column_names.h"

#include <algorithm>
#include <charconv>
#include <span>
#include <system_error>
#include <utility>

namespace circle_voronoi {
namespace {

constexpr std::array<std::string_view, 7> kNamesOfX = {"x", "cx", "lon", "long", "lng", "longitude", "easting"};
constexpr std::array<std::string_view, 5> kNamesOfY = {"y", "cy", "lat", "latitude", "northing"};
constexpr std::array<std::string_view, 3> kNamesOfR = {"r", "rad", "radius"};
// web/view/circle-text.ts has the same lists; tests/files/readings.json keeps them equal.
constexpr std::array<std::span<const std::string_view>, ColumnNames::kCount> kNames = {kNamesOfX, kNamesOfY, kNamesOfR};
constexpr std::array<std::string_view, ColumnNames::kCount> kOptions = {"x", "y", "radius"};

}  // namespace

bool isSameName(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; };
  return std::ranges::equal(a, b, {}, lower, lower);
}

bool isNameOfColumn(std::string_view name, std::string_view column) {
  name.remove_prefix(std::min(name.find_first_not_of(" \t"), name.size()));
  return isSameName(name.substr(0, name.find_last_not_of(" \t") + 1), column);
}

bool areDegrees(std::string_view x, std::string_view y) {
  constexpr std::array<std::string_view, 4> kLongitudes = {"lon", "long", "lng", "longitude"};
  constexpr std::array<std::string_view, 2> kLatitudes = {"lat", "latitude"};
  const auto isIn = [](const auto& names, std::string_view name) {
    return std::ranges::any_of(names, [&](std::string_view known) { return isSameName(name, known); });
  };
  return isIn(kLongitudes, x) && isIn(kLatitudes, y);
}

ColumnNames::ColumnNames(const ReadOptions& options)
    : own_{options.x, options.y, options.radius},
      id_(options.id.empty() ? "id" : options.id),
      hasId_(!options.id.empty()),
      radii_(options.radii),
      weights_(options.weights) {}

std::optional<std::size_t> ColumnNames::rank(std::size_t k, std::string_view name) const {
  if (k == kRadius && radii_ == Radii::none) return std::nullopt;
  if (!own_[k].empty()) return isSameName(name, own_[k]) ? std::optional<std::size_t>(0) : std::nullopt;
  const auto found = std::ranges::find_if(kNames[k], [&](std::string_view known) { return isSameName(name, known); });
  if (found == kNames[k].end()) return std::nullopt;
  return static_cast<std::size_t>(found - kNames[k].begin());
}

std::string ColumnNames::missing(std::size_t columns) const {
  for (const std::string& name : {own_[0], own_[1], own_[2], hasId_ ? id_ : ""}) {
    const auto column = numberIn(name);
    if (!name.empty() && !(column && *column <= columns)) return name;
  }
  return "";
}

std::optional<std::size_t> ColumnNames::numberIn(std::string_view option) {
  if (!option.starts_with('#')) return std::nullopt;
  std::size_t column = 0;
  const char* const end = option.data() + option.size();
  const auto [stop, code] = std::from_chars(option.data() + 1, end, column);
  return stop == end && code == std::errc() && column > 0 ? std::optional(column) : std::nullopt;
}

std::string ColumnNames::listOf(std::size_t k) const {
  if (!own_[k].empty()) return own_[k];
  std::string list;
  const auto names = kNames[k];
  for (std::size_t i = 0; i < names.size(); ++i) {
    list += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + std::string(names[i]);
  }
  return list;
}

std::string ColumnNames::plain(std::size_t k) { return std::string(kNames[k].front()); }

OptionAdvice ColumnNames::advice(std::string before, std::size_t k) {
  const std::string option(kOptions[k]);
  return {std::move(before), "the option " + option, ".", option};
}

ReadError ColumnNames::withoutRadius(ReadError failure) const {
  if (weights_ || isGiven(kRadius)) {
    failure.reason += ".";
  } else {
    failure.advice = {"; make all radii 0 by ", "the option points", ".", "points"};
  }
  return failure;
}

}  // namespace circle_voronoi
