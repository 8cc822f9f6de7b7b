// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "circle_voronoi/io.h"
#include "circle_voronoi/table.h"
#include "column_names.h"
#include "guarded.h"
#include "members.h"
#include "read_double.h"

namespace circle_voronoi {
namespace {

/// The number of a property; nothing if it has none.
std::optional<double> numberNamed(const std::string& members, std::string_view column) {
  std::optional<double> number;
  visitMembers(members, [&](std::string_view name, std::string_view value) {
    if (number || !isNameOfColumn(name, column)) return;
    number = numberOf(value);
  });
  return number;
}

}  // namespace

std::optional<double> numberOf(std::string_view value) {
  if (value.size() > 2 && value.starts_with('"')) value = value.substr(1, value.size() - 2);
  double number = 0;
  const char* const end = value.data() + value.size();
  const auto [stop, code] = readDouble(value.data(), end, number);
  return code == std::errc() && stop == end && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

Result<std::vector<double>> numbersIn(const CircleAttributes& attributes, std::string_view column) {
  return guarded([&]() -> Result<std::vector<double>> {
    if (attributes.properties.empty()) {
      return Error{ErrorCode::badInput, kNone, "there is no column or property \"" + std::string(column) + "\"."};
    }
    std::vector<double> numbers;
    for (const std::string& members : attributes.properties) {
      const auto number = numberNamed(members, column);
      if (!number) {
        return Error{ErrorCode::badInput, static_cast<std::int64_t>(numbers.size()),
                     "circle " + std::to_string(numbers.size()) + " has no number \"" + std::string(column) + "\"."};
      }
      numbers.push_back(*number);
    }
    return numbers;
  });
}

}  // namespace circle_voronoi
