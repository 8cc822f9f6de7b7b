// SPDX-License-Identifier: GPL-3.0-or-later
#include "files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <optional>
#include <ostream>
#include <vector>

#include "command_error.h"
#include "output_file.h"

namespace circle_voronoi::cli {
namespace {

CommandError ioError(const std::string& what, const std::string& file, int error) {
  const std::string name = file == kStandardStream ? "the standard stream" : file;
  return {kFailure, "Cannot " + what + " " + name + ": " + std::strerror(error) + "."};
}

/// The largest size of a line, in bytes. A longer line would fill the memory: a device such as /dev/zero never ends a
/// line.
constexpr std::size_t kLongestLine = std::size_t{1} << 31;

/// A file or standard input, open for reading.
class Input {
 public:
  explicit Input(const std::string& file)
      : file_(file), descriptor_(file == kStandardStream ? STDIN_FILENO : open(file.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (descriptor_ == -1) throw ioError("read", file, errno);
  }
  Input(const Input&) = delete;
  Input& operator=(const Input&) = delete;
  ~Input() {
    if (descriptor_ != STDIN_FILENO) close(descriptor_);
  }

  /// The size of a regular file, or 0.
  std::size_t size() const {
    struct stat status {};
    const bool isFile = fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode);
    return isFile ? static_cast<std::size_t>(status.st_size) : 0;
  }

  /// The next piece, which is valid up to the next call; empty at the end.
  std::string_view next() {
    for (;;) {
      const ssize_t size = read(descriptor_, piece_.data(), piece_.size());
      if (size >= 0) return {piece_.data(), static_cast<std::size_t>(size)};
      if (errno != EINTR) throw ioError("read", file_, errno);
    }
  }

 private:
  std::string file_;
  int descriptor_;
  std::vector<char> piece_ = std::vector<char>(1 << 20);
};

/// The status of the file behind a name; nothing if there is no such file.
std::optional<struct stat> statusOf(const std::string& file, int standardStream) {
  struct stat status {};
  const bool exists = (file == kStandardStream ? fstat(standardStream, &status) : stat(file.c_str(), &status)) == 0;
  return exists ? std::optional(status) : std::nullopt;
}

bool isOneFile(const std::optional<struct stat>& a, const std::optional<struct stat>& b) {
  return a && b && S_ISREG(a->st_mode) && a->st_dev == b->st_dev && a->st_ino == b->st_ino;
}

bool areOneOutput(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return false;
  if (a == kStandardStream && b == kStandardStream) return true;
  const auto statusOfA = statusOf(a, STDOUT_FILENO);
  const auto statusOfB = statusOf(b, STDOUT_FILENO);
  if (statusOfA || statusOfB) return isOneFile(statusOfA, statusOfB);
  return pathToWrite(a) == pathToWrite(b);
}

void writeTo(int descriptor, const std::string& file, const std::function<void(std::ostream&)>& write) {
  DescriptorBuffer buffer(descriptor);
  std::ostream out(&buffer);
  write(out);
  if (buffer.error() != 0) throw ioError("write", file, buffer.error());
}

}  // namespace

std::string inputName(const std::string& file) { return file == kStandardStream ? "standard input" : file; }

std::string readText(const std::string& file) {
  Input input(file);
  std::string text;
  text.reserve(input.size());
  std::size_t lineSize = 0;
  for (auto piece = input.next(); !piece.empty(); piece = input.next()) {
    const std::size_t lineEnd = piece.rfind('\n');
    lineSize = lineEnd == piece.npos ? lineSize + piece.size() : piece.size() - lineEnd - 1;
    if (lineSize > kLongestLine) {
      throw CommandError{kBadInput, inputName(file) + ": a line is longer than 2 GiB, which no file of circles has."};
    }
    text += piece;
  }
  return text;
}

void readPieces(const std::string& file, const std::function<void(std::string_view piece, double done)>& take) {
  Input input(file);
  const auto size = static_cast<double>(input.size());
  double done = 0;
  for (auto piece = input.next(); !piece.empty(); piece = input.next()) {
    done += static_cast<double>(piece.size());
    take(piece, size > 0 ? done / size : 0);
  }
}

void refuseSharedFiles(std::initializer_list<std::string> inputs, std::initializer_list<NamedOutput> outputs) {
  for (const NamedOutput& output : outputs) {
    for (const std::string& input : inputs) {
      if (isOneFile(statusOf(input, STDIN_FILENO), statusOf(output.file, STDOUT_FILENO))) {
        throw CommandError{kBadInput, inputName(input) + " would be overwritten: it is the output as well."};
      }
    }
    for (const NamedOutput* other = outputs.begin(); other != &output; ++other) {
      if (!areOneOutput(other->file, output.file)) continue;
      const std::string name = output.file == kStandardStream ? "standard output" : output.file;
      throw CommandError{kBadInput, output.option + " and " + other->option + " cannot both be " + name + "."};
    }
  }
}

void writeText(const std::string& file, const std::function<void(std::ostream&)>& write) {
  if (file == kStandardStream) return writeTo(STDOUT_FILENO, file, write);
  OutputFile output(file);
  const auto descriptor = output.open();
  if (!descriptor) throw ioError("write", file, errno);
  writeTo(*descriptor, file, write);
  if (!output.finish()) throw ioError("write", file, errno);
}

}  // namespace circle_voronoi::cli
