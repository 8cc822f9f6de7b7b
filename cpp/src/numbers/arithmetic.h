// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cfloat>
#include <limits>

// The signs are proofs, and the bits the same everywhere, only where each operation is rounded by itself, to the
// nearest double. This stops a build that would have it otherwise, wherever the sources are taken.

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__) || \
    (defined(__GCC_IEC_559) && !__GCC_IEC_559)
#error "circle_voronoi cannot be built with -ffast-math, -Ofast or a part of them: its results would be wrong."
#endif
static_assert(std::numeric_limits<double>::is_iec559 && FLT_RADIX == 2, "circle_voronoi needs IEEE 754 arithmetic.");
static_assert(FLT_EVAL_METHOD == 0,
              "circle_voronoi cannot be built with excess precision (-mfpmath=387): its results would be wrong.");

namespace circle_voronoi {

/// Returns whether arithmetic is as it must be, as far as no macro tells: no operation is fused with another or put in
/// another order, rounding is to nearest, and tiny numbers are not taken for zero. The last two are up to the running
/// program: one that is linked with -ffast-math, for instance, has tiny numbers taken for zero.
bool isArithmeticStandard();

}  // namespace circle_voronoi
