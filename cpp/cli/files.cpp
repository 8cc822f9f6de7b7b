// SPDX-License-Identifier: GPL-3.0-or-later
#include "files.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <vector>

#include "failure.h"

namespace circle_voronoi::cli {
namespace {

Failure ioFailure(const std::string& what, const std::string& file) {
  const std::string name = file == kStandardStream ? "the standard stream" : file;
  const std::string reason = errno == 0 ? "" : std::string(": ") + std::strerror(errno);
  return {kFailure, "Cannot " + what + " " + name + reason + "."};
}

std::string readAll(std::istream& in, const std::string& file) {
  std::string text;
  std::vector<char> piece(1 << 16);
  do {
    in.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    text.append(piece.data(), static_cast<std::size_t>(in.gcount()));
  } while (in);
  if (in.bad()) throw ioFailure("read", file);
  return text;
}

void writeAll(std::ostream& out, const std::string& file, const std::function<void(std::ostream&)>& write) {
  write(out);
  out.flush();
  if (!out) throw ioFailure("write", file);
}

}  // namespace

std::string inputName(const std::string& file) { return file == kStandardStream ? "standard input" : file; }

std::string readText(const std::string& file) {
  errno = 0;
  if (file == kStandardStream) return readAll(std::cin, file);
  std::ifstream in(file, std::ios::binary);
  if (!in) throw ioFailure("read", file);
  return readAll(in, file);
}

void writeText(const std::string& file, const std::function<void(std::ostream&)>& write) {
  errno = 0;
  if (file == kStandardStream) return writeAll(std::cout, file, write);
  std::ofstream out(file, std::ios::binary);
  if (!out) throw ioFailure("write", file);
  writeAll(out, file, write);
}

}  // namespace circle_voronoi::cli
