// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "circle_voronoi/io.h"
#include "io_writer.h"

namespace circle_voronoi {
namespace {

template <class Struct, class Field>
struct NamedField {
  std::string_view name;
  Field Struct::*field;
};

constexpr std::array<NamedField<Counts, std::int64_t>, 7> kCounts = {{
    {"circles", &Counts::circles},
    {"hidden", &Counts::hidden},
    {"samples", &Counts::samples},
    {"antipodalDiscs", &Counts::antipodalDiscs},
    {"threeTouchDiscs", &Counts::threeTouchDiscs},
    {"events", &Counts::events},
    {"leftoverCycles", &Counts::leftoverCycles},
}};

constexpr std::array<NamedField<Seconds, double>, 5> kSeconds = {{
    {"hide", &Seconds::hide},
    {"sample", &Seconds::sample},
    {"pair", &Seconds::pair},
    {"touch", &Seconds::touch},
    {"total", &Seconds::total},
}};

/// `[` the items, each written by `item(i)`, a line each, `]`.
template <class Item>
void writeLines(Writer& out, std::size_t count, Item item) {
  out << "[";
  for (std::size_t i = 0; i < count; ++i) {
    out << (i == 0 ? "\n  " : ",\n  ");
    item(i);
  }
  out << (count == 0 ? "]" : "\n ]");
}

template <class Struct, class Field, std::size_t count>
void writeFields(Writer& out, const Struct& values, const std::array<NamedField<Struct, Field>, count>& fields) {
  std::string_view separator = "{";
  for (const auto& [name, field] : fields) {
    out << separator << "\"" << name << "\": " << values.*field;
    separator = ", ";
  }
  out << "}";
}

void writeStats(Writer& out, const Stats& stats, std::string_view indent) {
  out << "{\"method\": \"" << stats.method << "\", \"candidates\": \"" << stats.candidates << "\",\n"
      << indent << " \"counts\": ";
  writeFields(out, stats.counts, kCounts);
  out << ",\n" << indent << " \"seconds\": ";
  writeFields(out, stats.seconds, kSeconds);
  out << "}";
}

}  // namespace

void writeJson(std::ostream& stream, std::span<const Circle> circles, const Diagram& diagram) {
  Writer out(stream);
  out << "{\"format\": \"circle-voronoi\", \"version\": 1,\n \"circles\": ";
  writeLines(out, circles.size(), [&](std::size_t i) {
    out << "{\"x\": " << circles[i].x << ", \"y\": " << circles[i].y << ", \"r\": " << circles[i].r << "}";
  });
  out << ",\n \"hidden\": ";
  writeLines(out, diagram.hidden.size(), [&](std::size_t i) {
    out << "{\"circle\": " << diagram.hidden[i].circle << ", \"by\": " << diagram.hidden[i].by << "}";
  });
  out << ",\n \"vertices\": ";
  writeLines(out, diagram.vertices.size(), [&](std::size_t i) {
    const Vertex& vertex = diagram.vertices[i];
    const auto& [a, b, c] = diagram.vertexCircles[i];
    out << "{\"x\": " << vertex.x << ", \"y\": " << vertex.y << ", \"radius\": " << vertex.radius << ", \"circles\": ["
        << a << ", " << b << ", " << c << "]}";
  });
  out << ",\n \"edges\": ";
  writeLines(out, diagram.edges.size(), [&](std::size_t i) {
    const Edge& edge = diagram.edges[i];
    out << "{\"circles\": [" << edge.left << ", " << edge.right << "], \"vertices\": [" << edge.start << ", "
        << edge.end << "]}";
  });
  out << ",\n \"hull\": [";
  std::string_view separator;
  for (const std::int32_t circle : diagram.hull) {
    out << separator << circle;
    separator = ", ";
  }
  out << "],\n \"stats\": ";
  writeStats(out, diagram.stats, " ");
  out << "}\n";
}

void writeStatsJson(std::ostream& stream, const Stats& stats) {
  Writer out(stream);
  writeStats(out, stats, "");
  out << "\n";
}

}  // namespace circle_voronoi
