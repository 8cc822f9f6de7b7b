// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <memory>
#include <ostream>
#include <string>

#include "circle_voronoi/compute.h"
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

struct ComputeArguments {
  std::string input;
  std::string output = kStandardStream;
  std::string format = "json";
  std::string method = "auto";
  std::string candidates = "dynamic";
  int samples = Options{}.samples;
  bool repair = Options{}.repair;
};

void runCompute(const ComputeArguments& arguments) {
  const std::string name = arguments.input == kStandardStream ? "standard input" : arguments.input;
  const auto circles = readCircles(readText(arguments.input), name);
  if (!circles) throw Failure{kBadInput, circles.error().message};

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

  writeText(arguments.output, [&](std::ostream& out) {
    if (arguments.format == "stats") {
      writeStatsJson(out, diagram.value());
    } else {
      writeJson(out, circles.value(), diagram.value());
    }
  });
}

}  // namespace

void addComputeCommand(CLI::App& program) {
  const auto arguments = std::make_shared<ComputeArguments>();
  CLI::App* command = program.add_subcommand("compute", "Compute the Voronoi diagram of the circles in a file");
  command->add_option("FILE", arguments->input, "Circles: CSV lines x,y,r or JSON; - is standard input")->required();
  command->add_option("--format", arguments->format, "What to write: the diagram, or its stats alone")
      ->check(CLI::IsMember({"json", "stats"}))
      ->capture_default_str();
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
