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

/// Returns one path for all names of a file, which need not exist yet.
std::filesystem::path pathToWrite(const std::string& file);

/// A file that is written completely or not at all. The text goes to a temporary file in the same folder, which
/// replaces the file in `finish` and gets its permissions. Without `finish`, or if the program is interrupted, the
/// temporary file is removed, and the former file stays. Symbolic links are followed. A file that is not regular (a
/// device, a pipe), or that is a file descriptor of this program (/dev/stdout), is written directly.
///
/// There is one object at a time. Functions that can fail set errno.
class OutputFile {
 public:
  explicit OutputFile(const std::string& file) : file_(file) {}
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  /// The descriptor to write to; nothing if the file cannot be written.
  std::optional<int> open();
  /// Replaces the file. Returns whether the file has the text.
  bool finish();

 private:
  bool openBeside(const struct stat* existing);

  std::string file_;
  int descriptor_ = -1;
  bool isBeside_ = false;
};

}  // namespace circle_voronoi::cli
