// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/io.h"
#include "validate.h"
#include "writer.h"

namespace circle_voronoi {
namespace {

/// Items, each written by `item(out, i, circle)`, on a line each.
template <class Item>
void writeLines(Writer& out, std::span<const Circle> circles, Item item) {
  for (std::size_t i = 0; i < circles.size(); ++i) {
    out << (i == 0 ? "\n" : ",\n");
    item(out, static_cast<std::int64_t>(i), circles[i]);
  }
}

/// Writes circles that `readCircles` accepts.
template <class Body>
Result<void> writingCircles(std::ostream& stream, std::span<const Circle> circles, Body body) {
  const auto valid = guarded([&] { return validate(circles, true); });
  if (!valid) return valid.error();
  return writing(stream, body);
}

}  // namespace

Result<void> writeCirclesCsv(std::ostream& stream, std::span<const Circle> circles) {
  return writingCircles(stream, circles, [&](Writer& out) {
    out << "x,y,r\n";
    for (const Circle& c : circles) out << c.x << "," << c.y << "," << c.r << "\n";
  });
}

Result<void> writeCirclesJson(std::ostream& stream, std::span<const Circle> circles) {
  return writingCircles(stream, circles, [&](Writer& out) {
    out << "[";
    writeLines(out, circles, [](Writer& line, std::int64_t, const Circle& c) {
      line << "{\"x\": " << c.x << ", \"y\": " << c.y << ", \"r\": " << c.r << "}";
    });
    out << "\n]\n";
  });
}

Result<void> writeCirclesGeoJson(std::ostream& stream, std::span<const Circle> circles) {
  return writingCircles(stream, circles, [&](Writer& out) {
    out << R"({"type":"FeatureCollection","features":[)";
    writeLines(out, circles, [](Writer& line, std::int64_t i, const Circle& c) {
      line << R"({"type":"Feature","properties":{"circle":)" << i << R"(,"r":)" << c.r
           << R"(},"geometry":{"type":"Point","coordinates":[)" << c.x << "," << c.y << "]}}";
    });
    out << "\n]}\n";
  });
}

}  // namespace circle_voronoi
