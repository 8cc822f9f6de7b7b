// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The library uses these extensions of GCC and Clang, and no others. Other compilers, and builds with the option
// CIRCLE_VORONOI_PORTABLE, use standard C++ instead. The results have the same bits.

#if defined(__GNUC__) && !defined(CIRCLE_VORONOI_PORTABLE)
#define CIRCLE_VORONOI_HAS_EXTENSIONS 1
#else
#define CIRCLE_VORONOI_HAS_EXTENSIONS 0
#endif

#if CIRCLE_VORONOI_HAS_EXTENSIONS
#define CIRCLE_VORONOI_ALWAYS_INLINE [[gnu::always_inline]]
#define CIRCLE_VORONOI_NEVER_INLINE [[gnu::noinline]]
/// Marks a function that rarely runs. Compilers do not inline it, and place it apart from other code.
#define CIRCLE_VORONOI_COLD [[gnu::noinline, gnu::cold]]
#else
#define CIRCLE_VORONOI_ALWAYS_INLINE
#define CIRCLE_VORONOI_NEVER_INLINE
#define CIRCLE_VORONOI_COLD
#endif

// Compilers for processors of 32 bits have no integers of 128 bits.
#if CIRCLE_VORONOI_HAS_EXTENSIONS && defined(__SIZEOF_INT128__)
namespace circle_voronoi {
__extension__ using Int128 = __int128;
__extension__ using UnsignedInt128 = unsigned __int128;
}  // namespace circle_voronoi
#else
#include "wide_integer.h"
namespace circle_voronoi {
using Int128 = WideInteger<true>;
using UnsignedInt128 = WideInteger<false>;
}  // namespace circle_voronoi
#endif

namespace circle_voronoi {

/// Asks for an item's memory, which is read soon. Inlined, because a compiler may drop calls of a function that only
/// prefetches.
CIRCLE_VORONOI_ALWAYS_INLINE inline void prefetch([[maybe_unused]] const void* item) {
#if CIRCLE_VORONOI_HAS_EXTENSIONS
  __builtin_prefetch(item);
#endif
}

}  // namespace circle_voronoi
