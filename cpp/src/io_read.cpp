// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/io.h"
#include "io_text.h"
#include "validate.h"

namespace circle_voronoi {

Error errorAt(std::string_view name, int line, const std::string& reason) {
  return {ErrorCode::badInput, -1, std::string(name) + ":" + std::to_string(line) + ": " + reason};
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
