// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>  // the standard library's own macros

// The properties that a program and the library must have in common. Every public header includes this one.

/// Makes a function or a class visible outside a shared library. Clang ignores this attribute on a namespace for
/// functions.
#ifdef __GNUC__
#define CIRCLE_VORONOI_API __attribute__((visibility("default")))
#else
#define CIRCLE_VORONOI_API
#endif

namespace circle_voronoi {

// If a program and the library lay out the containers and strings of the standard library differently, each would read
// garbage from the other. Each source that includes this header therefore refers to a constant that only a matching
// library defines. If the library does not match, the linker reports the constant as missing, and the constant's name
// states the problem.

#ifdef _GLIBCXX_DEBUG
CIRCLE_VORONOI_API extern const bool needs_a_library_built_with_GLIBCXX_DEBUG;
[[gnu::used]] inline const bool& sameContainers = needs_a_library_built_with_GLIBCXX_DEBUG;
#else
CIRCLE_VORONOI_API extern const bool needs_a_library_built_without_GLIBCXX_DEBUG;
[[gnu::used]] inline const bool& sameContainers = needs_a_library_built_without_GLIBCXX_DEBUG;
#endif

#if defined(_GLIBCXX_USE_CXX11_ABI) && !_GLIBCXX_USE_CXX11_ABI
CIRCLE_VORONOI_API extern const bool needs_a_library_built_without_GLIBCXX_USE_CXX11_ABI;
[[gnu::used]] inline const bool& sameStrings = needs_a_library_built_without_GLIBCXX_USE_CXX11_ABI;
#else
CIRCLE_VORONOI_API extern const bool needs_a_library_built_with_GLIBCXX_USE_CXX11_ABI;
[[gnu::used]] inline const bool& sameStrings = needs_a_library_built_with_GLIBCXX_USE_CXX11_ABI;
#endif

}  // namespace circle_voronoi
