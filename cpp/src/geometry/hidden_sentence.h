// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace circle_voronoi {

/// Returns the sentence of `hiddenWarning`, or an empty text. `unit` says which unit radii may have by mistake.
std::string hiddenSentence(std::size_t hidden, std::size_t count, std::string_view unit);

}  // namespace circle_voronoi
