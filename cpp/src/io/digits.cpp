// SPDX-License-Identifier: GPL-3.0-or-later
#include "digits.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace circle_voronoi {
namespace {

/// The largest power of ten that a double holds exactly.
constexpr int kMostPlaces = 22;
constexpr std::array<double, kMostPlaces + 1> kPowers = [] {
  std::array<double, kMostPlaces + 1> powers{1};
  for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = 10 * powers[i - 1];
  return powers;
}();
/// Up to this limit, whole numbers are doubles, and different ones stay different when divided by a power of ten.
constexpr double kMostSteps = 1e15;

/// Decimals of up to six places are common, and quick to write.
constexpr double kCommonSteps = 1e6;

/// "00", "01" and so on to "99".
constexpr std::array<char, 200> kPairs = [] {
  std::array<char, 200> pairs{};
  for (std::size_t i = 0; i < pairs.size(); i += 2) {
    pairs[i] = static_cast<char>('0' + i / 20);
    pairs[i + 1] = static_cast<char>('0' + i / 2 % 10);
  }
  return pairs;
}();

/// A decimal of up to fifteen digits is the shortest that reads back to its double. Writes a value of few places, or
/// returns nullptr for other values.
char* writeCommon(char* to, double value) {
  const double steps = value * kCommonSteps;
  if (!(std::abs(steps) < kMostSteps)) return nullptr;
  auto whole = static_cast<std::int64_t>(steps + (steps < 0 ? -0.5 : 0.5));
  if (static_cast<double>(whole) / kCommonSteps != value || whole == 0) return nullptr;
  if (whole < 0) {
    *to++ = '-';
    whole = -whole;
  }
  constexpr auto kUnit = static_cast<std::int64_t>(kCommonSteps);
  to = std::to_chars(to, to + kMostDigits, whole / kUnit).ptr;
  const auto places = static_cast<std::uint32_t>(whole % kUnit);
  if (places == 0) return to;
  *to++ = '.';
  // In pairs, up to the last that is not zero.
  const std::array pairs = {places / 10'000, places / 100 % 100, places % 100};
  const std::size_t count = pairs[2] != 0 ? 3 : pairs[1] != 0 ? 2 : 1;
  for (std::size_t i = 0; i < count; ++i, to += 2) std::memcpy(to, &kPairs[2 * pairs[i]], 2);
  return to[-1] == '0' ? to - 1 : to;
}

}  // namespace

char* writeDigits(char* to, double value) {
  if (char* end = writeCommon(to, value)) return end;
  // Plain to_chars gives the same digits, but takes half as long again.
  std::array<char, kMostDigits> digits{};
  char* const end =
      std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::scientific).ptr;
  char* from = digits.data();
  char* const mark = std::find(from, end, 'e');
  const auto copy = [&to](const char* begin, const char* stop) {
    std::memcpy(to, begin, static_cast<std::size_t>(stop - begin));
    to += stop - begin;
  };
  int exponent = 0;
  if (mark != end) std::from_chars(mark[1] == '+' ? mark + 2 : mark + 1, end, exponent);
  constexpr int kLeast = -4;
  constexpr int kMost = 15;
  if (mark == end || value == 0 || exponent < kLeast || exponent > kMost) {
    // Not a finite number, zero, or a number with an exponent.
    copy(from, value == 0 ? from + (*from == '-' ? 2 : 1) : end);
    return to;
  }
  if (*from == '-') *to++ = *from++;
  // The digits without their point.
  const char first = *from;
  const auto count = std::max<std::ptrdiff_t>(mark - from - 1, 1);
  from[mark - from > 1 ? 1 : 0] = first;
  const char* all = mark - from > 1 ? from + 1 : from;
  if (exponent < 0) {
    constexpr const char* kZeros = "0.0000";
    copy(kZeros, kZeros + (1 - exponent));
    copy(all, all + count);
  } else if (count <= exponent + 1) {
    copy(all, all + count);
    for (std::ptrdiff_t i = count; i < exponent + 1; ++i) *to++ = '0';
  } else {
    copy(all, all + exponent + 1);
    *to++ = '.';
    copy(all + exponent + 1, all + count);
  }
  return to;
}

DecimalGrid::DecimalGrid(double step) {
  const auto& powers = kPowers;
  if (!(step >= 1 / powers.back())) return;
  isOff_ = false;
  if (step >= 1) {
    divisor_ = *(std::upper_bound(powers.begin(), powers.end(), step) - 1);
  } else {
    multiplier_ = *std::find_if(powers.begin(), powers.end(), [&](double power) { return 1 / power <= step; });
  }
  error_ = divisor_ / multiplier_;
}

DecimalGrid::DecimalGrid(std::optional<int> digits)
    : DecimalGrid(digits && *digits <= kMostPlaces ? 1 / kPowers[static_cast<std::size_t>(*digits)] : 0) {}

double DecimalGrid::round(double value) const {
  const double steps = std::round(value * multiplier_ / divisor_);
  if (isOff_ || !(std::abs(steps) < kMostSteps)) return value;
  return steps * divisor_ / multiplier_ + 0.0;  // -0 becomes 0
}

}  // namespace circle_voronoi
