// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <initializer_list>
#include <iosfwd>
#include <string>
#include <string_view>

namespace circle_voronoi::cli {

/// The name of standard input and standard output on the command line.
inline constexpr const char* kStandardStream = "-";

/// The name of an input in errors.
std::string inputName(const std::string& file);

/// Returns the contents of a file or of standard input. Throws CommandError.
std::string readText(const std::string& file);

/// Passes a file or standard input to `take` piece by piece. `done` is the part that is read by then, or 0 if the size
/// is unknown. Throws CommandError.
void readPieces(const std::string& file, const std::function<void(std::string_view piece, double done)>& take);

/// An output file and the option that names it. An empty name means that the file is not requested.
struct NamedOutput {
  std::string option;
  std::string file;
};

/// Throws CommandError if an output is an input or another output, under any name: writing it would destroy the other
/// file. Files that are not regular may be both. Standard output may be only one output.
void refuseSharedFiles(std::initializer_list<std::string> inputs, std::initializer_list<NamedOutput> outputs);

/// Passes a stream to `write`, for standard output or for a file that is replaced when writing has succeeded
/// (output_file.h). Throws CommandError if writing fails.
void writeText(const std::string& file, const std::function<void(std::ostream&)>& write);

}  // namespace circle_voronoi::cli
