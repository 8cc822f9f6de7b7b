// SPDX-License-Identifier: GPL-3.0-or-later
#include "output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace circle_voronoi::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNameBeside = ".circle-voronoi-XXXXXX";
constexpr int kMostLinks = 40;

/// The path of the temporary file, for the signal handler; empty if there is none.
char besidePath[PATH_MAX] = "";  // NOLINT: a signal handler sees only globals

void removeAndDie(int signal) {
  if (besidePath[0] != '\0') unlink(besidePath);
  raise(signal);  // delivered when this handler returns
}

/// Removes the temporary file when the program is interrupted, unless the signal is ignored.
void removeWhenInterrupted() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    if (sigaction(signal, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) continue;
    action.sa_handler = removeAndDie;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(signal, &action, nullptr);
  }
}

/// The target of symbolic links: a path, or a file descriptor of this program, as with /dev/stdout.
struct Target {
  fs::path path;
  std::optional<int> descriptor;
};

Target followed(fs::path path) {
  std::error_code error;
  const fs::path descriptors = fs::canonical("/proc/self/fd", error);
  for (int i = 0; i < kMostLinks && fs::is_symlink(path, error); ++i) {
    const fs::path folder = fs::canonical(path.has_parent_path() ? path.parent_path() : ".", error);
    if (!folder.empty() && folder == descriptors) return {path, std::stoi(path.filename())};
    path = folder / fs::read_symlink(path, error);
  }
  return {path, std::nullopt};
}

mode_t permissionsOfNewFiles() {
  const mode_t mask = umask(0);
  umask(mask);
  return 0666 & ~mask;
}

}  // namespace

fs::path pathToWrite(const std::string& file) {
  const fs::path path = fs::absolute(followed(file).path);
  std::error_code error;
  const fs::path canonical = fs::weakly_canonical(path, error);
  return error ? path : canonical;
}

std::streamsize DescriptorBuffer::xsputn(const char* text, std::streamsize size) {
  std::streamsize done = 0;
  while (done < size && error_ == 0) {
    const ssize_t written = ::write(descriptor_, text + done, static_cast<std::size_t>(size - done));
    if (written >= 0) {
      done += written;
    } else if (errno != EINTR) {
      error_ = errno;
    }
  }
  return done;
}

DescriptorBuffer::int_type DescriptorBuffer::overflow(int_type character) {
  const char c = traits_type::to_char_type(character);
  return xsputn(&c, 1) == 1 ? character : traits_type::eof();
}

OutputFile::~OutputFile() {
  if (descriptor_ != -1) close(descriptor_);
  if (!isBeside_) return;
  unlink(besidePath);
  besidePath[0] = '\0';
}

std::optional<int> OutputFile::open() {
  const auto [path, descriptor] = followed(file_);
  struct stat existing {};
  const bool exists = stat(file_.c_str(), &existing) == 0;
  if (descriptor) {
    // A new file description would have its own write position.
    descriptor_ = dup(*descriptor);
  } else if (exists && !S_ISREG(existing.st_mode)) {
    descriptor_ = ::open(file_.c_str(), O_WRONLY | O_CLOEXEC);
  } else {
    file_ = path.string();
    if (exists && access(file_.c_str(), W_OK) != 0) return std::nullopt;
    if (!openBeside(exists ? &existing : nullptr)) return std::nullopt;
  }
  return descriptor_ == -1 ? std::nullopt : std::optional(descriptor_);
}

bool OutputFile::openBeside(const struct stat* existing) {
  const std::string beside = (fs::path(file_).parent_path() / kNameBeside).string();
  if (beside.size() >= sizeof besidePath) {
    errno = ENAMETOOLONG;
    return false;
  }
  removeWhenInterrupted();
  std::memcpy(besidePath, beside.c_str(), beside.size() + 1);
  descriptor_ = mkostemp(besidePath, O_CLOEXEC);
  if (descriptor_ == -1) {
    besidePath[0] = '\0';
    return false;
  }
  isBeside_ = true;
  if (existing != nullptr) {
    // Only root can change the owner of a file, and other users need not.
    [[maybe_unused]] const int given = fchown(descriptor_, existing->st_uid, existing->st_gid);
  }
  return fchmod(descriptor_, existing != nullptr ? existing->st_mode & 07777 : permissionsOfNewFiles()) == 0;
}

bool OutputFile::finish() {
  const int descriptor = descriptor_;
  descriptor_ = -1;
  if (close(descriptor) != 0) return false;
  if (!isBeside_) return true;
  if (std::rename(besidePath, file_.c_str()) != 0) return false;
  isBeside_ = false;
  besidePath[0] = '\0';
  return true;
}

}  // namespace circle_voronoi::cli
