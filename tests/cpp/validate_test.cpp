// SPDX-License-Identifier: GPL-3.0-or-later
#include "validate.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "circle_voronoi/compute.h"

namespace circle_voronoi {
namespace {

TEST(Validate, TheLimitItselfIsAccepted) {
  const double beyond = std::nextafter(kCoordinateLimit, std::numeric_limits<double>::infinity());
  for (const double sign : {1.0, -1.0}) {
    EXPECT_TRUE(validate(std::vector<Circle>{{sign * kCoordinateLimit, 0, 0}}).ok());
    EXPECT_TRUE(validate(std::vector<Circle>{{0, sign * kCoordinateLimit, kCoordinateLimit}}).ok());
    EXPECT_EQ(validate(std::vector<Circle>{{sign * beyond, 0, 0}}).error().code, ErrorCode::coordinateTooLarge);
    EXPECT_EQ(validate(std::vector<Circle>{{0, sign * beyond, 0}}).error().code, ErrorCode::coordinateTooLarge);
  }
  EXPECT_EQ(validate(std::vector<Circle>{{0, 0, beyond}}).error().code, ErrorCode::coordinateTooLarge);
}

TEST(Validate, MinusZeroIsZero) {
  const std::vector<Circle> circles = {{-0.0, -0.0, -0.0}, {1, 1, 1}};
  const auto scaled = validate(circles);
  ASSERT_TRUE(scaled.ok());
  const Circle& c = scaled.value().circles[0];
  for (const double value : {c.x, c.y, c.r}) EXPECT_EQ(std::bit_cast<std::uint64_t>(value), 0U);
}

TEST(Validate, ScalesTheLargestNumberToTwoToThe80) {
  for (const double size : {1.0, 3.0, 1e150, 1e-300, std::numeric_limits<double>::denorm_min()}) {
    const auto scaled = validate(std::vector<Circle>{{size, 0, 0}, {0, -size / 2, size / 4}});
    ASSERT_TRUE(scaled.ok());
    const auto& [circles, unit] = scaled.value();
    EXPECT_EQ(circles[0].x * unit, size);
    EXPECT_LT(circles[0].x, 0x1p80);
    if (size > 1e-200) {
      EXPECT_GE(circles[0].x, 0x1p79);
    }
  }
}

}  // namespace
}  // namespace circle_voronoi
