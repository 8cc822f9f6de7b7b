// SPDX-License-Identifier: GPL-3.0-or-later
#include "output.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <ostream>
#include <string_view>
#include <system_error>
#include <vector>

#include "circle_voronoi/export.h"
#include "circle_voronoi/io.h"
#include "failure.h"

namespace circle_voronoi::cli {
namespace {

constexpr const char* kDefaultFormat = "json";
const std::vector<std::string> kFormats = {"json", "csv", "svg", "geojson", "wkt", "obj", "stats"};

using WriteExport = void (*)(std::ostream&, std::span<const Circle>, const Diagram&, const ExportOptions&);
/// The formats that need a certified diagram.
const std::map<std::string, WriteExport> kExports = {
    {"svg", writeSvg}, {"geojson", writeGeoJson}, {"wkt", writeWkt}, {"obj", writeObj}};

using WriteCircles = void (*)(std::ostream&, std::span<const Circle>);
const std::map<std::string, WriteCircles> kCircleFormats = {
    {"csv", writeCirclesCsv}, {"geojson", writeCirclesGeoJson}, {"json", writeCirclesJson}};

std::string formatOf(const Output& output) {
  if (!output.format.empty()) return output.format;
  const std::string ending = std::filesystem::path(output.file).extension().string();
  const bool isFormat = !ending.empty() && std::ranges::find(kFormats, ending.substr(1)) != kFormats.end();
  return isFormat ? ending.substr(1) : kDefaultFormat;
}

/// All of the text as a number that is finite.
std::optional<double> readNumber(std::string_view text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, code] = std::from_chars(text.data(), end, value);
  if (code != std::errc() || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<Box> readBox(std::string_view text) {
  std::array<double, 4> values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t comma = text.find(',');
    const bool isLast = i + 1 == values.size();
    if (isLast != (comma == std::string_view::npos)) return std::nullopt;
    const auto value = readNumber(text.substr(0, comma));
    if (!value) return std::nullopt;
    values[i] = *value;
    if (!isLast) text.remove_prefix(comma + 1);
  }
  const Box box = {values[0], values[1], values[2], values[3]};
  if (!(box.minX < box.maxX && box.minY < box.maxY)) return std::nullopt;
  if (!std::isfinite(box.maxX - box.minX) || !std::isfinite(box.maxY - box.minY)) return std::nullopt;
  return box;
}

ExportOptions exportOptions(const Output& output) {
  ExportOptions options;
  if (!output.box.empty()) options.box = readBox(output.box);
  if (output.tolerance > 0) options.tolerance = output.tolerance;
  return options;
}

void write(const Output& output, ProgressLine& progress, const std::function<void(std::ostream&)>& writer) {
  // The terminal, or the program that reads the text, may use the same screen.
  if (output.file == kStandardStream) progress.end();
  progress.show("write");
  writeText(output.file, writer);
}

}  // namespace

void addOutputFile(CLI::App& command, Output& output) {
  command.add_option("-o,--output", output.file, "The file to write; - is standard output")
      ->type_name("FILE")
      ->capture_default_str();
}

void addOutputOptions(CLI::App& command, Output& output) {
  addOutputFile(command, output);
  command
      .add_option("--format", output.format,
                  "What to write (see below); by default what the name of the output ends in, or else json")
      ->type_name("FORMAT")
      ->check(CLI::IsMember(kFormats));
  command
      .add_option("--box", output.box,
                  "svg, geojson, wkt, obj: the box to clip to; by default some room around the circles")
      ->type_name("MINX,MINY,MAXX,MAXY")
      ->check([](const std::string& text) { return readBox(text) ? "" : "expected MINX,MINY,MAXX,MAXY."; });
  command
      .add_option("--tolerance", output.tolerance,
                  "svg, geojson, wkt, obj: how near to the true curves; by default a hundred-thousandth of the box")
      ->type_name("DISTANCE")
      ->check([](const std::string& text) {
        const auto distance = readNumber(text);
        return distance && *distance > 0 ? "" : "expected a number above 0.";
      });
}

void writeDiagram(const Output& output, const std::string& name, std::span<const Circle> circles,
                  const Diagram& diagram, ProgressLine& progress) {
  const std::string format = formatOf(output);
  const auto found = kExports.find(format);
  if (found != kExports.end() && !diagram.certificate.certified()) {
    throw Failure{kFailure, name + ": the diagram is not certified: " + diagram.certificate.message};
  }
  write(output, progress, [&](std::ostream& out) {
    if (found != kExports.end()) return found->second(out, circles, diagram, exportOptions(output));
    if (format == "stats") return writeStatsJson(out, diagram);
    if (format == "csv") return writeDiagramCsv(out, diagram);
    writeJson(out, circles, diagram);
  });
}

void writeCircles(const Output& output, std::span<const Circle> circles, ProgressLine& progress) {
  const std::string format = formatOf(output);
  const auto found = kCircleFormats.find(format);
  if (found == kCircleFormats.end()) {
    throw Failure{kBadInput, "Circles alone cannot be written as " + format + "; compute writes their diagram so."};
  }
  write(output, progress, [&](std::ostream& out) { found->second(out, circles); });
}

}  // namespace circle_voronoi::cli
