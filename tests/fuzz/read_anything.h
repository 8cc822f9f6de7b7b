// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace circle_voronoi::fuzz {

/// Gives any text to the readers, which must not crash, and to what takes their results:
/// - an error is one line that begins with the name and a line of the text;
/// - circles that were read come back to the bit from every format they are written in;
/// - a diagram that was read can be judged, whatever is in it, and comes back from JSON to the bit.
/// Returns the violated statement, or none.
std::optional<std::string> readAnything(std::string_view text);

}  // namespace circle_voronoi::fuzz
