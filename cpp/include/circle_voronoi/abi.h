// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>  // the standard library's own macros

// The properties that a program and the library must have in common. Every public header includes this one.

/// Makes the names of a namespace visible outside a shared library.
#define CIRCLE_VORONOI_API [[gnu::visibility("default")]]

namespace CIRCLE_VORONOI_API circle_voronoi {

// If a program and the library lay out the containers and strings of the standard library differently, each would read
// garbage from the other. Each source that includes this header therefore refers to a constant that only a matching
// library defines. If the library does not match, the linker reports the constant as missing, and the constant's name
// states the problem.

#ifdef _GLIBCXX_DEBUG
extern const bool needs_a_library_built_with_GLIBCXX_DEBUG;
[[gnu::used]] inline const bool& sameContainers = needs_a_library_built_with_GLIBCXX_DEBUG;
#else
extern const bool needs_a_library_built_without_GLIBCXX_DEBUG;
[[gnu::used]] inline const bool& sameContainers = needs_a_library_built_without_GLIBCXX_DEBUG;
#endif

#if defined(_GLIBCXX_USE_CXX11_ABI) && !_GLIBCXX_USE_CXX11_ABI
extern const bool needs_a_library_built_without_GLIBCXX_USE_CXX11_ABI;
[[gnu::used]] inline const bool& sameStrings = needs_a_library_built_without_GLIBCXX_USE_CXX11_ABI;
#else
extern const bool needs_a_library_built_with_GLIBCXX_USE_CXX11_ABI;
[[gnu::used]] inline const bool& sameStrings = needs_a_library_built_with_GLIBCXX_USE_CXX11_ABI;
#endif

}  // namespace circle_voronoi
