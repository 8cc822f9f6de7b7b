// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "circle_voronoi/io.h"
#include "crs.h"
#include "guarded.h"
#include "named_option.h"
#include "text.h"
#include "utf8.h"
#include "validate.h"

namespace circle_voronoi {
namespace {

Result<CircleFile> readFile(std::string_view text, std::string_view name, const ReadOptions& options, Keep keep) {
  return guarded([&]() -> Result<CircleFile> {
    const auto content = contentOf(text, name);
    if (!content) return content.error();
    const std::string_view rest = content.value();
    const char begin = firstOf(rest);
    auto read = begin == '['   ? readJson(rest, name, options, keep)
                : begin == '{' ? readGeoJson(rest, name, options, keep)
                               : readCsv(rest, name, options, keep);
    if (!read) return read.error();
    auto& [parsed, attributes, hasDegrees, crs, skipped] = read.value();
    if (!options.crs.empty()) crs = options.crs;
    const auto urn = crsUrn(crs);
    if (!crs.empty() && !urn) {
      Error error{ErrorCode::badOption, kNone, ""};
      append(error, {"", "`crs`", " must be like EPSG:25832, or a URN (got \"" + printable(crs) + "\").", "crs"});
      return error;
    }
    if (urn && keep == Keep::attributes) setCrs(attributes.collection, *urn);
    // Only the reader knows the line of each circle.
    if (const auto judged = validate(parsed.circles, options.weights); !judged) {
      return errorAtCircle(judged.error(), parsed.offsets, name, rest);
    }
    const auto isInRange = [](const Circle& c) { return std::abs(c.x) <= 360 && std::abs(c.y) <= 90; };
    const bool namesDegrees = hasDegrees || (urn && isGeoJsonCrs(*urn));
    const bool areDegrees = namesDegrees && std::ranges::all_of(parsed.circles, isInRange);
    CircleFile file = {std::move(parsed.circles), std::move(attributes), areDegrees, errorsAt(name, rest, skipped)};
    if (!file.circles.empty() || file.skipped.empty()) return file;
    Error error = file.skipped.front();
    error.message = error.message.substr(0, error.message.size() - 1) + "; all others are invalid as well.";
    return error;
  });
}

}  // namespace

Result<std::vector<Circle>> readCircles(std::string_view text, std::string_view name, const ReadOptions& options) {
  // Copying an error may run out of memory, too.
  return guarded([&]() -> Result<std::vector<Circle>> {
    auto file = readFile(text, name, options, Keep::circles);
    if (!file) return file.error();
    return std::move(file.value().circles);
  });
}

Result<CircleFile> readCircleFile(std::string_view text, std::string_view name, const ReadOptions& options) {
  return readFile(text, name, options, Keep::attributes);
}

}  // namespace circle_voronoi
