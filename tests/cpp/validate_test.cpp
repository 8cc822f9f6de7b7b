// SPDX-License-Identifier: GPL-3.0-or-later
#include "validate.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
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
  const auto rounded = validate(circles);
  ASSERT_TRUE(rounded.ok());
  const Circle& c = rounded.value()[0];
  for (const double value : {c.x, c.y, c.r}) EXPECT_EQ(std::bit_cast<std::uint64_t>(value), 0U);
}

TEST(Validate, RoundsToMultiplesOfTheStepWithTiesToEven) {
  const double step = kCoordinateStep;
  const auto of = [](double x) { return validate(std::vector<Circle>{{x, -x, 0}, {1, 0, 0}}).value()[0]; };
  for (const double x : {0x1p-44, 0x1.fffffffffffffp-44, 0x1.fffffffffffffp-3, 0.1, 1e-13, 1.0, 0x1p96, 3 * step}) {
    EXPECT_EQ(of(x), (Circle{x, -x, 0})) << x << " is a multiple of the step";
  }
  EXPECT_EQ(of(0.5 * step), (Circle{0, 0, 0}));
  EXPECT_EQ(of(std::nextafter(0.5 * step, 1)), (Circle{step, -step, 0}));
  EXPECT_EQ(of(1.5 * step), (Circle{2 * step, -2 * step, 0}));
  EXPECT_EQ(of(2.5 * step), (Circle{2 * step, -2 * step, 0}));
  EXPECT_EQ(of(2.75 * step), (Circle{3 * step, -3 * step, 0}));
  EXPECT_EQ(of(std::numeric_limits<double>::denorm_min()), (Circle{0, 0, 0}));
  // The largest number with a bit below the step.
  EXPECT_EQ(of(0x1.fffffffffffffp-45), (Circle{0x1p-44, -0x1p-44, 0}));
  EXPECT_EQ(std::bit_cast<std::uint64_t>(rounded(-0.25 * step)), std::bit_cast<std::uint64_t>(-0.0));
}

TEST(Validate, InputsBelowTheLeastAreAnErrorThatSaysByWhatToMultiply) {
  EXPECT_TRUE(validate(std::vector<Circle>{}).ok());
  EXPECT_TRUE(validate(std::vector<Circle>{{0, 0, 0}, {-0.0, 0, 0}}).ok());
  EXPECT_TRUE(validate(std::vector<Circle>{{0, -kSmallestInput, 0}}).ok());
  EXPECT_TRUE(validate(std::vector<Circle>{{1e-300, 0, 0}, {0, 0, kSmallestInput}}).ok());
  EXPECT_TRUE(validate(std::vector<Circle>{{1e-300, 0, 0}, {0, 0, -kSmallestInput}}, true).ok());
  const auto errorOf = [](double size) {
    return validate(std::vector<Circle>{{0, size, 0}, {-size / 2, 0, size / 4}}).error();
  };
  for (const double size : {std::nextafter(kSmallestInput, 0), 1e-17, 3e-20, 1e-300, 0x1p-1074}) {
    const Error error = errorOf(size);
    EXPECT_EQ(error.code, ErrorCode::coordinateTooSmall) << size;
    EXPECT_EQ(error.circle, kNone) << size;
    const std::string text = "Multiply them by 1e";
    const std::size_t at = error.message.find(text);
    ASSERT_NE(at, std::string::npos) << error.message;
    const int power = std::stoi(error.message.substr(at + text.size()));
    // Two factors, as the power may be beyond the doubles.
    const double product = size * std::pow(10.0, power / 2) * std::pow(10.0, power - power / 2);
    EXPECT_GE(product, 0.4) << error.message;
    EXPECT_LE(product, 20) << error.message;
  }
  EXPECT_EQ(errorOf(1e-20).message,
            "The circles are too small: all numbers are below 1.4e-17 (2^-56). Multiply them by 1e20.");
}

TEST(Validate, APartOfAnInputMayBeSmall) {
  const std::vector<Circle> circles = {{0, 1e-30, 0}};
  EXPECT_TRUE(validatePart(circles, false, 7).ok());
  const auto invalid = validatePart(std::vector<Circle>{{0, 0, 0}, {0, 0, -1}}, false, 7);
  ASSERT_FALSE(invalid.ok());
  EXPECT_EQ(invalid.error().circle, 8);
}

}  // namespace
}  // namespace circle_voronoi
