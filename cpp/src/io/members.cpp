// SPDX-License-Identifier: GPL-3.0-or-later
#include "members.h"

#include <algorithm>
#include <array>
#include <set>

#include "text.h"

namespace circle_voronoi {

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

std::string membersOf(const MemberList& members) {
  std::set<std::string_view> later;
  std::vector<bool> isLast(members.size());
  for (std::size_t k = members.size(); k-- > 0;) isLast[k] = later.insert(members[k].first).second;
  Members result;
  for (std::size_t k = 0; k < members.size(); ++k) {
    if (isLast[k]) result.add(members[k].first, members[k].second);
  }
  return result.take();
}

bool isJsonNumber(std::string_view text) {
  // Most texts of a table are words; exceptions for them would take half of the time of writing it.
  if (text.empty() || (text[0] != '-' && (text[0] < '0' || text[0] > '9'))) return false;
  try {
    JsonReader reader(text);
    if (reader.offset() != 0 || reader.kind() != JsonKind::number || reader.offset() != 0) return false;
    (void)reader.number();
    return reader.offset() == text.size();
  } catch (const ReadError&) {
    return false;
  }
}

bool isJsonLine(std::string_view text) {
  if (text.empty() || text.find_first_of("\n\r") != text.npos) return false;
  try {
    JsonReader reader(text);
    (void)reader.kind();
    if (reader.offset() != 0) return false;
    reader.skip();
    return reader.offset() == text.size();
  } catch (const ReadError&) {
    return false;
  }
}

bool isMissingNumber(std::string_view text) {
  constexpr std::array<std::string_view, 6> kMissing = {"NA", "N/A", "NaN", "nan", "null", "NULL"};
  return std::ranges::find(kMissing, text) != kMissing.end();
}

std::string oneLine(std::string_view value) {
  std::string line(value);
  std::ranges::replace_if(
      line, [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return line;
}

std::string rawValue(JsonReader& reader, std::string_view text) {
  (void)reader.kind();
  const std::size_t begin = reader.offset();
  reader.skip();
  return oneLine(text.substr(begin, reader.offset() - begin));
}

std::string readMembers(JsonReader& reader, std::string_view text) {
  MemberList members;
  reader.enterObject();
  while (const auto key = reader.nextKey()) {
    std::string name(*key);
    members.emplace_back(std::move(name), rawValue(reader, text));
  }
  return membersOf(members);
}

}  // namespace circle_voronoi
