// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>
#include <vector>

#include "attribute_columns.h"
#include "attribute_writer.h"
#include "checks.h"
#include "circle_voronoi/io.h"
#include "members.h"
#include "validate.h"
#include "writer.h"

namespace circle_voronoi {
namespace {

bool isPlainName(std::string_view name) {
  return std::ranges::any_of(std::array{"x", "y", "r"}, [&](const char* plain) { return isSameName(name, plain); });
}

/// Items, each written by `item(out, i, circle)`, on a line each.
template <class Item>
void writeLines(Writer& out, std::span<const Circle> circles, Item item) {
  for (std::size_t i = 0; i < circles.size(); ++i) {
    out << (i == 0 ? "\n" : ",\n");
    item(out, i, circles[i]);
  }
}

/// Writes circles that `readCircleFile` accepts.
template <class Body>
Result<void> writingCircles(std::ostream& stream, std::span<const Circle> circles, const CircleAttributes& attributes,
                            Body body) {
  const auto valid = guarded([&] { return validate(circles, true); });
  if (!valid) return valid.error();
  if (auto checked = checkAttributes(attributes, circles.size()); !checked) return checked;
  return writing(stream, body);
}

}  // namespace

Result<void> writeCirclesCsv(std::ostream& stream, std::span<const Circle> circles,
                             const CircleAttributes& attributes) {
  return writingCircles(stream, circles, attributes, [&](Writer& out) {
    AttributeColumns columns(attributes);
    out << "x,y,r";
    columns.writeHeader(out);
    out << "\n";
    for (std::size_t i = 0; i < circles.size(); ++i) {
      out << circles[i].x << "," << circles[i].y << "," << circles[i].r;
      columns.writeRow(out, i);
      out << "\n";
    }
  });
}

Result<void> writeCirclesJson(std::ostream& stream, std::span<const Circle> circles,
                              const CircleAttributes& attributes) {
  return writingCircles(stream, circles, attributes, [&](Writer& out) {
    out << "[";
    writeLines(out, circles, [&](Writer& line, std::size_t i, const Circle& c) {
      const std::string_view height = entryOf(attributes.heights, i);
      const std::string_view id = entryOf(attributes.ids, i);
      line << "{\"x\": " << c.x << ", \"y\": " << c.y << ", \"r\": " << c.r;
      if (!height.empty()) line << ", \"z\": " << height;
      if (!id.empty()) line << ", \"id\": " << id;
      const auto isOwn = [&](std::string_view name) {
        return isPlainName(name) || (!id.empty() && isSameName(name, "id")) ||
               (!height.empty() && isSameName(name, "z"));
      };
      visitProperties(attributes, i, isOwn, [&](std::string_view name, std::string_view value) {
        line << ", " << jsonString(name) << ": " << value;
      });
      line << "}";
    });
    out << "\n]\n";
  });
}

Result<void> writeCirclesGeoJson(std::ostream& stream, std::span<const Circle> circles,
                                 const CircleAttributes& attributes) {
  return writingCircles(stream, circles, attributes, [&](Writer& out) {
    writeCollectionStart(out, &attributes);
    writeLines(out, circles, [&](Writer& line, std::size_t i, const Circle& c) {
      writeFeatureStart(line, &attributes, i);
      line << R"("r":)" << c.r;
      const auto isOwn = [](std::string_view name) { return isSameName(name, "r"); };
      visitProperties(attributes, i, isOwn, [&](std::string_view name, std::string_view value) {
        line << "," << jsonString(name) << ":" << value;
      });
      line << R"(},"geometry":{"type":"Point","coordinates":[)" << c.x << "," << c.y;
      if (const auto height = entryOf(attributes.heights, i); !height.empty()) line << "," << height;
      line << "]}}";
    });
    out << "\n]}\n";
  });
}

}  // namespace circle_voronoi
