// SPDX-License-Identifier: GPL-3.0-or-later
#include "output.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <ostream>
#include <vector>

#include "box.h"
#include "circle_voronoi/cells.h"
#include "circle_voronoi/export.h"
#include "circle_voronoi/finder.h"
#include "circle_voronoi/io.h"
#include "circles_input.h"
#include "command_error.h"
#include "number_text.h"
#include "whole_number.h"

namespace circle_voronoi::cli {
namespace {

constexpr const char* kDefaultFormat = "json";
/// The ratio of scales on a map from which on cells may be visibly wrong.
constexpr double kWorthAWarning = 1.02;
const std::vector<std::string> kFormats = {"json", "csv", "cells", "svg", "geojson", "geojsonl", "wkt", "obj", "stats"};

using WriteExport = Result<void> (*)(std::ostream&, const Diagram&, const ExportOptions&);
/// The formats that clip a diagram.
const std::map<std::string, WriteExport> kExports = {{"cells", writeCellsCsv},  {"svg", writeSvg},
                                                     {"geojson", writeGeoJson}, {"geojsonl", writeGeoJsonLines},
                                                     {"wkt", writeWkt},         {"obj", writeObj}};

/// Returns a given option that only drawings of a diagram use, or null.
const char* drawingOption(const Output& output) {
  return !output.bounds.empty()                                 ? "--bounds"
         : !output.regionFile.empty() && !output.isRegionNeeded ? "--region"
         : output.tolerance > 0                                 ? "--tolerance"
         : output.maxDistance                                   ? "--max-distance"
                                                                : nullptr;
}

using WriteCircles = Result<void> (*)(std::ostream&, std::span<const Circle>, const CircleAttributes&);
const std::map<std::string, WriteCircles> kCircleFormats = {
    {"csv", writeCirclesCsv}, {"geojson", writeCirclesGeoJson}, {"json", writeCirclesJson}};

/// Prints a warning on standard error if members of a collection such as `crs` get lost, although circles or cells keep
/// their other attributes.
void noteCollection(const Output& output, ProgressLine& progress) {
  const bool isLost =
      output.format == "csv" || output.format == "cells" || output.format == "json" || output.format == "geojsonl";
  if (!isLost) return;
  CircleAttributes attributes = {.collection = output.attributes.collection};
  // The member was recorded by this program, and the cells are in degrees again.
  Projection::removeFrom(attributes);
  if (attributes.collection.empty()) return;
  note("The format " + output.format + " has no place for the members of the collection, such as crs.", progress);
}

/// Projects the box and the region, which are in degrees.
void projectLimits(Output& output) {
  if (!output.bounds.empty()) {
    Box box;
    (void)readBox(output.bounds, box);
    output.region = Region::from(box).value();
    output.bounds.clear();
  }
  if (output.region) {
    const std::string what = output.regionFile.empty() ? "--bounds" : inputName(output.regionFile);
    output.region = output.projection->plane(*output.region, what, {.dissolve = output.dissolve});
  }
}

/// Prints a warning on standard error if the scale of the map differs much between circles, as Mercator's does.
void noteScales(const Projection& projection, std::span<const Circle> circles, ProgressLine& progress) {
  double least = std::numeric_limits<double>::infinity();
  double largest = 0;
  for (const Circle& c : circles) {
    least = std::min(least, projection.scaleAt(c.y));
    largest = std::max(largest, projection.scaleAt(c.y));
  }
  const double ratio = std::round(largest / least * 100) / 100;
  if (ratio <= kWorthAWarning) return;
  note("On this map lengths are " + numberText(ratio) +
           " times as large at some circles as at others, so places between them may be in a wrong cell. --sphere has "
           "no such error.",
       progress);
}

/// Throws CommandError if a cell that is written in degrees contains a pole: its ring would go around the pole, not
/// around the cell.
void refusePoles(const Output& output, const std::string& name, const Diagram& diagram) {
  if (!output.projection || !(output.format.starts_with("geojson") || output.format == "wkt")) return;
  if (diagram.circles.empty()) return;
  const Box box = output.region ? output.region->bounds() : exportBox(diagram, output.maxDistance);
  for (const Point pole : output.projection->poles()) {
    const bool isIn = pole.x >= box.minX && pole.x <= box.maxX && pole.y >= box.minY && pole.y <= box.maxY;
    if (!isIn || (output.region && !output.region->contains(pole))) continue;
    const CircleIndex nearest = Finder(diagram).find(pole);
    // A power is compared with the square of a length.
    const double unit = diagram.metric == Metric::power ? std::abs(output.maxDistance.value_or(0)) : 1;
    if (output.maxDistance && distanceFrom(diagram, nearest, pole) > *output.maxDistance * unit) continue;
    throw CommandError{kBadInput, name + ": the cell of circle " + std::to_string(nearest) +
                                      " contains a pole, so it is no polygon in degrees around its center; use "
                                      "--sphere."};
  }
}

}  // namespace

void addOutputFile(CLI::App& command, Output& output) {
  command.add_option("-o,--output", output.file, "The file to write; - is standard output")
      ->type_name("FILE")
      ->capture_default_str();
}

void addFormatOption(CLI::App& command, Output& output, const std::vector<std::string>& formats) {
  command
      .add_option("--format", output.format,
                  "The format of the output, see below; by default the extension of its file, or json if it has none")
      ->type_name("FORMAT")
      ->check(CLI::IsMember(formats));
}

void addRegionOptions(CLI::App& command, Output& output, const std::string& description) {
  command.add_option("--region", output.regionFile, description)->type_name("FILE");
  command.add_flag("--dissolve", output.dissolve, "Merge polygons of the region that share borders or overlap");
}

void addOutputOptions(CLI::App& command, Output& output) {
  addOutputFile(command, output);
  addFormatOption(command, output, kFormats);
  command
      .add_option("--bounds", output.bounds,
                  "The box to clip to (cells, svg, geojson, geojsonl, wkt, obj); by default the circles with a margin "
                  "around them")
      ->type_name("MINX,MINY,MAXX,MAXY")
      ->check([](const std::string& text) {
        Box box;
        return readBox(text, box);
      });
  addRegionOptions(
      command, output,
      "A file with the region to clip to, as GeoJSON or well-known text (cells, svg, geojson, geojsonl, wkt, obj)");
  command
      .add_option("--tolerance", output.tolerance,
                  "The largest distance between the output and the true curves (svg, geojson, geojsonl, wkt, obj); by "
                  "default a hundred-thousandth of the box")
      ->type_name("DISTANCE")
      ->check([](const std::string& text) {
        const auto distance = readNumber(text);
        return distance && *distance > 0 ? "" : "expected a number above 0.";
      });
  command
      .add_option("--max-distance", output.maxDistance,
                  "Cut cells and edges at this distance from their circles (cells, svg, geojson, geojsonl, wkt, obj)")
      ->type_name("DISTANCE")
      ->check([](const std::string& text) {
        const auto distance = readNumber(text);
        if (distance && std::abs(*distance) <= kRegionLimit) return std::string();
        return std::string("expected a number up to ") + kRegionLimitText + ".";
      });
  command
      .add_option(
          "--digits", output.digits,
          "The largest number of digits after the decimal point in the coordinates and areas of a diagram; by default "
          "as many as the tolerance needs, and all digits in json and csv")
      ->type_name("COUNT")
      ->transform(wholeNumber(std::numeric_limits<int>::max()));
}

void write(const Output& output, const std::string& name, ProgressLine& progress,
           const std::function<Result<void>(std::ostream&)>& writer) {
  // The output may share the screen with the progress line.
  if (output.file == kStandardStream) progress.end();
  progress.show("write");
  writeText(output.file, [&](std::ostream& out) { checkWritten(writer(out), name + ": "); });
}

std::string endingOf(const std::string& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; };
  std::ranges::transform(ending, ending.begin(), lower);
  return ending.empty() ? "" : ending.substr(1);
}

