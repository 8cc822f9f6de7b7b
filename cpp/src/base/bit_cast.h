// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstring>

namespace circle_voronoi {

/// std::bit_cast, which Emscripten's standard library lacks.
template <class To, class From>
To bitCast(const From& from) {
  static_assert(sizeof(To) == sizeof(From));
  To to;
  std::memcpy(&to, &from, sizeof(to));
  return to;
}

/// Returns the largest power of two up to x, for a normal number x > 0; 0 for zero and smaller numbers.
inline double leadingBit(double x) { return bitCast<double>(bitCast<std::uint64_t>(x) & 0x7ff0000000000000u); }

}  // namespace circle_voronoi
