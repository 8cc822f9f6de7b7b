// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress_line.h"

namespace circle_voronoi::cli {

void addProgressOption(CLI::App& command, std::string& when) {
  command.add_option("--progress", when, "Show the progress on standard error; auto: on a terminal, after a second")
      ->type_name("WHEN")
      ->check(CLI::IsMember({"auto", "always", "never"}))
      ->capture_default_str();
}

}  // namespace circle_voronoi::cli