void settle(Output& output) {
  if (output.format.empty()) {
    const std::string ending = endingOf(output.file);
    if (!ending.empty() && std::ranges::find(kFormats, ending) == kFormats.end()) {
      throw CommandError{kBadInput, output.file + ": no format is called " + ending + "; choose one with --format."};
    }
    output.format = ending.empty() ? kDefaultFormat : ending;
  }
  if (output.format == "cells" && output.tolerance > 0) {
    throw CommandError{kBadInput, "--tolerance is not for --format cells: areas are exact."};
  }
  if (output.format == "stats" && output.digits) throw CommandError{kBadInput, "--digits is not for --format stats."};
  if (!kExports.contains(output.format) && !output.isOnSphere) {
    if (const char* unused = drawingOption(output))
      throw CommandError{kBadInput, std::string(unused) + " needs --format " + (output.tolerance > 0 ? "" : "cells, ") +
                                        "svg, geojson, geojsonl, wkt or obj."};
  }
  if (output.dissolve && output.regionFile.empty()) throw CommandError{kBadInput, "--dissolve needs --region."};
  if (output.regionFile.empty()) return;
  if (!output.bounds.empty()) throw CommandError{kBadInput, "--region takes no --bounds."};
  auto region = readRegion(readText(output.regionFile), inputName(output.regionFile), {.dissolve = output.dissolve});
  if (!region) fail(region.error(), "");
  output.region = *std::move(region);
}

