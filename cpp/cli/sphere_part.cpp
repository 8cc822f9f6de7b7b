// SPDX-License-Identifier: GPL-3.0-or-later
#include "sphere_part.h"

#include <map>
#include <ostream>
#include <utility>
#include <vector>

#include "circle_voronoi/sphere.h"
#include "circle_voronoi/sphere_io.h"
#include "command_error.h"
#include "files.h"

namespace circle_voronoi::cli {
namespace {

using WriteSphere = Result<void> (*)(std::ostream&, const SphereDiagram&, const SphereExportOptions&);
const std::map<std::string, WriteSphere> kSphereFormats = {{"json", writeSphereJson},
                                                           {"csv", writeSphereCsv},
                                                           {"geojson", writeSphereGeoJson},
                                                           {"geojsonl", writeSphereGeoJsonLines}};

/// The radius of the Earth in each unit of lengths.
const std::map<std::string, double> kEarthRadii = {{"km", kEarthRadius}, {"m", 1000 * kEarthRadius}};

}  // namespace

void addSphereOptions(CLI::App& command, SpherePart& part) {
  command.add_flag("--sphere", part.isAsked,
                   "Centers are longitude and latitude in degrees: compute on the Earth, a sphere with a radius of "
                   "6371.0088 km (json, csv, geojson, geojsonl)");
  command
      .add_option("--unit", part.unit,
                  "--sphere: the unit of radii, of --max-distance and --tolerance, and of areas, as its square")
      ->type_name("UNIT")
      ->check(CLI::IsMember(&kEarthRadii))
      ->capture_default_str();
}

void check(const SpherePart& part, const CLI::App& command, const Output& output) {
  if (!part.isAsked) {
    if (command.count("--unit") > 0) throw CommandError{kBadInput, "--unit needs --sphere."};
    return;
  }
  for (const char* option : {"--bounds", "--region"}) {
    if (command.count(option) == 0) continue;
    throw CommandError{kBadInput,
                       std::string("--sphere takes no ") + option + ": cut the polygons with another program."};
  }
  for (const char* option : {"--project", "--lattice", "--known", "--trace", "--method"}) {
    if (command.count(option) > 0) throw CommandError{kBadInput, std::string("--sphere takes no ") + option + "."};
  }
  if (!kSphereFormats.contains(output.format)) {
    throw CommandError{kBadInput, "--sphere needs --format json, csv, geojson or geojsonl."};
  }
  const auto refuse = [&](const char* option, bool isUsed, const char* formats) {
    if (command.count(option) == 0 || isUsed) return;
    throw CommandError{kBadInput, std::string(option) + " needs --format " + formats + "."};
  };
  const bool isDrawn = output.format.starts_with("geojson");
  refuse("--tolerance", isDrawn, "geojson or geojsonl");
  for (const char* option : {"--max-distance", "--digits"}) {
    refuse(option, isDrawn || output.format == "csv", "csv, geojson or geojsonl");
  }
}

SphereDiagram diagramOnSphere(const SpherePart& part, const CirclesInput& input, const CircleFile& file, int threads,
                              ProgressLine& progress) {
  std::vector<Cap> caps;
  caps.reserve(file.circles.size());
  for (const auto& [x, y, r] : file.circles) caps.push_back({x, y, r});
  progress.show("compute");
  auto diagram = computeSphere(caps, {kEarthRadii.at(part.unit), input.weights(), threads});
  if (!diagram) fail(diagram.error(), inputName(input.file) + ": ");
  noteSkipped(file, progress);
  noteHidden(hiddenWarning(*diagram), "--unit and --radius", progress);
  return std::move(diagram).value();
}

void computeOnSphere(const SpherePart& part, const Output& output, const CirclesInput& input, CircleFile file,
                     int threads, ProgressLine& progress) {
  const std::string name = inputName(input.file);
  const SphereDiagram diagram = diagramOnSphere(part, input, file, threads, progress);
  SphereExportOptions options;
  if (output.tolerance > 0) options.tolerance = output.tolerance;
  options.maxDistance = output.maxDistance;
  options.digits = output.digits;
  options.attributes = &file.attributes;
  write(output, name, progress,
        [&](std::ostream& out) { return kSphereFormats.at(output.format)(out, diagram, options); });
}

}  // namespace circle_voronoi::cli
