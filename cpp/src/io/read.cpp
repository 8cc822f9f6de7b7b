// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/io.h"
#include "text.h"
#include "validate.h"

namespace circle_voronoi {

Result<std::vector<Circle>> readCircles(std::string_view text, std::string_view name) {
  const auto content = contentOf(text, name);
  if (!content) return content.error();
  text = content.value();
  const char begin = text[text.find_first_not_of(" \t\r\n")];
  auto read = begin == '[' ? readJson(text, name) : begin == '{' ? readGeoJson(text, name) : readCsv(text, name);
  if (!read) return read.error();
  // Only here is it known on which line a circle stands.
  if (const auto judged = validate(read.value().circles); !judged) {
    return placed(judged.error(), read.value().offsets, name, text);
  }
  return std::move(read.value().circles);
}

}  // namespace circle_voronoi
