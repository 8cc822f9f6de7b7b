// SPDX-License-Identifier: GPL-3.0-or-later
#include <exception>
#include <iostream>
#include <string>

#include "commands.h"
#include "failure.h"

namespace {

using namespace circle_voronoi::cli;

int fail(ExitStatus status, const std::string& message) {
  std::cerr << "circle-voronoi: " << message << '\n';
  return status;
}

}  // namespace

int main(int argumentCount, char** arguments) {
  std::ios::sync_with_stdio(false);
  try {
    CLI::App program("Voronoi diagram of circles", "circle-voronoi");
    program.set_version_flag("--version", "circle-voronoi " CIRCLE_VORONOI_VERSION);
    program.require_subcommand(1);
    addComputeCommand(program);
    addConvertCommand(program);
    addGenerateCommand(program);
    addVerifyCommand(program);
    try {
      program.parse(argumentCount, arguments);
    } catch (const CLI::Success& success) {  // --help and --version
      return program.exit(success);
    } catch (const CLI::ParseError& error) {
      return fail(kBadInput, error.what());
    }
  } catch (const Failure& failure) {
    return fail(failure.status, failure.message);
  } catch (const std::bad_alloc&) {
    return fail(kBadInput, "The circles do not fit in memory.");
  } catch (const std::exception& error) {
    return fail(kFailure, error.what());
  }
  return kSuccess;
}
