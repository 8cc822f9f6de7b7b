// SPDX-License-Identifier: GPL-3.0-or-later
#include "box.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <system_error>

#include "circle_voronoi/region.h"
#include "number_text.h"
#include "read_double.h"

namespace circle_voronoi::cli {
namespace {

using Names = std::array<const char*, 4>;
constexpr Names kBoxNames = {"MINX", "MINY", "MAXX", "MAXY"};
constexpr Names kLatticeNames = {"AX", "AY", "BX", "BY"};

/// Reads four numbers, or returns the text of an error. An empty text is no box.
std::string readFour(std::string_view text, const Names& names, Sides sides, std::array<double, 4>& values) {
  const char* kinds = sides == Sides::finite ? " is not a finite number" : " is not a number";
  const auto count = static_cast<std::size_t>(std::ranges::count(text, ',')) + 1;
  if (count != values.size()) {
    std::string usage;
    for (const char* name : names) usage += (usage.empty() ? "" : ",") + std::string(name);
    return "expected " + usage + ", not " + std::to_string(count) + " numbers.";
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string_view field = text.substr(0, text.find(','));
    const auto value = readNumber(field, sides);
    if (!value) return std::string(names[i]) + kinds + ": \"" + std::string(field) + "\".";
    values[i] = *value;
    text.remove_prefix(std::min(field.size() + 1, text.size()));
  }
  return "";
}

}  // namespace

std::optional<double> readNumber(std::string_view text, Sides sides) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, code] = readDouble(text.data(), end, value);
  if (code != std::errc() || stop != end || std::isnan(value)) return std::nullopt;
  if (std::isinf(value) && sides == Sides::finite) return std::nullopt;
  return value;
}

std::string readBox(std::string_view text, Box& box, Sides sides) {
  std::array<double, 4> values{};
  if (std::string problem = readFour(text, kBoxNames, sides, values); !problem.empty()) return problem;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string min = kBoxNames[i];
    const std::string max = kBoxNames[i + 2];
    if (values[i] < values[i + 2]) continue;
    const bool isAcross180 = i == 0 && values[0] > 0 && values[0] <= 180 && values[2] < 0 && values[2] >= -180;
    return max + " has to be above " + min +
           (isAcross180 ? "; across 180 degrees, longitudes go on: MAXX is " + numberText(values[2] + 360) + "." : ".");
  }
  box = {values[0], values[1], values[2], values[3]};
  if (sides == Sides::maybeInfinite) return "";
  const auto region = Region::from(box);
  return region ? "" : region.error().message;
}

std::string readLattice(std::string_view text, Lattice& lattice) {
  std::array<double, 4> values{};
  std::string problem = readFour(text, kLatticeNames, Sides::finite, values);
  lattice = {{values[0], values[1]}, {values[2], values[3]}};
  return problem;
}

}  // namespace circle_voronoi::cli
