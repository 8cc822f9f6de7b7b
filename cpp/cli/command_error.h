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

/// The exit status of the program and one sentence that explains it. Commands throw it.
struct CommandError {
  ExitStatus status;
  std::string message;
};

/// Returns the message of an error of the library, which names options as on the command line.
inline std::string messageOf(const Error& error) {
  const auto& [name, offset, size] = error.option;
  if (name.empty()) return error.message;
  const std::string flag = name == "tolerance" ? "area-tolerance" : name == "maxSteps" ? "max-steps" : name;
  return error.message.substr(0, offset) + "--" + flag + error.message.substr(offset + size);
}

/// Throws CommandError with an error of the library, after `where`.
[[noreturn]] inline void fail(const Error& error, const std::string& where) {
  throw CommandError{
      error.code == ErrorCode::notCertified || error.code == ErrorCode::notConverged ? kFailure : kBadInput,
      where + messageOf(error)};
}

/// Throws CommandError if a writer failed, unless its stream failed: `writeText` reports failing streams, with the
/// reason.
inline void checkWritten(const Result<void>& written, const std::string& where) {
  if (!written && written.error().code != ErrorCode::notWritten) fail(written.error(), where);
}

}  // namespace circle_voronoi::cli
