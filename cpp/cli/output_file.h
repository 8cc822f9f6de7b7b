// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/stat.h>

#include <array>
#include <filesystem>
#include <optional>
#include <streambuf>
#include <string>

namespace circle_voronoi::cli {

/// A stream of bytes to a file descriptor. After an error, all further bytes are dropped.
class DescriptorBuffer : public std::streambuf {
 public:
  explicit DescriptorBuffer(int descriptor) : descriptor_(descriptor) {}

  /// The errno of the first write that failed, or 0.
  int error() const { return error_; }

 protected:
  std::streamsize xsputn(const char* text, std::streamsize size) override;
  int_type overflow(int_type character) override;

 private:
  int descriptor_;
  int error_ = 0;
};

/// Where a name leads, as one path for all names of a file, which need not be there yet.
std::filesystem::path pathToWrite(const std::string& file);

/// A file to be written as a whole or not at all: the text goes to another file beside it, which takes its place, with
/// its permissions, in `finish`. Otherwise, or if the program is interrupted, the other file is removed, and the former
/// file stays. Symbolic links are followed. A file that is not regular (a device, a pipe), or that is a file descriptor
/// of this program (/dev/stdout), is written directly.
///
/// There is one at a time. Functions that can fail set errno.
class OutputFile {
 public:
  explicit OutputFile(const std::string& file) : file_(file) {}
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  /// The descriptor to write to; nothing if the file cannot be written.
  std::optional<int> open();
  /// Whether the text is in the file.
  bool finish();

 private:
  bool openBeside(const struct stat* existing);

  std::string file_;
  int descriptor_ = -1;
  bool isBeside_ = false;
};

}  // namespace circle_voronoi::cli
