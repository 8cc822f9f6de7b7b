// SPDX-License-Identifier: GPL-3.0-or-later
#include "wkt_points.h"

#include "members.h"
#include "text.h"
#include "wkb.h"
#include "wkt_reader.h"

namespace circle_voronoi {
namespace {

/// Reads two numbers, and perhaps more.
void readPosition(WktReader& reader, std::string_view text, bool hasHeight, WktPoints& to) {
  Point p;
  p.x = reader.number();
  p.y = reader.number();
  std::string height;
  for (int k = 0; reader.hasNumber(); ++k) {
    const std::size_t begin = reader.offset();
    (void)reader.number();
    const std::string_view digits = text.substr(begin, reader.offset() - begin);
    if (k == 0 && hasHeight && isJsonNumber(digits)) height = digits;
  }
  to.points.push_back(p);
  to.heights.push_back(std::move(height));
}

}  // namespace

std::optional<WktPoints> wktPoints(std::string_view text) try {
  if (isHexWkb(text)) return wktPoints(wktOfHexWkb(text));
  // Most fields of a table are no points.
  const std::size_t begin = text.find_first_not_of(' ');
  if (begin == text.npos || std::string_view("PpMmSs").find(text[begin]) == std::string_view::npos) return std::nullopt;
  WktReader reader(text);
  WktPoints result;
  result.srid = reader.srid();
  const WktReader::Head head = reader.head();
  const bool areMany = head.type == "MULTIPOINT";
  if (head.isEmpty || !(areMany || head.type == "POINT")) return std::nullopt;
  reader.readList([&] {
    // Each point of a MULTIPOINT may be in parentheses.
    if (areMany && reader.isEmptyNext()) return;
    const bool isInside = areMany && reader.accepts('(');
    readPosition(reader, text, head.hasHeight, result);
    if (isInside && !reader.accepts(')')) reader.fail("expected a closing parenthesis.");
  });
  reader.finish();
  if (result.points.empty() || (!areMany && result.points.size() > 1)) return std::nullopt;
  return result;
} catch (const ReadError&) {
  return std::nullopt;
}

}  // namespace circle_voronoi
