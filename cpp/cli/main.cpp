// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <csignal>
#include <exception>
#include <iostream>
#include <sstream>
#include <string>

#include "command_error.h"
#include "commands.h"
#include "files.h"

namespace {

using namespace circle_voronoi::cli;

int fail(ExitStatus status, const std::string& message) {
  std::cerr << "circle-voronoi: " << message << '\n';
  return status;
}

std::string footer() {
  std::string text =
      "In the npm package, the command picture draws a link or a file as the playground shows it.\n\nExit status:";
  for (const auto& [status, meaning] : kExitMeanings)
    text += "\n  " + std::to_string(status) + "  " + std::string(meaning);
  return text;
}

/// Checks the first word, because CLI11 would only report that there is no command. Throws CommandError.
void checkCommand(const CLI::App& program, int argumentCount, char** arguments) {
  const std::string first = argumentCount > 1 ? arguments[1] : "";
  const auto commands = program.get_subcommands([](const CLI::App*) { return true; });
  const auto isFirst = [&](const CLI::App* command) { return command->get_name() == first; };
  if (std::ranges::any_of(commands, isFirst) || program.get_option_no_throw(first) != nullptr) return;
  if (first == "picture") {
    throw CommandError{kBadInput, "The npm package has the command picture: npx circle-voronoi picture ..."};
  }
  std::string names;
  for (std::size_t i = 0; i < commands.size(); ++i) {
    names += (i == 0 ? "" : i + 1 == commands.size() ? " and " : ", ") + commands[i]->get_name();
  }
  const std::string problem = first.empty()            ? "A command is missing"
                              : first.starts_with('-') ? "There is no option " + first
                                                       : "There is no command \"" + first + "\"";
  throw CommandError{kBadInput, problem + "; the commands are " + names + "."};
}

}  // namespace

int main(int argumentCount, char** arguments) {
  // Exceeding the file size limit then is a normal error of writing.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    CLI::App program("Voronoi diagram of circles", "circle-voronoi");
    program.set_version_flag("--version", "circle-voronoi " CIRCLE_VORONOI_VERSION);
    program.require_subcommand(1);
    addCertifyCommand(program);
    addComputeCommand(program);
    addConvertCommand(program);
    addEditCommand(program);
    addFindCommand(program);
    addFitCommand(program);
    addGenerateCommand(program);
    addTileCommand(program);
    addTreemapCommand(program);
    program.footer(footer());
    checkCommand(program, argumentCount, arguments);
    try {
      program.parse(argumentCount, arguments);
    } catch (const CLI::Success& success) {  // --help and --version
      std::ostringstream text;
      program.exit(success, text);
      writeText(kStandardStream, [&](std::ostream& out) { out << text.str(); });
    } catch (const CLI::ParseError& error) {
      return fail(kBadInput, error.what());
    }
  } catch (const CommandError& failure) {
    return fail(failure.status, failure.message);
  } catch (const std::bad_alloc&) {
    return fail(kBadInput, "The circles do not fit in memory.");
  } catch (const std::exception& error) {
    return fail(kFailure, error.what());
  }
  return kSuccess;
}
