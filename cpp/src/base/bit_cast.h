// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace circle_voronoi {

/// std::bit_cast, which Emscripten's standard library lacks.
template <class To, class From>
constexpr To bitCast(const From& from) {
  return __builtin_bit_cast(To, from);
}

}  // namespace circle_voronoi
