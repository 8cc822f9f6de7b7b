// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdio>
#include <string>

namespace circle_voronoi {

/// Returns the shortest text of a number that reads back to the same bits, in every locale.
inline std::string numberText(double value) {
  std::array<char, 32> digits{};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

/// Returns a number from 0 with two digits and an exponent, as "1.3e-07", in every locale.
inline std::string roughNumberText(double value) {
  std::array<char, 32> digits{};
  std::snprintf(digits.data(), digits.size(), "%.1e", value);
  const std::string text = digits.data();
  const std::size_t mark = text.find('e');
  // The decimal mark of the locale stands between the digits.
  return mark == text.npos ? text : text.substr(0, 1) + "." + text.substr(mark - 1);
}

}  // namespace circle_voronoi
