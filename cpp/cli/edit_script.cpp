// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_script.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <system_error>
#include <utility>

#include "box.h"
#include "command_error.h"
#include "utf8.h"

namespace circle_voronoi::cli {
namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) + 1 - first);
}

/// Removes the text before the first separator, and returns it.
std::string_view takeUpTo(char separator, std::string_view& text) {
  const std::string_view part = text.substr(0, text.find(separator));
  text.remove_prefix(std::min(part.size() + 1, text.size()));
  return part;
}

std::string quoted(std::string_view text) {
  std::string quoted(1, '"');
  quoted.append(text).push_back('"');
  return quoted;
}

class LineReader {
 public:
  LineReader(std::string_view line, std::string place) : place_(std::move(place)) {
    while (!line.empty()) fields_.push_back(trimmed(takeUpTo(',', line)));
  }

  Edit read() const {
    if (fields_[0] == "insert" && fields_.size() == 5) return {Edit::Kind::insert, id(5), circle(2)};
    if (fields_[0] == "insert") return {Edit::Kind::insert, kNone, circle(1)};
    if (fields_[0] == "remove") return {Edit::Kind::remove, id(2), {}};
    if (fields_[0] == "replace") return {Edit::Kind::replace, id(5), circle(2)};
    fail(quoted(fields_[0]) + " is no edit; an edit is insert,x,y,r or remove,id or replace,id,x,y,r.");
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw CommandError{kBadInput, place_ + printable(what)}; }

  void expectFields(std::size_t count) const {
    if (fields_.size() == count) return;
    fail(std::string(fields_[0]) + " takes " + std::to_string(count - 1) + (count == 2 ? " number" : " numbers") +
         ", not " + std::to_string(fields_.size() - 1) + ".");
  }

  CircleId id(std::size_t fieldCount) const {
    expectFields(fieldCount);
    const std::string_view field = fields_[1];
    std::int32_t value = 0;
    const char* end = field.data() + field.size();
    const auto [stop, code] = std::from_chars(field.data(), end, value);
    if (code != std::errc() || stop != end || value < 0) fail(quoted(field) + " is no id.");
    return value;
  }

  Circle circle(std::size_t first) const {
    expectFields(first + 3);
    std::array<double, 3> numbers{};
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      const std::string_view field = fields_[first + k];
      const auto value = readNumber(field, Sides::finite);
      if (!value) fail(quoted(field) + " is not a finite number.");
      numbers[k] = *value;
    }
    return {numbers[0], numbers[1], numbers[2]};
  }

  std::string place_;
  std::vector<std::string_view> fields_;
};

}  // namespace

std::vector<ScriptEdit> readScript(std::string_view text, const std::string& name) {
  if (isUtf16(text)) throw CommandError{kBadInput, name + ":1: the text is UTF-16; save it as UTF-8."};
  text = withoutByteOrderMark(text);
  std::vector<ScriptEdit> edits;
  for (int line = 1; !text.empty(); ++line) {
    const std::string_view content = trimmed(takeUpTo('\n', text));
    if (content.empty() || content.front() == '#') continue;
    edits.push_back({LineReader(content, name + ":" + std::to_string(line) + ": ").read(), line});
  }
  return edits;
}

}  // namespace circle_voronoi::cli
