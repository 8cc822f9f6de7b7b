// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace circle_voronoi {

/// A fixed mixing of a number (splitmix64), in place of a random one.
inline std::uint64_t mix(std::uint64_t i) {
  i += 0x9e3779b97f4a7c15u;
  i = (i ^ (i >> 30)) * 0xbf58476d1ce4e5b9u;
  i = (i ^ (i >> 27)) * 0x94d049bb133111ebu;
  return i ^ (i >> 31);
}

}  // namespace circle_voronoi
