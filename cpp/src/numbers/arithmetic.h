// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cfloat>
#include <limits>

// The signs are proofs, and results have the same bits everywhere, only if each operation is rounded by itself to the
// nearest double. These checks stop a build that would break this, wherever the sources are used.

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__) || \
    (defined(__GCC_IEC_559) && !__GCC_IEC_559)
#error "circle_voronoi cannot be built with -ffast-math, -Ofast or a part of them: its results would be wrong."
#endif
static_assert(std::numeric_limits<double>::is_iec559 && FLT_RADIX == 2, "circle_voronoi needs IEEE 754 arithmetic.");
static_assert(FLT_EVAL_METHOD == 0,
              "circle_voronoi cannot be built with excess precision (-mfpmath=387): its results would be wrong.");

namespace circle_voronoi {

/// Returns whether arithmetic is standard, as far as no macro tells: operations are neither fused nor reordered,
/// rounding is to nearest, and tiny numbers are not flushed to zero. The last two depend on the running program: one
/// that is linked with -ffast-math, for instance, flushes tiny numbers to zero.
bool isArithmeticStandard();

}  // namespace circle_voronoi
