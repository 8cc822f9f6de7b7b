// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <ostream>
#include <string>

#include "circle_voronoi/certify.h"
#include "circle_voronoi/io.h"
#include "circle_voronoi/progress.h"
#include "command_error.h"
#include "commands.h"
#include "files.h"
#include "progress_line.h"

namespace circle_voronoi::cli {
namespace {

struct CertifyArguments {
  std::string input;
  std::string progress = "auto";
};

void runCertify(const CertifyArguments& arguments) {
  ProgressLine progress(arguments.progress);
  progress.show("read");
  const std::string name = inputName(arguments.input);
  const auto read = readDiagram(readText(arguments.input), name);
  if (!read) throw CommandError{kBadInput, read.error().message};
  const Diagram& diagram = read.value();
  progress.show(stageName(Stage::certify));
  const auto certificate = certify(diagram);
  progress.end();
  if (!certificate) throw CommandError{kBadInput, name + ": " + certificate.error().message};
  if (!certificate.value().certified()) throw CommandError{kFailure, name + ": " + certificate.value().message};
  writeText(kStandardStream, [&](std::ostream& out) {
    out << "certified: " << diagram.circles.size() << " circles, " << diagram.hidden.size() << " of them hidden; "
        << diagram.vertices.size() << " vertices, " << diagram.edges.size() << " edges\n";
  });
}

}  // namespace

void addCertifyCommand(CLI::App& program) {
  const auto arguments = std::make_shared<CertifyArguments>();
  CLI::App* command =
      program.add_subcommand("certify", "Check whether a diagram that compute wrote is right for its circles");
  command->add_option("FILE", arguments->input, "A diagram as JSON; - is standard input")->type_name("")->required();
  addProgressOption(*command, arguments->progress);
  command->callback([arguments] { runCertify(*arguments); });
}

}  // namespace circle_voronoi::cli
