// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/io.h"
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

}  // namespace

void writeCirclesCsv(std::ostream& stream, std::span<const Circle> circles) {
  Writer out(stream);
  out << "x,y,r\n";
  for (const Circle& c : circles) out << c.x << "," << c.y << "," << c.r << "\n";
}

void writeCirclesJson(std::ostream& stream, std::span<const Circle> circles) {
  Writer out(stream);
  out << "[";
  writeLines(out, circles, [](Writer& line, std::int64_t, const Circle& c) {
    line << "{\"x\": " << c.x << ", \"y\": " << c.y << ", \"r\": " << c.r << "}";
  });
  out << "\n]\n";
}

void writeCirclesGeoJson(std::ostream& stream, std::span<const Circle> circles) {
  Writer out(stream);
  out << R"({"type":"FeatureCollection","features":[)";
  writeLines(out, circles, [](Writer& line, std::int64_t i, const Circle& c) {
    line << R"({"type":"Feature","properties":{"circle":)" << i << R"(,"r":)" << c.r
         << R"(},"geometry":{"type":"Point","coordinates":[)" << c.x << "," << c.y << "]}}";
  });
  out << "\n]}\n";
}

}  // namespace circle_voronoi
