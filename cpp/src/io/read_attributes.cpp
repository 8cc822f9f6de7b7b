// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "circle_voronoi/io.h"
#include "csv.h"
#include "csv_table.h"
#include "guarded.h"
#include "json_reader.h"
#include "text.h"
#include "written_names.h"

namespace circle_voronoi {
namespace {

std::string jsonString(std::string_view text) {
  constexpr std::string_view kHexDigits = "0123456789abcdef";
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      result += "\\u00";
      result += kHexDigits[static_cast<unsigned char>(c) >> 4];
      result += kHexDigits[static_cast<unsigned char>(c) & 15];
    } else {
      result += c;
    }
  }
  return result + "\"";
}

/// Members of an object, and what they are called in the output.
class Members {
 public:
  void add(std::string_view name, std::string_view value) {
    if (!text_.empty()) text_ += ',';
    text_ += jsonString(attributeName(name)) + ":";
    text_ += value;
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

/// The value that comes next, on one line.
std::string rawValue(JsonReader& reader, std::string_view text) {
  (void)reader.kind();
  const std::size_t begin = reader.offset();
  reader.skip();
  std::string value(text.substr(begin, reader.offset() - begin));
  // Line ends stand between values only: in a string they are escaped.
  std::ranges::replace_if(
      value, [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return value;
}

/// The members of an object but for some.
template <class IsLeftOut>
std::string readMembers(JsonReader& reader, std::string_view text, IsLeftOut isLeftOut) {
  Members members;
  reader.enterObject();
  while (const auto key = reader.nextKey()) {
    const std::string name(*key);
    if (isLeftOut(name)) {
      reader.skip();
    } else {
      members.add(name, rawValue(reader, text));
    }
  }
  return members.take();
}

std::vector<std::string> ofFeatures(std::string_view text) {
  std::vector<std::string> result;
  JsonReader reader(text);
  reader.enterObject();
  while (const auto key = reader.nextKey()) {
    if (*key != "features" || reader.kind() != JsonKind::array) {
      reader.skip();
      continue;
    }
    reader.enterArray();
    while (reader.nextItem()) {
      std::string members;
      reader.enterObject();
      while (const auto member = reader.nextKey()) {
        if (*member == "properties" && reader.kind() == JsonKind::object) {
          members = readMembers(reader, text, [](std::string_view name) { return name == "r" || name == "radius"; });
        } else {
          reader.skip();
        }
      }
      result.push_back(std::move(members));
    }
  }
  return result;
}

std::vector<std::string> ofObjects(std::string_view text) {
  std::vector<std::string> result;
  JsonReader reader(text);
  reader.enterArray();
  while (reader.nextItem()) {
    if (reader.kind() == JsonKind::object) {
      result.push_back(
          readMembers(reader, text, [](std::string_view name) { return name == "x" || name == "y" || name == "r"; }));
    } else {
      reader.skip();
      result.emplace_back();
    }
  }
  return result;
}

/// Whether a text is a number of JSON.
bool isJsonNumber(std::string_view text) {
  if (text.empty()) return false;
  try {
    JsonReader reader(text);
    if (reader.kind() != JsonKind::number) return false;
    (void)reader.number();
    reader.finish();
    return true;
  } catch (const ReadFailure&) {
    return false;
  }
}

std::string textOf(const CsvField& field) {
  std::string text(field.text);
  if (!field.isQuoted) return text;
  for (std::size_t at = text.find("\"\""); at != std::string::npos; at = text.find("\"\"", at + 1)) text.erase(at, 1);
  return text;
}

std::vector<std::string> ofRows(std::string_view text) {
  std::vector<std::string> result;
  const auto layout = layoutOf(text, true, true);
  if (!layout) return result;
  CsvTable table(text, layout->separator);
  std::vector<std::string> names;
  if (layout->hasHeader && table.next()) {
    for (const CsvField& field : table.fields()) names.push_back(textOf(field));
  }
  while (table.next()) {
    Members members;
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (names[k].empty() || std::ranges::find(layout->columns, k) != layout->columns.end()) continue;
      const CsvField field = k < table.fields().size() ? table.fields()[k] : CsvField{};
      const std::string value = textOf(field);
      members.add(names[k], value.empty() && !field.isQuoted         ? "null"
                            : !field.isQuoted && isJsonNumber(value) ? value
                                                                     : jsonString(value));
    }
    result.push_back(members.take());
  }
  return result;
}

}  // namespace

Result<std::vector<std::string>> readAttributes(std::string_view text, std::string_view name) {
  return guarded([&]() -> Result<std::vector<std::string>> {
    const auto content = contentOf(text, name);
    if (!content) return content.error();
    const std::string_view rest = content.value();
    try {
      const char begin = rest[rest.find_first_not_of(" \t\r\n")];
      return begin == '[' ? ofObjects(rest) : begin == '{' ? ofFeatures(rest) : ofRows(rest);
    } catch (const ReadFailure& failure) {
      return errorAt(name, rest, failure.offset, failure.reason);
    }
  });
}

}  // namespace circle_voronoi
