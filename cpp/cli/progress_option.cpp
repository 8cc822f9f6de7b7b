// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress_line.h"

namespace circle_voronoi::cli {

void addProgressOption(CLI::App& command, std::string& when) {
  command
      .add_option("--progress", when,
                  "Show on standard error how far the work is; auto: on a terminal, if it takes more than a second")
      ->type_name("WHEN")
      ->check(CLI::IsMember({"auto", "always", "never"}))
      ->capture_default_str();
}

}  // namespace circle_voronoi::cli
