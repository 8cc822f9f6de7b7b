// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace circle_voronoi {

/// std::bit_cast, which Emscripten's standard library lacks.
template <class To, class From>
constexpr To bitCast(const From& from) {
  return __builtin_bit_cast(To, from);
}

/// Returns the largest power of two up to x, for a normal number x > 0; 0 for zero and smaller numbers.
inline double leadingBit(double x) { return bitCast<double>(bitCast<std::uint64_t>(x) & 0x7ff0000000000000u); }

}  // namespace circle_voronoi
