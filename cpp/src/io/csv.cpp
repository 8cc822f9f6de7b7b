// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <charconv>
#include <optional>
#include <system_error>

#include "text.h"

namespace circle_voronoi {
namespace {

using Fields = std::array<std::string_view, 3>;

constexpr std::array<std::string_view, 3> kFieldNames = {"x", "y", "r"};

std::string_view trim(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::optional<Fields> split(std::string_view line) {
  Fields fields;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::size_t comma = line.find(',');
    const bool isLast = i + 1 == fields.size();
    if (isLast != (comma == std::string_view::npos)) return std::nullopt;
    fields[i] = trim(line.substr(0, comma));
    if (!isLast) line.remove_prefix(comma + 1);
  }
  return fields;
}

/// Whether the fields are the names x, y, r, in either case, with or without quotation marks.
bool isHeader(const Fields& fields) {
  for (std::size_t i = 0; i < fields.size(); ++i) {
    std::string_view field = fields[i];
    if (field.size() == 3 && field.front() == '"' && field.back() == '"') field = field.substr(1, 1);
    if (field.size() != 1 || (field[0] | 0x20) != kFieldNames[i][0]) return false;
  }
  return true;
}

struct Number {
  double value = 0;
  std::string problem;  ///< empty if there is none
};

Number readNumber(std::string_view field, std::string_view name) {
  // from_chars knows no leading plus.
  std::string_view digits = field;
  if (digits.starts_with('+') && !digits.starts_with("+-")) digits.remove_prefix(1);
  Number number;
  const char* end = digits.data() + digits.size();
  const auto [stop, code] = std::from_chars(digits.data(), end, number.value);
  if (code == std::errc::result_out_of_range) {
    number.problem = std::string(name) + " is beyond the range of a double: \"" + std::string(field) + "\".";
  } else if (code != std::errc() || stop != end) {
    number.problem = std::string(name) + " is not a number: \"" + std::string(field) + "\".";
  }
  return number;
}

}  // namespace

Result<NumberedCircles> readCsv(std::string_view text, std::string_view name) {
  NumberedCircles result;
  bool mayBeHeader = true;
  for (int lineNumber = 1; !text.empty(); ++lineNumber) {
    const std::size_t end = text.find('\n');
    const std::string_view line = trim(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (line.empty()) continue;

    const auto fields = split(line);
    if (!fields) return errorAt(name, lineNumber, "expected three numbers x,y,r separated by commas.");
    const bool isFirst = mayBeHeader;
    mayBeHeader = false;
    if (isFirst && isHeader(*fields)) continue;

    std::array<double, 3> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      Number number = readNumber((*fields)[i], kFieldNames[i]);
      if (!number.problem.empty()) return errorAt(name, lineNumber, number.problem);
      values[i] = number.value;
    }
    result.circles.push_back({values[0], values[1], values[2]});
    result.lines.push_back(lineNumber);
  }
  return result;
}

}  // namespace circle_voronoi
