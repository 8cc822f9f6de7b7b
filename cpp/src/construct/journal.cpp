// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal.h"

#include <array>
#include <cstddef>

namespace circle_voronoi {
namespace {

struct StageEntry {
  std::string_view name;
  double Seconds::*seconds;
};

/// In the order of Stage.
constexpr std::array<StageEntry, 7> kStages = {{{"hide", &Seconds::hide},
                                                {"sample", &Seconds::sample},
                                                {"pair", &Seconds::pair},
                                                {"touch", &Seconds::touch},
                                                {"flip", &Seconds::flip},
                                                {"repair", &Seconds::repair},
                                                {"certify", &Seconds::certify}}};

}  // namespace

std::string_view stageName(Stage stage) { return kStages[static_cast<std::size_t>(stage)].name; }

double& Journal::secondsOf(Stage stage) { return stats.seconds.*kStages[static_cast<std::size_t>(stage)].seconds; }

}  // namespace circle_voronoi
