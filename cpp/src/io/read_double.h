// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fast_float/fast_float.h>

#include <charconv>
#include <cmath>
#include <string_view>
#include <system_error>

namespace circle_voronoi {

/// std::from_chars for double, which libc++ has from version 20 on only, and macOS not at all.
inline std::from_chars_result readDouble(const char* first, const char* last, double& value) {
  double read = 0;
  const auto [stop, code] = fast_float::from_chars(first, last, read);
  if (code != std::errc()) return {stop, code};
  if (std::isinf(read) || read == 0) {
    // Older versions of fast_float return infinity or zero for a number beyond the range of a double.
    const std::string_view numeral(first, static_cast<std::size_t>(stop - first));
    const std::string_view mantissa = numeral.substr(0, numeral.find_first_of("eE"));
    const bool isInfinity = numeral.find_first_of("iI") != std::string_view::npos;
    if (!isInfinity && mantissa.find_first_of("123456789") != std::string_view::npos) {
      return {stop, std::errc::result_out_of_range};
    }
  }
  value = read;
  return {stop, code};
}

}  // namespace circle_voronoi
