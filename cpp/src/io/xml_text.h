// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "utf8.h"

namespace circle_voronoi {

/// Returns a printable line for XML, cut if it is long.
inline std::string xmlText(std::string_view text) {
  std::string result;
  for (const char c : printable(std::string(text))) {
    result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
  }
  return result;
}

}  // namespace circle_voronoi
