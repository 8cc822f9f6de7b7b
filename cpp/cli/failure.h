// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "circle_voronoi/error.h"

namespace circle_voronoi::cli {

enum ExitStatus : int {
  kSuccess = 0,
  kFailure = 1,
  kBadInput = 2,
  kNotFinal = 3,
};

struct ExitMeaning {
  ExitStatus status;
  std::string_view meaning;
};

/// What each exit status says, as --help and the manual page have it.
inline constexpr std::array<ExitMeaning, 4> kExitMeanings = {
    {{kSuccess, "All is well."},
     {kFailure, "A file cannot be read or written, or a diagram is not certified."},
     {kBadInput, "The circles, the diagram or the command line are wrong."},
     {kNotFinal, "Circles of a tile's core are not final; what is written is."}}};

/// Thrown by a command: how the program ends, and one sentence why.
struct Failure {
  ExitStatus status;
  std::string message;
};

/// Ends a command with what the library refuses, `where` before it.
[[noreturn]] inline void fail(const Error& error, const std::string& where) {
  throw Failure{error.code == ErrorCode::notCertified ? kFailure : kBadInput, where + error.message};
}

}  // namespace circle_voronoi::cli
