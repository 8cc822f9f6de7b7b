// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "circle_voronoi/io.h"
#include "text.h"
#include "validate.h"

namespace circle_voronoi {

namespace {

/// The reason as one line of printable text, whatever it quotes from a file.
std::string printable(std::string reason) {
  constexpr std::size_t kMostCharacters = 300;
  const auto isControl = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; };
  std::replace_if(reason.begin(), reason.end(), isControl, '?');
  if (reason.size() > kMostCharacters) reason = reason.substr(0, kMostCharacters) + "...";
  return reason;
}

}  // namespace

Error errorAt(std::string_view name, int line, const std::string& reason) {
  return {ErrorCode::badInput, -1, std::string(name) + ":" + std::to_string(line) + ": " + printable(reason)};
}

Result<std::vector<Circle>> readCircles(std::string_view text, std::string_view name) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());

  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const char begin = first == std::string_view::npos ? '\n' : text[first];
  auto read = begin == '[' ? readJson(text, name) : begin == '{' ? readGeoJson(text, name) : readCsv(text, name);
  if (!read) return read.error();
  auto& [circles, lines] = read.value();

  // Only here is it known on which line a circle stands.
  if (const auto judged = validate(circles); !judged) {
    Error error = judged.error();
    const int line = error.circle < 0 ? 1 : lines[static_cast<std::size_t>(error.circle)];
    error.message = std::string(name) + ":" + std::to_string(line) + ": " + error.message;
    return error;
  }
  return std::move(circles);
}

}  // namespace circle_voronoi
