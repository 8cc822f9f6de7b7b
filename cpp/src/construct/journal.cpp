// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal.h"

#include <cstddef>

namespace circle_voronoi {

std::string_view stageName(Stage stage) { return kSecondsMembers[static_cast<std::size_t>(stage)].name; }

double& Journal::secondsOf(Stage stage) {
  return stats.seconds.*kSecondsMembers[static_cast<std::size_t>(stage)].member;
}

}  // namespace circle_voronoi
