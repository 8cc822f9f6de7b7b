// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <charconv>
#include <ostream>

namespace circle_voronoi::cli {

/// The shortest text of a finite number that reads back to the same bits.
template <class Number>
void writeNumber(std::ostream& out, Number value) {
  std::array<char, 32> digits;
  const auto [end, code] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  out.write(digits.data(), end - digits.data());
}

}  // namespace circle_voronoi::cli
