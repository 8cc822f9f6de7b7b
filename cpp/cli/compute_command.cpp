// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "circle_voronoi/compute.h"
#include "circle_voronoi/export.h"
#include "circle_voronoi/io.h"
#include "commands.h"
#include "failure.h"
#include "files.h"

namespace circle_voronoi::cli {
namespace {

const std::map<std::string, Method> kMethods = {
    {"auto", Method::automatic}, {"touching-disc", Method::touchingDisc}, {"flip", Method::flip}};
const std::map<std::string, Candidates> kCandidates = {
    {"dynamic", Candidates::dynamic}, {"uniform", Candidates::uniform}, {"all-pairs", Candidates::allPairs}};

using Export = void (*)(std::ostream&, std::span<const Circle>, const Diagram&, const ExportOptions&);
/// The formats that need a certified diagram.
const std::map<std::string, Export> kExports = {
    {"svg", writeSvg}, {"geojson", writeGeoJson}, {"wkt", writeWkt}, {"obj", writeObj}};

struct ComputeArguments {
  std::string input;
  std::string output = kStandardStream;
  std::string format = "json";
  std::string method = "auto";
  std::string candidates = "dynamic";
  int samples = Options{}.samples;
  bool repair = Options{}.repair;
  std::vector<double> box;  ///< four numbers, or none
  double tolerance = 0;     ///< 0: the default
};

ExportOptions exportOptions(const ComputeArguments& arguments) {
  ExportOptions options;
  if (!arguments.box.empty()) {
    const auto& box = arguments.box;
    if (!(box[0] < box[2] && box[1] < box[3])) throw Failure{kBadInput, "--box: expected MINX,MINY,MAXX,MAXY."};
    options.box = Box{box[0], box[1], box[2], box[3]};
  }
  if (arguments.tolerance > 0) options.tolerance = arguments.tolerance;
  return options;
}

void write(std::ostream& out, const ComputeArguments& arguments, std::span<const Circle> circles,
           const Diagram& diagram, const ExportOptions& options) {
  if (arguments.format == "stats") return writeStatsJson(out, diagram);
  if (arguments.format == "csv") return writeDiagramCsv(out, diagram);
  if (arguments.format == "json") return writeJson(out, circles, diagram);
  kExports.at(arguments.format)(out, circles, diagram, options);
}

void runCompute(const ComputeArguments& arguments) {
  const std::string name = arguments.input == kStandardStream ? "standard input" : arguments.input;
  const auto circles = readCircles(readText(arguments.input), name);
  if (!circles) throw Failure{kBadInput, circles.error().message};

  const ExportOptions shape = exportOptions(arguments);
  Options options;
  options.method = kMethods.at(arguments.method);
  options.candidates = kCandidates.at(arguments.candidates);
  options.samples = arguments.samples;
  options.repair = arguments.repair;
  const auto diagram = compute(circles.value(), options);
  if (!diagram) {
    const Error& error = diagram.error();
    throw Failure{error.code == ErrorCode::notCertified ? kFailure : kBadInput, name + ": " + error.message};
  }

  if (kExports.contains(arguments.format) && !diagram.value().certificate.certified()) {
    throw Failure{kFailure, name + ": the diagram is not certified: " + diagram.value().certificate.message};
  }
  writeText(arguments.output,
            [&](std::ostream& out) { write(out, arguments, circles.value(), diagram.value(), shape); });
}

}  // namespace

void addComputeCommand(CLI::App& program) {
  const auto arguments = std::make_shared<ComputeArguments>();
  CLI::App* command = program.add_subcommand("compute", "Compute the Voronoi diagram of the circles in a file");
  command->add_option("FILE", arguments->input, "Circles: CSV lines x,y,r, JSON or GeoJSON; - is standard input")
      ->required();
  command
      ->add_option("--format", arguments->format,
                   "What to write: the diagram, a drawing, polygons of cells, or stats alone")
      ->check(CLI::IsMember({"json", "csv", "svg", "geojson", "wkt", "obj", "stats"}))
      ->capture_default_str();
  command->add_option("--box", arguments->box, "svg, geojson, wkt, obj: clip to MINX,MINY,MAXX,MAXY")
      ->delimiter(',')
      ->expected(4);
  command->add_option("--tolerance", arguments->tolerance, "svg, geojson, wkt, obj: how near the true curves to keep")
      ->check(CLI::PositiveNumber);
  command->add_option("--method", arguments->method, "How to build the diagram")
      ->check(CLI::IsMember(&kMethods))
      ->capture_default_str();
  command
      ->add_option("--candidates", arguments->candidates, "touching-disc: which pairs of circles get an antipodal disc")
      ->check(CLI::IsMember(&kCandidates))
      ->capture_default_str();
  command
      ->add_option("--samples", arguments->samples,
                   "dynamic: samples inside each angle of a Delaunay face (" + std::to_string(kDefaultDynamicSamples) +
                       "); uniform: samples on each circle (" + std::to_string(kDefaultUniformSamples) + ")")
      ->check(CLI::Range(0, kMaxSamples));
  command->add_flag("--repair", arguments->repair, "dynamic: add samples where the certificate failed and try again");
  command->add_option("-o,--output", arguments->output, "The file to write; - is standard output");
  command->callback([arguments] { runCompute(*arguments); });
}

}  // namespace circle_voronoi::cli
