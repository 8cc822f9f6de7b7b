// SPDX-License-Identifier: GPL-3.0-or-later
// The readers and writers of files as a JavaScript module of its own. Its only caller is web/lib/files.ts.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <algorithm>
#include <array>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "circle_voronoi/certify.h"
#include "circle_voronoi/export.h"
#include "circle_voronoi/io.h"
#include "values.h"

namespace {

using namespace circle_voronoi;

Result<void> writeStats(std::ostream& out, const Diagram& diagram, std::optional<int>) {
  return writeStatsJson(out, diagram);
}

template <class Write>
using Formats = std::pair<std::string_view, Write>;

/// The formats that draw a diagram.
constexpr std::array<Formats<Result<void> (*)(std::ostream&, const Diagram&, const ExportOptions&)>, 6> kExports = {
    {{"cells", writeCellsCsv},
     {"svg", writeSvg},
     {"geojson", writeGeoJson},
     {"geojsonl", writeGeoJsonLines},
     {"wkt", writeWkt},
     {"obj", writeObj}}};
constexpr std::array<Formats<Result<void> (*)(std::ostream&, const Diagram&, std::optional<int>)>, 2> kOthers = {
    {{"csv", writeDiagramCsv}, {"stats", writeStats}}};
constexpr std::string_view kDiagramFile = "json";
constexpr std::array<Formats<Result<void> (*)(std::ostream&, std::span<const Circle>, const CircleAttributes&)>, 3>
    kCircleFormats = {{{"csv", writeCirclesCsv}, {"geojson", writeCirclesGeoJson}, {"json", writeCirclesJson}}};

template <class List>
auto named(const List& list, std::string_view name) {
  return std::find_if(list.begin(), list.end(), [&](const auto& entry) { return entry.first == name; });
}

/// `{text}`, in UTF-8, of what `write` writes to a stream.
template <class Write>
val textValue(Write write) {
  std::ostringstream out;
  if (const Result<void> written = write(out); !written) return errorValue(written.error());
  const std::string text = out.str();
  val result = val::object();
  result.set("text",
             val::global("Uint8Array")
                 .new_(emscripten::typed_memory_view(text.size(), reinterpret_cast<const std::uint8_t*>(text.data()))));
  return result;
}

Error unknownFormat(const std::string& format) {
  return {ErrorCode::badOption, kNone, "There is no format \"" + format + "\" for this."};
}

Stats statsFrom(const val& value) {
  Stats stats;
  stats.method = methodFromName(value["method"].as<std::string>());
  stats.way = wayFromName(value["way"].as<std::string>());
  stats.candidates = candidatesFromName(value["candidates"].as<std::string>());
  for (const auto& [name, member] : kCountMembers) {
    stats.counts.*member = static_cast<std::int64_t>(value["counts"][std::string(name)].as<double>());
  }
  for (const auto& [name, member] : kSecondsMembers) {
    stats.seconds.*member = value["seconds"][std::string(name)].as<double>();
  }
  return stats;
}

/// Returns nothing for undefined.
std::optional<double> numberFrom(const val& value) {
  return value.isUndefined() ? std::nullopt : std::optional(value.as<double>());
}

std::optional<int> digitsFrom(const val& options) {
  const auto digits = numberFrom(options["digits"]);
  // No number has more digits.
  return digits ? std::optional(static_cast<int>(std::min(*digits, 1000.0))) : std::nullopt;
}

/// The region of the options, as its arrays; nothing where it is undefined.
std::optional<Result<Region>> regionFrom(const val& value) {
  if (value.isUndefined()) return std::nullopt;
  return Region::fromArrays(itemsFrom<double, Point>(value["points"]),
                            itemsFrom<std::int32_t, std::int32_t>(value["ringOffsets"]),
                            itemsFrom<std::int32_t, std::int32_t>(value["polygonOffsets"]));
}

ExportOptions exportOptionsFrom(const val& value) {
  ExportOptions options;
  if (const val bounds = value["bounds"]; !bounds.isUndefined()) options.bounds = itemsFrom<double, Box>(bounds).at(0);
  options.maxDistance = numberFrom(value["maxDistance"]);
  options.tolerance = numberFrom(value["tolerance"]);
  options.digits = digitsFrom(value);
  return options;
}

/// Certifies a diagram. Returns the error if it cannot be judged.
std::optional<Error> judge(Diagram& diagram) {
  auto certificate = certify(diagram);
  if (!certificate) return certificate.error();
  diagram.certificate = std::move(certificate.value());
  return std::nullopt;
}

/// Returns a text with one line per entry, because no entry has a line end. Empty if there are none.
std::string linesOf(const std::vector<std::string>& entries) {
  std::string lines;
  for (const std::string& entry : entries) {
    if (&entry != entries.data()) lines += '\n';
    lines += entry;
  }
  return lines;
}

/// Returns the entries of a text with one line per entry; `count` is 0 if there are none.
std::vector<std::string> entriesFrom(const val& lists, const char* name, std::size_t count) {
  const auto lines = lists[name].as<std::string>();
  std::vector<std::string> entries;
  std::size_t from = 0;
  for (std::size_t i = 0; i < count && !lines.empty(); ++i) {
    const std::size_t to = std::min(lines.find('\n', from), lines.size());
    entries.push_back(lines.substr(from, to - from));
    from = to + 1;
  }
  return entries;
}

val attributesValue(const CircleAttributes& attributes) {
  val result = val::object();
  result.set("properties", linesOf(attributes.properties));
  result.set("ids", linesOf(attributes.ids));
  result.set("heights", linesOf(attributes.heights));
  result.set("collection", attributes.collection);
  return result;
}

CircleAttributes attributesFrom(const val& value, std::size_t count) {
  if (value.isUndefined()) return {};
  return {entriesFrom(value, "properties", count), entriesFrom(value, "ids", count),
          entriesFrom(value, "heights", count), value["collection"].as<std::string>()};
}

ReadOptions readOptionsFrom(const val& value) {
  const auto text = [&](const char* name) { return value[name].as<std::string>(); };
  return {.weights = value["weights"].as<bool>(),
          .radii = value["points"].as<bool>() ? Radii::none : Radii::needed,
          .x = text("x"),
          .y = text("y"),
          .radius = text("radius"),
          .id = text("id"),
          .skipInvalid = value["skipInvalid"].as<bool>(),
          .crs = text("crs")};
}

/// `options` has all members of ReadCirclesOptions.
val readCircleFileValue(const std::string& text, const std::string& name, const val& options) {
  return valueOf([&] {
    const auto file = readCircleFile(text, name, readOptionsFrom(options));
    if (!file) return errorValue(file.error());
    val result = val::object();
    result.set("circles", float64Array(file->circles));
    result.set("attributes", attributesValue(file->attributes));
    result.set("areDegrees", file->areDegrees);
    val skipped = val::array();
    for (const Error& error : file->skipped) skipped.call<void>("push", errorValue(error)["error"]);
    result.set("skipped", skipped);
    return result;
  });
}

val readCirclesValue(const std::string& text, const std::string& name, const val& options) {
  return valueOf([&] {
    const auto circles = readCircles(text, name, readOptionsFrom(options));
    if (!circles) return errorValue(circles.error());
    val result = val::object();
    result.set("circles", float64Array(circles.value()));
    return result;
  });
}

/// A diagram with its circles, judged.
val readDiagramValue(const std::string& text, const std::string& name) {
  return valueOf([&] {
    auto read = readDiagramFile(text, name);
    if (!read) return errorValue(read.error());
    Diagram& diagram = read->diagram;
    const auto error = judge(diagram);
    if (error) return errorValue(*error);
    val result = diagramValue(diagram);
    result.set("metric", std::string(metricName(diagram.metric)));
    result.set("circles", float64Array(diagram.circles));
    result.set("attributes", attributesValue(read->attributes));
    return result;
  });
}

/// `attributes` may be undefined.
val writeCirclesValue(const val& coordinates, const std::string& format, const val& attributes) {
  return valueOf([&] {
    const auto found = named(kCircleFormats, format);
    if (found == kCircleFormats.end()) return errorValue(unknownFormat(format));
    const std::vector<Circle> circles = itemsFrom<double, Circle>(coordinates);
    const CircleAttributes kept = attributesFrom(attributes, circles.size());
    return textValue([&](std::ostream& out) { return found->second(out, circles, kept); });
  });
}

/// `options`: `bounds`, `region`, `maxDistance`, `tolerance`, `digits` and `attributes`, each possibly undefined.
val writeDiagramValue(const val& value, const std::string& format, const val& options) {
  return valueOf([&] {
    Diagram diagram = diagramFrom(value);
    diagram.metric = metricFromName(value["metric"].as<std::string>()).value_or(Metric::circles);
    const auto found = named(kExports, format);
    const bool isDrawn = found != kExports.end();
    // The arrays may have been changed, and only a certified diagram can be drawn.
    const auto error = judge(diagram);
    if (error) return errorValue(*error);
    diagram.stats = statsFrom(value["stats"]);
    const CircleAttributes attributes = attributesFrom(options["attributes"], diagram.circles.size());
    if (isDrawn) {
      ExportOptions drawn = exportOptionsFrom(options);
      const auto region = regionFrom(options["region"]);
      if (region && !region->ok()) return errorValue(region->error());
      drawn.attributes = &attributes;
      if (region) drawn.region = &region->value();
      return textValue([&](std::ostream& out) { return found->second(out, diagram, drawn); });
    }
    if (format == kDiagramFile) {
      return textValue(
          [&](std::ostream& out) { return writeDiagramFile(out, diagram, attributes, digitsFrom(options)); });
    }
    const auto other = named(kOthers, format);
    if (other == kOthers.end()) return errorValue(unknownFormat(format));
    return textValue([&](std::ostream& out) { return other->second(out, diagram, digitsFrom(options)); });
  });
}

bool holdsDiagramValue(const std::string& text) { return holdsDiagram(text); }

}  // namespace

EMSCRIPTEN_BINDINGS(circle_voronoi_files) {
  emscripten::function("readCircles", &readCirclesValue);
  emscripten::function("readCircleFile", &readCircleFileValue);
  emscripten::function("readDiagram", &readDiagramValue);
  emscripten::function("holdsDiagram", &holdsDiagramValue);
  emscripten::function("writeCircles", &writeCirclesValue);
  emscripten::function("writeDiagram", &writeDiagramValue);
}
