// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace circle_voronoi {

/// An index that is not kNone, for containers.
inline std::size_t at(std::ptrdiff_t index) { return static_cast<std::size_t>(index); }

}  // namespace circle_voronoi
