// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <ostream>
#include <string>

#include "circle_voronoi/certificate.h"
#include "circle_voronoi/io.h"
#include "commands.h"
#include "failure.h"
#include "files.h"

namespace circle_voronoi::cli {
namespace {

void runVerify(const std::string& input) {
  const std::string name = input == kStandardStream ? "standard input" : input;
  const auto file = readDiagram(readText(input), name);
  if (!file) throw Failure{kBadInput, file.error().message};
  const auto& [circles, diagram] = file.value();
  const auto certificate = certify(circles, diagram);
  if (!certificate) throw Failure{kBadInput, name + ": " + certificate.error().message};
  if (!certificate.value().certified()) throw Failure{kFailure, name + ": " + certificate.value().message};
  writeText(kStandardStream, [&](std::ostream& out) {
    out << "certified: " << circles.size() << " circles, " << diagram.hidden.size() << " of them hidden; "
        << diagram.vertices.size() << " vertices, " << diagram.edges.size() << " edges\n";
  });
}

}  // namespace

void addVerifyCommand(CLI::App& program) {
  const auto input = std::make_shared<std::string>();
  CLI::App* command =
      program.add_subcommand("verify", "Judge whether a diagram, as compute writes it, is right for its circles");
  command->add_option("FILE", *input, "A diagram as JSON; - is standard input")->required();
  command->footer("The exit status is 0 if the diagram is certified, 1 if it is wrong, 2 if it cannot be read.");
  command->callback([input] { runVerify(*input); });
}

}  // namespace circle_voronoi::cli
