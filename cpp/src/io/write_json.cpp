// SPDX-License-Identifier: GPL-3.0-or-later
#include "attribute_writer.h"
#include "checks.h"
#include "circle_voronoi/io.h"
#include "circle_voronoi/stats.h"
#include "diagram_json.h"
#include "digits.h"
#include "writer.h"

namespace circle_voronoi {
namespace {

template <class Struct, class Field, std::size_t count>
void writeFields(Writer& out, const Struct& values, const std::array<NamedMember<Struct, Field>, count>& fields) {
  out << "{";
  writeJoined(out, fields, ", ",
              [&](const auto& member) { out << "\"" << member.name << "\": " << values.*member.member; });
  out << "}";
}

template <class Value>
std::string_view nameOr(std::optional<Value> value, std::string_view name(Value)) {
  return value ? name(*value) : std::string_view();
}

void writeStats(Writer& out, const Diagram& diagram, std::string_view indent) {
  const auto& [method, way, candidates, counts, seconds] = diagram.stats;
  const Certificate& certificate = diagram.certificate;
  out << "{\"method\": \"" << nameOr(method, methodName) << "\", \"way\": \"" << nameOr(way, wayName)
      << "\", \"candidates\": \"" << nameOr(candidates, candidatesName) << "\",\n"
      << indent << " \"certificate\": {\"certified\": " << (certificate.certified() ? "true" : "false")
      << ", \"flaw\": \"" << flawName(certificate.flaw) << "\", \"circle\": " << certificate.circle
      << ", \"vertex\": " << certificate.vertex << ", \"edge\": " << certificate.edge << ", \"message\": \""
      << certificate.message << "\"},\n"
      << indent << " \"counts\": ";
  writeFields(out, counts, kCountMembers);
  out << ",\n" << indent << " \"seconds\": ";
  writeFields(out, seconds, kSecondsMembers);
  out << "}";
}

}  // namespace

void writeAttributeMembers(Writer& out, const CircleAttributes& attributes, std::size_t circle) {
  if (const auto height = entryOf(attributes.heights, circle); !height.empty()) out << ", \"z\": " << height;
  if (const auto id = entryOf(attributes.ids, circle); !id.empty()) out << ", \"id\": " << id;
  if (const auto members = entryOf(attributes.properties, circle); !members.empty()) {
    out << ", \"properties\": {" << members << "}";
  }
}

void writeHidden(Writer& out, std::span<const HiddenCircle> hidden, std::string_view name) {
  writeLines(out, hidden.size(), [&](std::size_t i) {
    out << "{\"" << name << "\": " << hidden[i].circle << ", \"by\": " << hidden[i].by << "}";
  });
}

void writeEdges(Writer& out, std::span<const Edge> edges, std::string_view name) {
  writeLines(out, edges.size(), [&](std::size_t i) {
    const auto& [left, right, start, end] = edges[i];
    out << "{\"" << name << "\": [" << left << ", " << right << "], \"vertices\": [" << start << ", " << end << "]}";
  });
}

void writeDiagram(Writer& out, const Diagram& diagram, std::optional<int> digits, const CircleAttributes& attributes,
                  const std::function<void()>& writeMore) {
  const DecimalGrid grid(digits);
  out << "{\"format\": \"circle-voronoi\", \"version\": 1,\n ";
  if (diagram.metric != Metric::circles) out << "\"metric\": \"" << metricName(diagram.metric) << "\",\n ";
  if (diagram.weights) out << "\"weights\": true,\n ";
  if (!attributes.collection.empty()) out << "\"collection\": {" << attributes.collection << "},\n ";
  out << "\"circles\": ";
  writeLines(out, diagram.circles.size(), [&](std::size_t i) {
    out << "{\"x\": " << diagram.circles[i].x << ", \"y\": " << diagram.circles[i].y
        << ", \"r\": " << diagram.circles[i].r;
    writeAttributeMembers(out, attributes, i);
    out << "}";
  });
  out << ",\n \"hidden\": ";
  writeHidden(out, diagram.hidden, "circle");
  out << ",\n \"vertices\": ";
  writeLines(out, diagram.vertices.size(), [&](std::size_t i) {
    const Vertex& vertex = diagram.vertices[i];
    const auto& [a, b, c] = diagram.vertexCircles[i];
    out << "{\"x\": " << grid.round(vertex.x) << ", \"y\": " << grid.round(vertex.y)
        << ", \"r\": " << grid.round(vertex.r) << ", \"circles\": [" << a << ", " << b << ", " << c << "]}";
  });
  out << ",\n \"edges\": ";
  writeEdges(out, diagram.edges, "circles");
  out << ",\n \"hull\": [";
  writeJoined(out, diagram.hull, ", ");
  out << "],\n ";
  writeMore();
  out << "\"stats\": ";
  writeStats(out, diagram, " ");
  out << "}\n";
}

Result<void> writeJson(std::ostream& stream, const Diagram& diagram, std::optional<int> digits) {
  return writeDiagramFile(stream, diagram, {}, digits);
}

Result<void> writeDiagramFile(std::ostream& stream, const Diagram& diagram, const CircleAttributes& attributes,
                              std::optional<int> digits) {
  if (auto checked = checkDigits(digits); !checked) return checked;
  if (auto checked = checkVertices(diagram); !checked) return checked;
  if (auto checked = checkAttributes(attributes, diagram.circles.size()); !checked) return checked;
  return writing(stream, [&](Writer& out) { writeDiagram(out, diagram, digits, attributes, [] {}); });
}

Result<void> writeStatsJson(std::ostream& stream, const Diagram& diagram) {
  return writing(stream, [&](Writer& out) {
    writeStats(out, diagram, "");
    out << "\n";
  });
}

}  // namespace circle_voronoi
