// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/io.h"
#include "guarded.h"
#include "text.h"
#include "validate.h"

namespace circle_voronoi {

Result<std::vector<Circle>> readCircles(std::string_view text, std::string_view name, const ReadOptions& options) {
  return guarded([&]() -> Result<std::vector<Circle>> {
    const auto content = contentOf(text, name);
    if (!content) return content.error();
    const std::string_view rest = content.value();
    const char begin = rest[rest.find_first_not_of(" \t\r\n")];
    auto read = begin == '['   ? readJson(rest, name, options.points)
                : begin == '{' ? readGeoJson(rest, name, options.points)
                               : readCsv(rest, name, options.points);
    if (!read) return read.error();
    // Only here is it known on which line a circle stands.
    if (const auto judged = validate(read.value().circles, options.weights); !judged) {
      return placed(judged.error(), read.value().offsets, name, rest);
    }
    return std::move(read.value().circles);
  });
}

}  // namespace circle_voronoi
