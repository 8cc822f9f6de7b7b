// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>  // the standard library's own macros

// What a program and the library must have in common. Every public header includes this.

/// The names of a namespace with this are seen from outside a shared library.
#define CIRCLE_VORONOI_API [[gnu::visibility("default")]]

namespace CIRCLE_VORONOI_API circle_voronoi {

// Containers and strings of the standard library that are laid out differently on both sides would be garbage to each
// other. So each source that includes this refers to a constant that only a library of the same kind has, and whose
// name says what is wrong where it is missing.

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
