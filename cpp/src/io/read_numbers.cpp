// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "circle_voronoi/io.h"
#include "guarded.h"
#include "json_reader.h"
#include "written_names.h"

namespace circle_voronoi {
namespace {

/// The number that a member of an object has; nothing if there is no such member, or it is no number.
std::optional<double> numberOf(const std::string& members, std::string_view name) {
  const std::string text = "{" + members + "}";
  JsonReader reader(text);
  reader.enterObject();
  while (const auto key = reader.nextKey()) {
    if (*key == name && reader.kind() == JsonKind::number) return reader.number();
    reader.skip();
  }
  return std::nullopt;
}

}  // namespace

Result<std::vector<double>> readNumbers(std::string_view text, std::string_view name, std::string_view column) {
  return guarded([&]() -> Result<std::vector<double>> {
    const auto attributes = readAttributes(text, name);
    if (!attributes) return attributes.error();
    const std::string wanted = attributeName(column);
    std::vector<double> numbers;
    for (const std::string& members : *attributes) {
      const auto number = numberOf(members, wanted);
      if (!number) {
        return Error{ErrorCode::badInput, static_cast<std::int64_t>(numbers.size()),
                     std::string(name) + ": circle " + std::to_string(numbers.size()) + " has no number \"" +
                         std::string(column) + "\"."};
      }
      numbers.push_back(*number);
    }
    return numbers;
  });
}

}  // namespace circle_voronoi