ExportOptions exportOptions(const Output& output) {
  ExportOptions options;
  if (!output.bounds.empty()) (void)readBox(output.bounds, options.bounds.emplace());
  if (output.region) options.region = &*output.region;
  if (output.tolerance > 0) options.tolerance = output.tolerance;
  options.maxDistance = output.maxDistance;
  options.digits = output.digits;
  options.attributes = &output.attributes;
  if (output.projection) {
    options.place = [projection = *output.projection](Point p) { return projection.degrees(p); };
  }
  return options;
}

void checkCrs(const CLI::App& command, const Output& output) {
  if (command.count("--crs") == 0 || output.format == "geojson" || output.format == "json") return;
  throw CommandError{kBadInput, "--crs needs --format geojson or json."};
}

void addProjectOption(CLI::App& command, std::string& name) {
  command
      .add_option("--project", name,
                  "Centers are longitude and latitude in degrees, radii and distances are meters: compute on this map, "
                  "and write cells in degrees again")
      ->type_name("MAP")
      ->check(CLI::IsMember(kProjections));
}

void project(const std::string& name, std::vector<Circle>& circles, Output& output, const std::string& input,
             ProgressLine& progress) {
  if (name.empty() || circles.empty()) return;
  const auto found = std::ranges::find(kProjections, name);
  const auto kind = static_cast<Projection::Kind>(found - kProjections.begin());
  output.projection = Projection::around(circles, kind, input);
  noteScales(*output.projection, circles, progress);
  for (Circle& circle : circles) circle = output.projection->plane(circle);
  output.projection->record(output.attributes);
  projectLimits(output);
}

void takeRecordedProjection(Output& output, const CircleAttributes& attributes) {
  output.projection = Projection::recordedIn(attributes);
  if (output.projection) projectLimits(output);
}

void writeDiagram(const Output& output, const std::string& name, const Diagram& diagram, ProgressLine& progress) {
  const auto found = kExports.find(output.format);
  refusePoles(output, name, diagram);
  if (output.format == "geojsonl" || output.format == "cells") noteCollection(output, progress);
  write(output, name, progress, [&](std::ostream& out) {
    if (found != kExports.end()) return found->second(out, diagram, exportOptions(output));
    if (output.format == "stats") return writeStatsJson(out, diagram);
    if (output.format == "csv") return writeDiagramCsv(out, diagram, output.digits);
    return writeDiagramFile(out, diagram, output.attributes, output.digits);
  });
}

void addLatticeOption(CLI::App& command, std::string& lattice) {
  command
      .add_option("--lattice", lattice,
                  "The circles repeat with these two periods, as in a box whose opposite sides are glued together "
                  "(json, csv, svg, geojson, geojsonl, stats)")
      ->type_name("AX,AY,BX,BY")
      ->check([](const std::string& text) {
        Lattice periods;
        return readLattice(text, periods);
      });
}

void checkPeriodicOutput(const Output& output) {
  if (output.format == "cells" || output.format == "wkt" || output.format == "obj") {
    throw CommandError{kBadInput, "--lattice takes no --format " + output.format + "."};
  }
  const char* unused = drawingOption(output);
  if (unused != nullptr && std::string_view(unused) != "--tolerance") {
    throw CommandError{kBadInput, "--lattice takes no " + std::string(unused) + ": cells are written whole."};
  }
  if (output.maxDistance) throw CommandError{kBadInput, "--lattice takes no --max-distance: cells are written whole."};
}

void writePeriodicDiagram(const Output& output, const std::string& name, const PeriodicDiagram& periodic,
                          ProgressLine& progress) {
  write(output, name, progress, [&](std::ostream& out) {
    if (output.format == "svg") return writePeriodicSvg(out, periodic, exportOptions(output));
    if (output.format == "geojson") return writePeriodicGeoJson(out, periodic, exportOptions(output));
    if (output.format == "geojsonl") return writePeriodicGeoJsonLines(out, periodic, exportOptions(output));
    if (output.format == "csv") return writeContactsCsv(out, periodic, output.digits);
    if (output.format == "stats") return writeStatsJson(out, periodic.diagram);
    return writePeriodicJson(out, periodic, output.digits, output.attributes);
  });
}

void writeCircles(const Output& output, const std::string& name, std::span<const Circle> circles,
                  ProgressLine& progress) {
  if (output.digits) throw CommandError{kBadInput, "--digits is for diagrams; circles keep the digits that they have."};
  if (const char* unused = drawingOption(output))
    throw CommandError{kBadInput, std::string(unused) + " is for diagrams; circles are written as they are."};
  const auto found = kCircleFormats.find(output.format);
  if (found == kCircleFormats.end()) {
    throw CommandError{kBadInput,
                       "Circles alone cannot be written as " + output.format + "; compute writes their diagram so."};
  }
  noteCollection(output, progress);
  write(output, name, progress, [&](std::ostream& out) { return found->second(out, circles, output.attributes); });
}

}  // namespace circle_voronoi::cli
