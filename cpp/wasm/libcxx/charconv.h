// SPDX-License-Identifier: GPL-3.0-or-later
// std::to_chars for double, which <charconv> has from version 14 of libc++ on.
#pragma once
#include <charconv>

#if _LIBCPP_VERSION < 14000
#include <dragonbox/dragonbox.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>

namespace std {

/// Only `scientific`, with the shortest digits that read back to the same bits. Precondition: there is room.
inline to_chars_result to_chars(char* to, char* last, double value, chars_format) {
  const auto put = [&](string_view text) { to += text.copy(to, static_cast<size_t>(last - to)); };
  if (signbit(value)) put("-");
  if (!isfinite(value)) {
    put(isnan(value) ? "nan" : "inf");
    return {to, errc()};
  }
  if (value == 0) {
    put("0e+00");
    return {to, errc()};
  }
  const auto decimal = ::jkj::dragonbox::to_decimal(value, ::jkj::dragonbox::policy::sign::ignore);
  array<char, 20> digits{};
  const char* const end = to_chars(digits.data(), digits.data() + digits.size(), decimal.significand).ptr;
  const auto count = static_cast<size_t>(end - digits.data());
  put({digits.data(), 1});
  if (count > 1) put(".");
  put({digits.data() + 1, count - 1});
  const int exponent = decimal.exponent + static_cast<int>(count) - 1;
  put(exponent < 0 ? "e-" : "e+");
  if (abs(exponent) < 10) put("0");
  return to_chars(to, last, abs(exponent));
}

/// The shorter of `scientific` and the plain digits.
inline to_chars_result to_chars(char* to, char* last, double value) {
  array<char, 32> text{};
  char* const end = to_chars(text.data(), text.data() + text.size(), value, chars_format::scientific).ptr;
  const string_view scientific(text.data(), static_cast<size_t>(end - text.data()));
  const auto copy = [&](string_view what) {
    return to_chars_result{to + what.copy(to, static_cast<size_t>(last - to)), errc()};
  };
  const size_t mark = scientific.find('e');
  if (mark == string_view::npos) return copy(scientific);
  const size_t sign = scientific.front() == '-' ? 1 : 0;
  string digits(1, scientific[sign]);
  if (mark > sign + 2) digits += scientific.substr(sign + 2, mark - sign - 2);
  int exponent = 0;
  from_chars(scientific.data() + mark + (scientific[mark + 1] == '+' ? 2 : 1), scientific.data() + scientific.size(),
             exponent);
  const auto count = static_cast<int>(digits.size());
  // Beyond these the plain digits are longer.
  if (exponent < -8 || exponent > 21 + 1) return copy(scientific);
  string plain;
  if (exponent < 0) {
    plain = "0." + string(static_cast<size_t>(-exponent - 1), '0') + digits;
  } else if (count <= exponent + 1) {
    // All digits of a whole number, not only the shortest unique ones.
    auto whole = static_cast<unsigned __int128>(abs(value));
    do plain.insert(plain.begin(), static_cast<char>('0' + static_cast<int>(whole % 10)));
    while ((whole /= 10) != 0);
  } else {
    plain =
        digits.substr(0, static_cast<size_t>(exponent) + 1) + "." + digits.substr(static_cast<size_t>(exponent) + 1);
  }
  if (sign == 1) plain.insert(plain.begin(), '-');
  return copy(plain.size() <= scientific.size() ? string_view(plain) : scientific);
}

}  // namespace std
#endif
