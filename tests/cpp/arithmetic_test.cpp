// SPDX-License-Identifier: GPL-3.0-or-later
#include "arithmetic.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <vector>

#include "circle_voronoi/certify.h"
#include "circle_voronoi/compute.h"

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace circle_voronoi {
namespace {

/// The code of the error that `call` returns in the rounding mode given.
template <class Call>
ErrorCode errorWhenRounding(int mode, const Call& call) {
  std::fesetround(mode);
  const auto result = call();
  std::fesetround(FE_TONEAREST);
  EXPECT_FALSE(result.ok());
  return result.ok() ? ErrorCode::badInput : result.error().code;
}

// A build with -mfma, or for a processor that always has it, whose operations are fused fails here.
TEST(Arithmetic, IsStandardInThisBuild) { EXPECT_TRUE(isArithmeticStandard()); }

TEST(Arithmetic, OtherRoundingIsAnError) {
  const std::vector<Circle> circles = {{0, 0, 1}, {4, 0, 1}, {2, 1, 0}};
  const Result<Diagram> diagram = compute(circles);
  ASSERT_TRUE(diagram.ok());
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    EXPECT_EQ(errorWhenRounding(mode, [&] { return compute(circles); }), ErrorCode::badArithmetic);
    EXPECT_EQ(errorWhenRounding(mode, [&] { return certify(diagram.value()); }), ErrorCode::badArithmetic);
    EXPECT_EQ(errorWhenRounding(mode, [&] { return compute(circles, {.metric = Metric::power}); }),
              ErrorCode::badArithmetic);
  }
  EXPECT_TRUE(compute(circles).ok());
}

#ifdef __SSE2__
TEST(Arithmetic, TinyNumbersTakenForZeroAreAnError) {
  constexpr unsigned kFlushToZero = 0x8000;
  constexpr unsigned kDenormalsAreZero = 0x0040;
  for (const unsigned mode : {kFlushToZero, kDenormalsAreZero}) {
    const unsigned before = _mm_getcsr();
    _mm_setcsr(before | mode);
    const bool isStandard = isArithmeticStandard();
    _mm_setcsr(before);
    EXPECT_FALSE(isStandard) << mode;
  }
}
#endif

}  // namespace
}  // namespace circle_voronoi
