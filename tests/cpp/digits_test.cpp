// SPDX-License-Identifier: GPL-3.0-or-later
#include "digits.h"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "random.h"

namespace circle_voronoi {
namespace {

std::string written(double value) {
  char digits[kMostDigits];
  return {digits, writeDigits(digits, value)};
}

double read(const std::string& text) {
  double value = 0;
  const auto [stop, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  EXPECT_TRUE(code == std::errc() && stop == text.data() + text.size()) << text;
  return value;
}

std::size_t countOfDigits(const std::string& text) {
  std::string digits;
  for (const char c : text.substr(0, text.find('e'))) {
    if (c >= '0' && c <= '9') digits += c;
  }
  const std::size_t first = digits.find_first_not_of('0');
  const std::size_t last = digits.find_last_not_of('0');
  return first == std::string::npos ? 0 : last - first + 1;
}

TEST(Digits, AreWrittenAsPeopleWriteThem) {
  EXPECT_EQ(written(0.0), "0");
  EXPECT_EQ(written(-0.0), "-0");
  EXPECT_EQ(written(1), "1");
  EXPECT_EQ(written(-4.5), "-4.5");
  EXPECT_EQ(written(0.005), "0.005");
  EXPECT_EQ(written(0.000001), "0.000001");
  EXPECT_EQ(written(-0.1), "-0.1");
  EXPECT_EQ(written(100000), "100000");
  EXPECT_EQ(written(123456789.25), "123456789.25");
  EXPECT_EQ(written(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(written(0.00012345678901), "0.00012345678901");
  EXPECT_EQ(written(1.0 / 3), "0.3333333333333333");
  EXPECT_EQ(written(1e15), "1000000000000000");
  EXPECT_EQ(written(1e16), "1e+16");
  EXPECT_EQ(written(1.5e300), "1.5e+300");
  EXPECT_EQ(written(1e-7), "1e-07");
  EXPECT_EQ(written(std::numeric_limits<double>::infinity()), "inf");
}

TEST(Digits, AreTheShortestThatReadBackToTheSameBits) {
  Random random(3);
  const auto expectSame = [](double value) {
    const std::string text = written(value);
    char digits[kMostDigits];
    const std::string shortest(digits,
                               std::to_chars(digits, digits + kMostDigits, value, std::chars_format::scientific).ptr);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(read(text)), std::bit_cast<std::uint64_t>(value)) << shortest;
    ASSERT_EQ(countOfDigits(text), countOfDigits(shortest)) << text << ' ' << shortest;
    ASSERT_LT(text.size(), kMostDigits);
  };
  for (int i = 0; i < 200'000; ++i) {
    const auto bits = (static_cast<std::uint64_t>(random.below(1ULL << 32)) << 32) | random.below(1ULL << 32);
    const auto value = std::bit_cast<double>(bits);
    if (std::isfinite(value)) expectSame(value);
    const auto whole = static_cast<double>(static_cast<std::int64_t>(bits >> 20));
    for (const double power : {1.0, 1e3, 1e6, 1e9}) expectSame((i % 2 == 0 ? whole : -whole) / power);
  }
}

TEST(Digits, RoundedNumbersHaveTheDecimalsOfTheGrid) {
  Random random(4);
  for (const double step : {5.0, 1.0, 0.99, 0.1, 0.02, 1e-3, 1e-9, 123.0, 1e6}) {
    const DecimalGrid grid(step);
    EXPECT_LE(grid.error(), step);
    EXPECT_GT(10 * grid.error(), step * (1 - 1e-15));
    for (int i = 0; i < 2000; ++i) {
      const double value = (static_cast<double>(random.below(2'000'001)) - 1e6) * 0.000123456789 * (1 + step);
      const double rounded = grid.round(value);
      EXPECT_LE(std::abs(rounded - value), 0.5000001 * grid.error());
      EXPECT_EQ(grid.round(rounded), rounded);
      const std::string text = written(rounded);
      const std::size_t point = text.find('.');
      const std::size_t places =
          point == std::string::npos || text.find('e') != std::string::npos ? 0 : text.size() - point - 1;
      EXPECT_LE(static_cast<double>(places), std::max(0.0, 0.5 - std::log10(grid.error()))) << text;
    }
  }
  EXPECT_EQ(DecimalGrid(0.1).round(-0.01), 0.0);
  EXPECT_FALSE(std::signbit(DecimalGrid(0.1).round(-0.01)));
  EXPECT_EQ(DecimalGrid(1e-30).round(0.1), 0.1) << "too fine";
  EXPECT_EQ(DecimalGrid(1).round(1e300 / 3), 1e300 / 3) << "too large";
  EXPECT_EQ(DecimalGrid(std::optional(1)).round(123456789012345.67), 123456789012345.67) << "too many steps";
}

}  // namespace
}  // namespace circle_voronoi
