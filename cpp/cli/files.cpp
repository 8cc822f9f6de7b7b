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

#include "failure.h"
#include "output_file.h"

namespace circle_voronoi::cli {
namespace {

Failure ioFailure(const std::string& what, const std::string& file, int error) {
  const std::string name = file == kStandardStream ? "the standard stream" : file;
  return {kFailure, "Cannot " + what + " " + name + ": " + std::strerror(error) + "."};
}

std::string readAll(int descriptor, const std::string& file) {
  std::string text;
  struct stat status {};
  if (fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode))
    text.reserve(static_cast<std::size_t>(status.st_size));
  std::vector<char> piece(1 << 20);
  for (;;) {
    const ssize_t size = read(descriptor, piece.data(), piece.size());
    if (size == 0) return text;
    if (size > 0) {
      text.append(piece.data(), static_cast<std::size_t>(size));
    } else if (errno != EINTR) {
      throw ioFailure("read", file, errno);
    }
  }
}

/// What a name stands for; nothing if there is no such file.
std::optional<struct stat> statusOf(const std::string& file, int standardStream) {
  struct stat status {};
  const bool exists = (file == kStandardStream ? fstat(standardStream, &status) : stat(file.c_str(), &status)) == 0;
  return exists ? std::optional(status) : std::nullopt;
}

void writeTo(int descriptor, const std::string& file, const std::function<void(std::ostream&)>& write) {
  DescriptorBuffer buffer(descriptor);
  std::ostream out(&buffer);
  write(out);
  if (buffer.error() != 0) throw ioFailure("write", file, buffer.error());
}

}  // namespace

std::string inputName(const std::string& file) { return file == kStandardStream ? "standard input" : file; }

std::string readText(const std::string& file) {
  if (file == kStandardStream) return readAll(STDIN_FILENO, file);
  const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor == -1) throw ioFailure("read", file, errno);
  std::string text = readAll(descriptor, file);
  close(descriptor);
  return text;
}

void refuseOneFile(const std::string& input, const std::string& output) {
  const auto in = statusOf(input, STDIN_FILENO);
  const auto out = statusOf(output, STDOUT_FILENO);
  if (!in || !out || !S_ISREG(in->st_mode)) return;
  if (in->st_dev == out->st_dev && in->st_ino == out->st_ino) {
    throw Failure{kBadInput, inputName(input) + " would be overwritten: it is the output as well."};
  }
}

void writeText(const std::string& file, const std::function<void(std::ostream&)>& write) {
  if (file == kStandardStream) return writeTo(STDOUT_FILENO, file, write);
  OutputFile output(file);
  const auto descriptor = output.open();
  if (!descriptor) throw ioFailure("write", file, errno);
  writeTo(*descriptor, file, write);
  if (!output.finish()) throw ioFailure("write", file, errno);
}

}  // namespace circle_voronoi::cli
