// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the program that differ in Node: the progress line, which web/cli writes from another thread, and the
// permissions of new files.
#include <sys/stat.h>

#include <memory>
#include <string>
#include <string_view>

#include "progress_line.h"

// node_files.js.
extern "C" {
unsigned circle_voronoi_umask();
int circle_voronoi_show_line(const char* when);
void circle_voronoi_show_stage(const char* stage, std::size_t size, double done);
void circle_voronoi_end_line();
}

namespace circle_voronoi::cli {
namespace {

// Emscripten's own umask is not the umask of the process.
[[maybe_unused]] const mode_t kPrevious = umask(circle_voronoi_umask());

}  // namespace

class ProgressLine::Shown {};

ProgressLine::ProgressLine(const std::string& when) {
  if (circle_voronoi_show_line(when.c_str()) != 0) shown_ = std::make_unique<Shown>();
}

ProgressLine::~ProgressLine() { end(); }

void ProgressLine::show(std::string_view stage, double done) {
  if (shown_) circle_voronoi_show_stage(stage.data(), stage.size(), done);
}

void ProgressLine::end() {
  if (!shown_) return;
  shown_.reset();
  circle_voronoi_end_line();
}

}  // namespace circle_voronoi::cli
