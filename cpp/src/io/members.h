// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "json_reader.h"

namespace circle_voronoi {

/// Returns a text as a string in JSON.
std::string jsonString(std::string_view text);

/// Returns whether a text is a number in JSON that a double can have.
bool isJsonNumber(std::string_view text);

/// Returns whether a text is a value in JSON on one line, without white space around it.
bool isJsonLine(std::string_view text);

/// Returns whether a text marks a missing number in a column of numbers, as in spreadsheets and statistics programs.
bool isMissingNumber(std::string_view text);

/// Members of a JSON object, without braces.
class Members {
 public:
  void add(std::string_view name, std::string_view value) {
    if (!text_.empty()) text_ += ',';
    text_ += jsonString(name) + ":";
    text_ += value;
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

/// The names and values of members, in the order in which they are given.
using MemberList = std::vector<std::pair<std::string, std::string>>;

/// Returns members as text. If a name is given twice, its last value counts, as in all of JSON.
std::string membersOf(const MemberList& members);

/// Returns the text of a value in JSON on one line: line ends stand between values only, because in a string they are
/// escaped.
std::string oneLine(std::string_view value);

/// Reads the next value of a text. Returns its text, but on one line.
std::string rawValue(JsonReader& reader, std::string_view text);

/// Reads the object that comes next. Returns its members as text, without braces.
std::string readMembers(JsonReader& reader, std::string_view text);

/// Calls `visit(name, value)` for each of the members of an object, which are written without braces. The value is its
/// JSON.
template <class Visit>
void visitMembers(std::string_view members, Visit visit) {
  if (members.empty()) return;
  const std::string text = "{" + std::string(members) + "}";
  JsonReader reader(text);
  reader.enterObject();
  while (const auto key = reader.nextKey()) {
    const std::string name(*key);
    (void)reader.kind();
    const std::size_t begin = reader.offset();
    reader.skip();
    visit(std::string_view(name), std::string_view(text).substr(begin, reader.offset() - begin));
  }
}

/// Returns whether a value in JSON can be the id of a circle: a string or a number.
inline bool isIdValue(std::string_view value) {
  return !value.empty() && (value[0] == '"' || value[0] == '-' || (value[0] >= '0' && value[0] <= '9'));
}

/// Returns whether a value in JSON is a number.
inline bool isNumberValue(std::string_view value) { return isIdValue(value) && value[0] != '"'; }

}  // namespace circle_voronoi
