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

/// The meaning of each exit status, for --help and the manual page.
inline constexpr std::array<ExitMeaning, 4> kExitMeanings = {
    {{kSuccess, "Success."},
     {kFailure, "A file cannot be read or written, a diagram is not certified, or a fit did not converge."},
     {kBadInput, "The circles, the diagram or the command line are invalid."},
     {kNotFinal, "Some circles of a tile's core are not final; everything that was written is final."}}};

/// Thrown by a command: the exit status of the program, and one sentence that says why.
struct Failure {
  ExitStatus status;
  std::string message;
};

/// Throws Failure with an error of the library, after `where`.
[[noreturn]] inline void fail(const Error& error, const std::string& where) {
  throw Failure{error.code == ErrorCode::notCertified || error.code == ErrorCode::notConverged ? kFailure : kBadInput,
                where + error.message};
}

/// Throws Failure if a writer failed, except if its stream did: `writeText` reports that, with the reason.
inline void checkWritten(const Result<void>& written, const std::string& where) {
  if (!written && written.error().code != ErrorCode::notWritten) fail(written.error(), where);
}

}  // namespace circle_voronoi::cli
