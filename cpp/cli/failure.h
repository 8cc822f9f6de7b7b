// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace circle_voronoi::cli {

enum ExitStatus : int {
  kSuccess = 0,
  kFailure = 1,   ///< a file cannot be read or written, or the diagram could not be made
  kBadInput = 2,  ///< bad circles, or a bad command line
};

/// Thrown by a command: how the program ends, and one sentence why.
struct Failure {
  ExitStatus status;
  std::string message;
};

}  // namespace circle_voronoi::cli
