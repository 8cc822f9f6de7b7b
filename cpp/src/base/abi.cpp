// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/abi.h"

namespace circle_voronoi {

#ifdef _GLIBCXX_DEBUG
const bool needs_a_library_built_with_GLIBCXX_DEBUG = true;
#else
const bool needs_a_library_built_without_GLIBCXX_DEBUG = true;
#endif

#if defined(_GLIBCXX_USE_CXX11_ABI) && !_GLIBCXX_USE_CXX11_ABI
const bool needs_a_library_built_without_GLIBCXX_USE_CXX11_ABI = true;
#else
const bool needs_a_library_built_with_GLIBCXX_USE_CXX11_ABI = true;
#endif

}  // namespace circle_voronoi
